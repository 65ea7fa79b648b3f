#include "radioss_block.hpp"

#include <fmt/format.h>

#include <solver/formats/deck/number_text.hpp>

namespace pinball {

std::int64_t RadiossBlock::id() const {
  if (numbers.empty()) fail_at(place, fmt::format("{}: expected a number behind the keyword", title));
  return numbers.front();
}

RadiossLines::RadiossLines(const RadiossBlock& block) : block_(&block), place_(block.place) {
  open(0);
  std::string_view line;
  if (block.titled && take(line)) title_ = std::string(trimmed(line));
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
