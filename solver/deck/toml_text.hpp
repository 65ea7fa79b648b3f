#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include <solver/base/point.hpp>

namespace pinball {

/// Values as TOML writes them; numbers such that the same bits are read again.
inline std::string toml(double value) {
  std::string text = fmt::format("{}", value);
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

/// Text of a scene that grows table by table.
class TomlText {
 public:
  void table(const char* name, const std::string& comment = "") { head(fmt::format("[{}]", name), comment); }
  void entry(const char* name, const std::string& comment = "") { head(fmt::format("[[{}]]", name), comment); }
  template <class Value>
  void key(const char* name, const Value& value) {
    text_ += fmt::format("{} = {}\n", name, toml(value));
  }
  void raw(const char* name, const std::string& value) { text_ += fmt::format("{} = {}\n", name, value); }
  void comment(const std::string& text) { text_ += "# " + text + '\n'; }
  const std::string& text() const { return text_; }

 private:
  void head(const std::string& line, const std::string& comment) {
    text_ += (text_.empty() ? "" : "\n") + line + (comment.empty() ? "" : "  # " + comment) + '\n';
  }
  std::string text_;
};

}  // namespace pinball
