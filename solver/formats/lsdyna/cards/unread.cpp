#include "unread.hpp"

#include <fmt/format.h>

#include <solver/base/error.hpp>
#include <solver/formats/deck/card_field.hpp>
#include <solver/formats/deck/unread_fields.hpp>
#include <solver/formats/lsdyna/scan/fields.hpp>

#include "keyword_rules.hpp"

namespace pinball {

namespace {

/// What nobody has asked for is a number all the same, where one belongs: else the whole line is not what was meant.
void require_numbers(const Card& card, const Parameters& parameters, const ReadingLog::Left& left) {
  if (left.fields == 0 || left.layout == nullptr) return;
  const Fields fields(card, parameters, *left.layout);
  for (std::size_t i = 0; i < left.layout->size(); ++i) {
    const CardField& field = (*left.layout)[i];
    if ((left.fields >> i & 1U) == 0 || field.name.empty() || field.type == FieldType::text) continue;
    if (const std::string given = fields.text(i); !deck_number(given))
      fields.fail(field.name, fmt::format("expected a number, got \"{}\"", given));
  }
}

}  // namespace

std::string second_of_keyword(const KeywordDeck& deck, std::string_view kind, std::int64_t number,
                              std::int64_t DeckTransform::*offset) {
  static constexpr CardLayout first_field{layout::whole("ID").always()};
  const auto begins_with_it = [&](const Card& card) {
    try {
      const std::int64_t id = Fields(card, deck.parameters, first_field).integer("ID");
      return id + offset_of(*card.block, offset) == number;
    } catch (const InputError&) {
      return false;
    }
  };
  for (const KeywordBlock& block : deck.blocks) {
    if (!block.name.starts_with(kind)) continue;
    KeywordBlock silent = block;
    silent.log = nullptr;
    Cards cards(silent);
    if (block.title) cards.next();
    for (bool is_first = true; const auto card = cards.next_filled(); is_first = false) {
      if (is_first || !begins_with_it(*card)) continue;
      return fmt::format("; {} begins with it, a line of {}, and such a keyword has one: give each its own",
                         card->place.text(), block.star_name());
    }
  }
  return "";
}

void follow_reading(KeywordDeck& deck, ReadingLog& log) {
  for (KeywordBlock& block : deck.blocks) {
    const KeywordRule* rule = rule_of(keyword_alias(block.name));
    const bool is_done = rule != nullptr && (rule->treatment == Treatment::done || rule->treatment == Treatment::mesh);
    const bool is_many = block.name == "NODE" || block.name == "ELEMENT_SOLID" || block.name == "ELEMENT_SHELL";
    if (is_done && !is_many) block.log = &log;
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
      const ReadingLog::Left left = log.left_of(card->text.data());
      require_numbers(*card, deck.parameters, left);
      tell_unread_fields(block.star_name(), card->place, left, report);
    }
  }
  for (const DeckPlace& place : deck.behind_end) report.unused(place, "what stands behind *END");
  for (const UnreadLine& line : deck.unread) tell_unread_fields(line.star_name, line.place, line.left, report);
}

}  // namespace pinball
