#include "keyword_block.hpp"

namespace pinball {

std::optional<Card> Cards::next() {
  while (!body_.empty()) {
    const std::size_t end = body_.find('\n');
    std::string_view line = body_.substr(0, end);
    body_.remove_prefix(end == std::string_view::npos ? body_.size() : end + 1);
    ++place_.line;
    while (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    if (!line.empty() && line.front() == '$') continue;
    ++lines_;
    return Card{{line, place_, block_->log}, block_};
  }
  return std::nullopt;
}

std::optional<Card> Cards::next_filled() {
  std::optional<Card> card = next();
  while (card && card->blank()) card = next();
  return card;
}

std::optional<Card> Cards::next_behind(const std::optional<Card>& head) {
  std::optional<Card> card = next_filled();
  if (!card && head && !head->blank())
    fail_at(head->place, block_->star_name() + ": expected a card behind the line of its number or title");
  return card;
}

Card Cards::require(const std::string& expected) {
  if (const std::optional<Card> card = next()) return *card;
  fail_at(block_->place, block_->star_name() + ": expected " + expected + ", got the end of the keyword");
}

Card Cards::next_or_blank() {
  if (const std::optional<Card> card = next()) return *card;
  return {{{}, place_, nullptr}, block_};
}

}  // namespace pinball
