#include "radioss_block.hpp"

#include <fmt/format.h>

#include <algorithm>

#include <solver/formats/deck/number_text.hpp>

namespace pinball {

namespace {

/// Whether a line is of fields of numbers: a title begins in the first column, or has a word, or one number.
bool is_numbers(std::string_view line) {
  if (line.empty() || line.front() != ' ') return false;
  std::size_t count = 0;
  for (std::size_t at = line.find_first_not_of(' '); at != std::string_view::npos;
       at = line.find_first_not_of(' ', at)) {
    const std::size_t end = std::min(line.find(' ', at), line.size());
    if (!deck_number(line.substr(at, end - at))) return false;
    ++count;
    at = end;
  }
  return count > 1;
}

}  // namespace

std::int64_t RadiossBlock::id() const {
  if (numbers.empty()) fail_at(place, fmt::format("{}: expected a number behind the keyword", title));
  return numbers.front();
}

RadiossLines::RadiossLines(const RadiossBlock& block) : block_(&block), place_(block.place) {
  open(0);
  std::string_view line;
  if (!block.titled || !take(line)) return;
  if (is_numbers(line))
    fail_at(place_, fmt::format("{}: expected a line of its title, got numbers: \"{}\"", block.title, trimmed(line)));
  title_ = std::string(trimmed(line));
}

void RadiossLines::open(std::size_t segment) {
  segment_ = segment;
  if (segment_ >= block_->data.size()) return;
  rest_ = block_->data[segment_].text;
  place_ = block_->data[segment_].before;
}

bool RadiossLines::take(std::string_view& line) {
  while (segment_ < block_->data.size()) {
    if (rest_.empty()) {
      open(segment_ + 1);
      continue;
    }
    const std::size_t end = rest_.find('\n');
    line = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    ++place_.line;
    if (is_radioss_comment(line)) continue;
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    ++lines_;
    return true;
  }
  return false;
}

std::optional<DataLine> RadiossLines::next() {
  std::string_view line;
  if (!take(line)) return {};
  return DataLine{line, place_, block_->log};
}

std::optional<DataLine> RadiossLines::next_filled() {
  std::optional<DataLine> line = next();
  while (line && line->blank()) line = next();
  return line;
}

DataLine RadiossLines::require(const std::string& expected) {
  std::optional<DataLine> line = next();
  if (!line) fail_at(block_->place, fmt::format("{}: expected {}", block_->title, expected));
  return *line;
}

DataLine RadiossLines::next_or_blank() {
  std::optional<DataLine> line = next();
  return line ? *line : DataLine{{}, block_->place};
}

}  // namespace pinball
