#pragma once

#include <map>

#include <solver/base/point.hpp>
#include <solver/formats/deck/given_once.hpp>
#include <solver/formats/lsdyna/layouts/mesh_cards.hpp>
#include <solver/formats/lsdyna/scan/fields.hpp>
#include <solver/formats/lsdyna/scan/keyword_deck.hpp>

namespace pinball {

struct KeywordBox {
  Point low, high;

  bool holds(const Point& x) const {
    for (std::size_t k = 0; k < 3; ++k) {
      if (x[k] < low[k] || x[k] > high[k]) return false;
    }
    return true;
  }
};

/// All *DEFINE_BOX of a deck.
class KeywordBoxes {
 public:
  explicit KeywordBoxes(const KeywordDeck& deck) {
    for (const KeywordBlock& block : deck.blocks) {
      if (block.name == "DEFINE_BOX") for_each_card(block, [&](const Card& card) { read(deck, block, card); });
    }
  }
  /// Throws InputError where a block names one that is not there.
  const KeywordBox& find(const KeywordBlock& block, std::int64_t number, const DeckPlace& place) const {
    const auto found = boxes_.find(number + offset_of(block, &DeckTransform::define));
    if (found == boxes_.end())
      fail_at(place, block.star_name() + ": no *DEFINE_BOX has the number " + std::to_string(number));
    return found->second;
  }

 private:
  void read(const KeywordDeck& deck, const KeywordBlock& block, const Card& card) {
    const Fields fields(card, deck.parameters, layout::box);
    const std::int64_t id = fields.integer("BOXID") + offset_of(block, &DeckTransform::define);
    given_.add("box " + std::to_string(id), card.place, block.of_case);
    KeywordBox& box = boxes_[id];
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] = fields.number(1 + 2 * k);
      box.high[k] = fields.number(2 + 2 * k);
    }
  }

  std::map<std::int64_t, KeywordBox> boxes_;
  GivenOnce given_;
};

/// Number and name of a set: the first cards of its keyword.
template <class Set>
void read_set_head(const KeywordBlock& block, const Parameters& parameters, Cards& cards, Set& set) {
  if (block.title) set.name = std::string(trimmed(cards.require("a title").text));
  const Card head = cards.require("the number of the set");
  set.id = Fields(head, parameters, layout::set_head).integer("SID") + offset_of(block, &DeckTransform::set);
  if (deck_integer(set.name)) set.name.clear();  // sets are found by their numbers, which no title takes away
}

}  // namespace pinball
