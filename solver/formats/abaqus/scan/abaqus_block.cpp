#include "abaqus_block.hpp"

#include <fmt/format.h>

namespace pinball {

const std::string* AbaqusBlock::find(const char* parameter) const {
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (parameters[i].first != parameter) continue;
    if (log != nullptr) log->asked(this, i);
    return &parameters[i].second;
  }
  return nullptr;
}

std::optional<std::string> AbaqusBlock::value(const char* parameter) const {
  const std::string* found = find(parameter);
  return found == nullptr ? std::nullopt : std::optional(*found);
}

std::string AbaqusBlock::option(const char* parameter) const {
  const std::string* found = find(parameter);
  return found == nullptr ? std::string() : squeezed(*found);
}

std::string AbaqusBlock::require(const char* parameter) const {
  const std::string* found = find(parameter);
  if (found == nullptr || found->empty())
    fail_at(place, fmt::format("{}: expected the parameter {}=", star_name(), parameter));
  return *found;
}

double AbaqusBlock::number(const char* parameter, double otherwise) const {
  const std::string* found = find(parameter);
  if (found == nullptr) return otherwise;
  if (const auto value = deck_number(*found)) return *value;
  fail_at(place, fmt::format("{}: {}: expected a number, got \"{}\"", star_name(), parameter, *found));
}

void DataLines::open(std::size_t segment) {
  segment_ = segment;
  if (segment >= block_->data.size()) return;
  rest_ = block_->data[segment].text;
  place_ = block_->data[segment].before;
}

std::optional<DataLine> DataLines::next() {
  while (segment_ < block_->data.size()) {
    while (!rest_.empty()) {
      const std::size_t end = rest_.find('\n');
      const std::string_view line = rest_.substr(0, end);
      rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
      ++place_.line;
      const std::size_t first = line.find_first_not_of(" \t\r");
      if (first == std::string_view::npos || line.substr(first, 2) == "**") continue;
      ++lines_;
      return DataLine{trimmed(line), place_, block_->is_mesh() ? nullptr : block_->log};
    }
    open(segment_ + 1);
  }
  return std::nullopt;
}

DataLine DataLines::require(const std::string& expected) {
  if (const std::optional<DataLine> card = next()) return *card;
  fail_at(block_->place, fmt::format("{}: expected {}, got no data line", block_->star_name(), expected));
}

}  // namespace pinball
