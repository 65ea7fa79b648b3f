#include "sorted_keywords.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include <solver/base/error.hpp>
#include <solver/formats/deck/card_field.hpp>

#include "keyword_rules.hpp"

namespace pinball {

namespace {

/// What --lenient leaves out; all output is known.
bool is_output_or_control(const std::string& name) {
  return name.starts_with("CONTROL") || name.starts_with("DATABASE") || name.starts_with("PARAMETER");
}

/// What parts name by a number that begins the card; all that there is not.
enum class OfParts { no, material, section, state_equation };

OfParts kind_of(const KeywordBlock& block, const KeywordRule* rule) {
  if (rule != nullptr && rule->treatment != Treatment::rejected) return OfParts::no;
  if (block.name.starts_with("MAT_") && !block.name.starts_with("MAT_NONLOCAL")) return OfParts::material;
  if (block.name.starts_with("SECTION_")) return OfParts::section;
  return block.name.starts_with("EOS_") ? OfParts::state_equation : OfParts::no;
}

/// Elements of a keyword of which each has one line; -1: it is none of those.
int count_of(const KeywordBlock& block) {
  static constexpr std::array<std::string_view, 6> of_one_line{"ELEMENT_SHELL",    "ELEMENT_BEAM", "ELEMENT_TSHELL",
                                                               "ELEMENT_DISCRETE", "ELEMENT_MASS", "ELEMENT_SEATBELT"};
  if (std::ranges::find(of_one_line, block.name) == of_one_line.end()) return -1;
  KeywordBlock silent = block;
  silent.log = nullptr;
  Cards cards(silent);
  int count = 0;
  while (cards.next_filled()) ++count;
  return count;
}

/// The number that begins its first card; none: nobody can read it.
std::optional<std::int64_t> number_of(const KeywordBlock& block, const DeckData& data) {
  static constexpr CardLayout numbered{layout::whole("ID").always()};
  try {
    Cards cards(block);
    if (block.title) cards.next();
    const std::optional<Card> card = cards.next();
    if (!card) return std::nullopt;
    return data.fields(*card, numbered).integer("ID");
  } catch (const InputError&) {
    return std::nullopt;
  }
}

bool has(const DeckPart& part, OfParts kind, std::int64_t number, const KeywordBlock& block) {
  if (kind == OfParts::section) return part.section == number + offset_of(block, &DeckTransform::other);
  const std::int64_t own = number + offset_of(block, &DeckTransform::material);
  return kind == OfParts::material ? part.material == own : part.state_equation == own;
}

}  // namespace

UnreadKeywords sort_keywords(KeywordDeck& deck, bool lenient, DeckReport& report) {
  UnreadKeywords unread;
  std::vector<KeywordBlock> read;
  for (KeywordBlock& block : deck.blocks) {
    const KeywordRule* rule = rule_of(keyword_alias(block.name));
    const bool is_read = rule != nullptr && (rule->treatment == Treatment::done || rule->treatment == Treatment::mesh);
    if (kind_of(block, rule) != OfParts::no) {
      unread.of_parts.push_back(std::move(block));
    } else if (is_read && (rule->in_other_units || units_of(block).are_own())) {
      read.push_back(std::move(block));
    } else if (is_read) {
      report.reject(block.place, block.star_name(),
                    "in an included file of other units: move it into a file of the deck's own");
    } else if (rule != nullptr && rule->treatment == Treatment::ignored) {
      report.ignore(block.place, block.star_name());
    } else if (rule == nullptr && lenient && is_output_or_control(block.name)) {
      report.leave_out(block.place, block.star_name());
    } else {
      report.reject(block.place, block.star_name(), rule == nullptr ? "" : rule->remark, count_of(block));
      unread.of_mesh |= block.name.starts_with("ELEMENT_SOLID") || block.name.starts_with("NODE_");
    }
  }
  deck.blocks = std::move(read);
  return unread;
}

void reject_of_parts(const std::vector<KeywordBlock>& blocks, const DeckData* data, DeckReport& report) {
  for (const KeywordBlock& block : blocks) {
    const KeywordRule* rule = rule_of(keyword_alias(block.name));
    const OfParts kind = kind_of(block, rule);
    const std::optional<std::int64_t> number = data == nullptr ? std::nullopt : number_of(block, *data);
    const auto is_of = [&](const DeckPart& part) { return has(part, kind, *number, block); };
    if (number && std::ranges::none_of(data->parts, is_of)) {
      report.unused(block.place, block.star_name(), "no part with solids has it");
    } else {
      report.reject(block.place, block.star_name(), rule == nullptr ? "" : rule->remark);
    }
  }
}

}  // namespace pinball
