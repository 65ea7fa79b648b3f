#pragma once

#include <map>
#include <set>

#include <solver/keyword/fields.hpp>
#include <solver/keyword/keyword_deck.hpp>
#include <solver/keyword/number_index.hpp>

#include "mesh_file.hpp"

namespace pinball {

/// The sets of a keyword deck, added to its mesh: SET_NODE and SET_SOLID (_LIST, _GENERATE, _GENERAL, _ADD) and
/// SET_SEGMENT (_GENERAL), with the boxes of *DEFINE_BOX. Throws InputError for members that are not there.
class KeywordSets {
 public:
  KeywordSets(const KeywordDeck& deck, MeshFile& file, const NumberIndex& nodes);
  void read();

 private:
  struct Box {
    Point low, high;
  };
  using Places = std::set<std::int32_t>;

  void read_box(const KeywordBlock& block);
  void read_set(const KeywordBlock& block);
  void read_segments(const KeywordBlock& block);
  std::array<std::int32_t, 4> segment(const KeywordBlock& block, const Card& card) const;
  void add_members(const KeywordBlock& block, Cards& cards, MeshSet& set, Places& members) const;
  /// Adds the numbers of a card to a set, for *SET_..._LIST and _GENERATE.
  void add_listed(const KeywordBlock& block, const Fields& fields, bool generate, MeshSet& set, Places& known) const;
  /// A line "OPTION number number ..." of _GENERAL.
  void add_general(const KeywordBlock& block, const Fields& fields, Places& members) const;
  void add_other_sets(const KeywordBlock& block, const Fields& fields, Places& members) const;
  Places members_of(const KeywordBlock& block, const std::string& option, const Fields& fields) const;

  bool of_nodes(const KeywordBlock& block) const { return block.name.starts_with("SET_NODE"); }
  const NumberIndex& index(const KeywordBlock& block) const { return of_nodes(block) ? nodes_ : elements_; }
  Places all(const KeywordBlock& block) const;
  Places of_part(const KeywordBlock& block, std::int64_t part, const DeckPlace& place) const;
  Places in_box(const KeywordBlock& block, std::int64_t number, const DeckPlace& place) const;
  std::int32_t place_of(const KeywordBlock& block, std::int64_t number, const DeckPlace& place) const;
  std::int64_t offset(const KeywordBlock& block) const;

  const KeywordDeck& deck_;
  MeshFile& file_;
  const NumberIndex& nodes_;
  NumberIndex elements_;
  std::map<std::int64_t, Box> boxes_;
};

}  // namespace pinball
