#include "radioss_unread.hpp"

#include <solver/formats/deck/unread_fields.hpp>
#include <solver/mesh/element_types.hpp>

#include "radioss_rules.hpp"

namespace pinball {

void follow_reading(RadiossDeck& deck, ReadingLog& log) {
  for (RadiossBlock& block : deck.blocks) {
    const RadiossRule* rule = radioss_rule_of(block.name);
    const bool is_done = rule != nullptr && (rule->treatment == Treatment::done || rule->treatment == Treatment::mesh);
    const bool is_long = block.name == "NODE" || element_type(&ElementType::radioss, block.name) != nullptr;
    if (is_done && !is_long) block.log = &log;
  }
}

void tell_unread(const RadiossDeck& deck, const ReadingLog& log, DeckReport& report) {
  for (const DeckPlace& place : deck.behind_end) report.unused(place, "what stands behind /END");
  for (const RadiossBlock& block : deck.blocks) {
    if (block.log == nullptr || log.is_done(&block)) continue;
    if (!log.has_seen(&block)) {
      report.unused(block.place, block.title);
      continue;
    }
    RadiossBlock silent = block;
    silent.log = nullptr;
    RadiossLines lines(silent);
    for (std::size_t line = block.titled ? 1 : 0; const auto card = lines.next(); ++line) {
      if (line >= log.lines_of(&block)) {
        if (!card->blank()) report.unused(card->place, block.title + ": the rest of its lines");
        continue;
      }
      tell_unread_fields(block.title, card->place, log.left_of(card->text.data()), report);
    }
  }
}

}  // namespace pinball
