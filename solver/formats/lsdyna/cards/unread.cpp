#include "unread.hpp"

#include <solver/formats/deck/unread_fields.hpp>

#include "keyword_rules.hpp"

namespace pinball {

void follow_reading(KeywordDeck& deck, ReadingLog& log) {
  for (KeywordBlock& block : deck.blocks) {
    const KeywordRule* rule = rule_of(keyword_alias(block.name));
    const bool is_done = rule != nullptr && (rule->treatment == Treatment::done || rule->treatment == Treatment::mesh);
    if (is_done && block.name != "NODE" && block.name != "ELEMENT_SOLID") block.log = &log;
  }
}

void tell_unread(const KeywordDeck& deck, const ReadingLog& log, DeckReport& report) {
  for (const KeywordBlock& block : deck.blocks) {
    if (block.log == nullptr || log.is_done(&block)) continue;
    if (!log.has_seen(&block)) {
      report.unused(block.place, block.star_name());
      continue;
    }
    if (block.name == "TITLE") continue;  // of one line
    KeywordBlock silent = block;
    silent.log = nullptr;
    Cards cards(silent);
    for (std::size_t line = 0; const auto card = cards.next(); ++line) {
      if (line >= log.lines_of(&block)) {
        if (!card->blank()) report.unused(card->place, block.star_name() + ": the rest of its lines");
        continue;
      }
      tell_unread_fields(block.star_name(), card->place, log.left_of(card->text.data()), report);
    }
  }
  for (const UnreadLine& line : deck.unread) tell_unread_fields(line.star_name, line.place, line.left, report);
}

}  // namespace pinball
