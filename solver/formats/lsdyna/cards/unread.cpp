#include "unread.hpp"

#include <fmt/format.h>

#include <map>

#include <solver/formats/lsdyna/layouts/card_field.hpp>

#include "keyword_rules.hpp"

namespace pinball {

namespace {

/// The fields of a line by their names, those of one remark together: what the card says and nobody has asked for.
void tell_fields(const std::string& star_name, const DeckPlace& place, const ReadingLog::Left& left,
                 DeckReport& report) {
  std::map<std::string_view, std::vector<std::string>> names;  // by the remark
  for (std::size_t i = 0; i < 32; ++i) {
    if ((left.fields >> i & 1U) == 0) continue;
    const bool known = left.layout != nullptr && i < left.layout->size() && !(*left.layout)[i].name.empty();
    if (!known) {
      names[""].push_back(fmt::format("field {}", i + 1));
      continue;
    }
    const CardField& field = (*left.layout)[i];
    if (field.use == FieldUse::rejected) {
      report.reject(place, fmt::format("{} with {}", star_name, field.name), std::string(field.remark));
    } else {
      names[field.remark].emplace_back(field.name);
    }
  }
  for (const auto& [remark, fields] : names)
    report.unused(place, fmt::format("{}: {}", star_name, fmt::join(fields, ", ")), std::string(remark));
}

}  // namespace

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
      tell_fields(block.star_name(), card->place, log.left_of(card->text.data()), report);
    }
  }
  for (const UnreadLine& line : deck.unread) tell_fields(line.star_name, line.place, line.left, report);
}

}  // namespace pinball
