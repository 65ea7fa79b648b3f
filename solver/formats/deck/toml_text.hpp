#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <solver/base/point.hpp>

namespace pinball {

/// Values as TOML writes them; numbers such that the same bits are read again.
inline std::string toml(double value) {
  std::string text = fmt::format("{}", value);
  if (!std::isfinite(value)) return text;  // which the scene is refused for, where it stands
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}
inline std::string toml(std::int64_t value) { return fmt::format("{}", value); }
inline std::string toml(bool value) { return value ? "true" : "false"; }
inline std::string toml(const std::string& value) {
  std::string text = "\"";
  for (const char c : value) {
    if (c == '"' || c == '\\') text += '\\';
    if (static_cast<unsigned char>(c) >= 0x20 && c != 0x7f) text += c;
  }
  return text + '"';
}
inline std::string toml(const char* value) { return toml(std::string(value)); }
inline std::string toml(const Point& p) { return fmt::format("[{}, {}, {}]", toml(p[0]), toml(p[1]), toml(p[2])); }
template <class Value>
std::string toml(const std::vector<Value>& values) {
  std::string text = "[";
  for (std::size_t i = 0; i < values.size(); ++i) text += (i > 0 ? ", " : "") + toml(values[i]);
  return text + ']';
}

/// From which line on a scene says what a card of a deck says.
struct TextOrigin {
  std::size_t line = 1;
  std::string place, keyword;  ///< "deck.k:12", "*MAT_ELASTIC"; empty: no card
};

/// Text of a scene that grows table by table. A comment behind the name of a table that begins "*KEYWORD FILE:LINE"
/// says from which card the table is.
class TomlText {
 public:
  void table(const char* name, const std::string& comment = "") { head(fmt::format("[{}]", name), comment); }
  void entry(const char* name, const std::string& comment = "") { head(fmt::format("[[{}]]", name), comment); }
  template <class Value>
  void key(const char* name, const Value& value) {
    add_line(fmt::format("{} = {}", name, toml(value)));
  }
  void raw(const char* name, const std::string& value) { add_line(fmt::format("{} = {}", name, value)); }
  void comment(const std::string& text) { add_line("# " + text); }
  /// What follows is of this card.
  void from(const std::string& keyword, const std::string& place) { origins_.push_back({1 + lines_, place, keyword}); }
  void append(const TomlText& more) {
    add_line("");
    for (TextOrigin origin : more.origins_) {
      origin.line += lines_;
      origins_.push_back(origin);
    }
    text_ += more.text_;
    lines_ += more.lines_;
  }
  const std::string& text() const { return text_; }
  const std::vector<TextOrigin>& origins() const { return origins_; }

 private:
  void head(const std::string& line, const std::string& comment) {
    if (!text_.empty()) add_line("");
    const bool names_card = comment.starts_with('*') && comment.find(' ') != std::string::npos;
    const std::size_t blank = end_of_keyword(comment);
    from(names_card ? comment.substr(0, blank) : "", names_card ? first_place(comment.substr(blank + 1)) : "");
    add_line(line + (comment.empty() ? "" : "  # " + comment));
  }
  /// Without its end.
  void add_line(const std::string& line) {
    text_ += line;
    text_ += '\n';
    ++lines_;
  }
  /// The blank behind a keyword, which may be of several words.
  static std::size_t end_of_keyword(const std::string& comment) {
    std::size_t blank = std::min(comment.find(' '), comment.size());
    while (blank < comment.size()) {
      const std::size_t next = comment.find(' ', blank + 1);
      const bool word =
          std::ranges::all_of(comment.substr(blank + 1, next - blank - 1), [](char c) { return c >= 'A' && c <= 'Z'; });
      if (!word || next == std::string::npos) break;
      blank = next;
    }
    return blank;
  }
  /// Up to the line number: a remark may follow it.
  static std::string first_place(const std::string& text) {
    const std::size_t colon = text.find_first_of("0123456789", text.find(':'));
    return text.substr(0, text.find_first_not_of("0123456789", colon));
  }
  std::string text_;
  std::size_t lines_ = 0;  ///< of the text
  std::vector<TextOrigin> origins_;
};

}  // namespace pinball
