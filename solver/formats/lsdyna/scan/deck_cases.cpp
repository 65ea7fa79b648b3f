#include "deck_cases.hpp"

#include <algorithm>

#include <solver/formats/lsdyna/layouts/mesh_cards.hpp>

#include "fields.hpp"

namespace pinball {

bool DeckCases::take_in(const KeywordBlock& block, const Parameters& parameters) {
  if (block.name == "CASE") {
    read_case(block, parameters);
  } else if (block.name.starts_with("CASE_BEGIN_") || block.name.starts_with("CASE_END_")) {
    begin_or_end(block);
  } else {
    return false;
  }
  return true;
}

void DeckCases::begin_or_end(const KeywordBlock& block) {
  const bool begins = block.name.starts_with("CASE_BEGIN_");
  const auto number = deck_integer(std::string_view(block.name).substr(begins ? 11 : 9));
  if (!number) fail_at(block.place, '*' + block.name + ": expected the number of a case");
  if (begins) {
    open_.insert(*number);
  } else if (open_.erase(*number) == 0) {
    fail_at(block.place, '*' + block.name + ": no such case has begun");
  }
  known_.insert(*number);
}

/// Number and name; a line of its own command; the numbers of the parts of the deck that belong to it.
void DeckCases::read_case(const KeywordBlock& block, const Parameters& parameters) {
  Cards cards(block);
  const Card head = cards.require("the number of the case");
  const std::int64_t number = Fields(head, parameters, layout::case_head).integer("CASEID");
  cards.next();
  Numbers& members = members_[number];
  while (const std::optional<Card> card = cards.next_filled()) {
    const Fields fields(*card, parameters, layout::case_members);
    for (std::size_t i = 0; i < 8; ++i) {
      if (const auto id = deck_integer(fields.text(i))) members.insert(*id);
    }
  }
}

DeckCases::Numbers DeckCases::cases_here(const std::string& after) const {
  Numbers cases = open_;
  const std::size_t at = after.find("CID=");
  if (at == std::string::npos) return cases;
  if (const auto cid = deck_integer(trimmed(after.substr(at + 4)))) cases.insert(*cid);
  return cases;
}

bool DeckCases::takes(const Numbers& cases) const {
  if (cases.empty()) return true;
  if (!chosen_) return false;
  const auto found = members_.find(*chosen_);
  if (found == members_.end()) return cases.contains(*chosen_);
  return std::ranges::any_of(cases, [&](std::int64_t id) { return found->second.contains(id); });
}

bool DeckCases::chosen_is_empty() const {
  const auto found = chosen_ ? members_.find(*chosen_) : members_.end();
  return found != members_.end() && found->second.empty();
}

std::vector<std::int64_t> DeckCases::numbers() const {
  std::vector<std::int64_t> all;
  for (const auto& [number, members] : members_) all.push_back(number);
  for (const std::int64_t number : known_) {
    if (!members_.contains(number)) all.push_back(number);
  }
  return all;
}

}  // namespace pinball
