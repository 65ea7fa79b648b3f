#include "keyword_scanner.hpp"

#include <algorithm>

#include <solver/formats/deck/indented_keyword.hpp>

#include "fields.hpp"

namespace pinball {

namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// Lines that end with "\r" alone end with "\n" after this; "\r\n" stays, and so does "\r\r\n".
void mend_line_ends(std::string& text) {
  for (std::size_t at = text.find('\r'); at != std::string::npos; at = text.find('\r', at)) {
    const std::size_t end = std::min(text.find_first_not_of('\r', at), text.size());
    if (end == text.size() || text[end] != '\n') {
      for (std::size_t i = at; i < end; ++i) text[i] = '\n';
    }
    at = end;
  }
}

}  // namespace

std::shared_ptr<const std::string> deck_text_of(std::string text) {
  if (text.starts_with(byte_order_mark)) text.erase(0, byte_order_mark.size());
  mend_line_ends(text);
  return std::make_shared<const std::string>(std::move(text));
}

bool take_ending(std::string& name, std::string_view ending) {
  if (!name.ends_with(ending) || name.size() == ending.size()) return false;
  name.resize(name.size() - ending.size());
  return true;
}

KeywordScanner::KeywordScanner(std::string_view text, const std::string& path, Widths widths)
    : rest_(text), place_{std::make_shared<const std::string>(path), 0}, widths_(widths) {
  skip_to_keyword();
}

std::string_view KeywordScanner::take_line() {
  const std::size_t end = rest_.find('\n');
  const std::string_view line = rest_.substr(0, end);
  rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
  ++place_.line;
  return line;
}

/// What stands before the first keyword: blank lines and comments alone.
void KeywordScanner::skip_to_keyword() {
  while (!rest_.empty() && rest_.front() != '*') {
    const std::string_view whole = take_line();
    refuse_indented_keyword(whole, '*', place_);
    const std::string_view line = trimmed(whole);
    if (!line.empty() && line.front() != '$')
      fail_at(place_, "expected a keyword such as *KEYWORD, got \"" + std::string(line.substr(0, 40)) + '"');
  }
}

bool KeywordScanner::next(KeywordBlock& block, std::string& after) {
  while (!rest_.empty()) {
    block = {};
    read_name(block, after);
    block.body = take_body();
    if (block.name == "END") return false;
    if (block.name != "KEYWORD") return true;
    read_formats(after, block.place);
  }
  return false;
}

void KeywordScanner::read_name(KeywordBlock& block, std::string& after) {
  const std::string_view line = take_line();
  block.place = place_;
  const std::size_t end = std::min(line.find_first_of(" \t\r,("), line.size());
  block.name = upper_case(line.substr(1, end - 1));
  after = upper_case(trimmed(line.substr(end)));
  const bool has_width = after.find_first_of("%+-") == 0 && (after.size() == 1 || after[1] == ' ');  // "*NODE %"
  if (has_width) {
    block.name += after[0];
    after = std::string(trimmed(after.substr(1)));
  }
  read_options(block);
}

/// "%" and "-" say how wide the columns of this keyword alone are; "_TITLE" and "_ID" that it begins with a card more.
void KeywordScanner::read_options(KeywordBlock& block) const {
  std::string& name = block.name;
  const bool standard = take_ending(name, "-");
  block.twenty = take_ending(name, "+") || (widths_.twenty && !standard);
  block.wide = take_ending(name, "%") || (widths_.wide && !standard);
  bool more = true;
  while (more) {
    more = false;
    if (take_ending(name, "_TITLE")) more = block.title = true;
    if (take_ending(name, "_ID")) more = block.id = true;
    if (name.starts_with("CONTACT_") && take_ending(name, "_MPP")) more = block.mpp = true;
  }
}

/// The lines up to the next keyword.
std::string_view KeywordScanner::take_body() {
  const std::string_view all = rest_;
  while (!rest_.empty() && rest_.front() != '*') {
    const std::string_view line = take_line();
    refuse_indented_keyword(line, '*', place_);
  }
  return all.substr(0, all.size() - rest_.size());
}

/// LONG=S and LONG=K: of what another program writes; what it reads is as ever.
void KeywordScanner::read_formats(const std::string& after, const DeckPlace& place) {
  std::string squeezed;
  for (const char c : after) {
    if (c != ' ' && c != '\t') squeezed += c;
  }
  const auto has = [&](const char* format) { return squeezed.find(format) != std::string::npos; };
  if (has("LONG=")) widths_.twenty = has("LONG=Y");
  if (has("LONG=") && !has("LONG=Y") && !has("LONG=S") && !has("LONG=K"))
    fail_at(place, "*KEYWORD: expected LONG=Y, LONG=S or LONG=K, got \"" + after + '"');
  if (has("I10=Y")) widths_.wide = true;
  if (has("I10=N")) widths_.wide = false;
}

}  // namespace pinball
