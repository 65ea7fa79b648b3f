#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <solver/formats/deck/given_once.hpp>
#include <solver/formats/lsdyna/scan/fields.hpp>
#include <solver/formats/lsdyna/scan/keyword_deck.hpp>
#include <solver/mesh/mesh_file.hpp>
#include <solver/mesh/number_index.hpp>

#include "keyword_boxes.hpp"

namespace pinball {

/// The sets of nodes and of solids of a keyword deck, added to its mesh: SET_NODE and SET_SOLID (_LIST, _GENERATE,
/// _GENERAL, _ADD, _COLUMN, also with _COLLECT), with the boxes of *DEFINE_BOX. What is wrong with a set is kept with
/// it, for who uses it: many decks have sets that nothing uses, of what was left out.
class KeywordSets {
 public:
  KeywordSets(const KeywordDeck& deck, MeshFile& file, const NumberIndex& nodes);
  void read();

 private:
  using Places = std::vector<std::int32_t>;
  using Numbered = std::vector<std::pair<std::int64_t, std::int32_t>>;

  void read_set(const KeywordBlock& block);
  void add_members(const KeywordBlock& block, Cards& cards, Places& members);
  void add_listed(const KeywordBlock& block, const Fields& fields, Places& members) const;
  void add_generated(const KeywordBlock& block, const Fields& fields, Places& members);
  void add_numbers(const KeywordBlock& block, std::int64_t first, std::int64_t last, std::int64_t step,
                   Places& members);
  /// A line "OPTION number number ..." of _GENERAL.
  void add_general(const KeywordBlock& block, const Fields& fields, Places& members) const;
  void add_other_sets(const KeywordBlock& block, const Fields& fields, Places& members) const;
  Places members_of(const KeywordBlock& block, const std::string& option, const Fields& fields) const;
  Places members_of(const KeywordBlock& block, const std::string& option, std::int64_t number,
                    const Fields& fields) const;

  bool of_nodes(const KeywordBlock& block) const { return block.name.starts_with("SET_NODE"); }
  std::vector<MeshSet>& sets(const KeywordBlock& block) const {
    return of_nodes(block) ? file_.node_sets : file_.element_sets;
  }
  const Numbered& sorted(const KeywordBlock& block);
  Places all(const KeywordBlock& block) const;
  Places of_part(const KeywordBlock& block, std::int64_t part, const DeckPlace& place) const;
  Places in_box(const KeywordBlock& block, const KeywordBox& box) const;
  std::int32_t place_of(const KeywordBlock& block, std::int64_t number, const DeckPlace& place) const;
  std::int64_t offset(const KeywordBlock& block) const {
    return offset_of(block, of_nodes(block) ? &DeckTransform::node : &DeckTransform::element);
  }

  const KeywordDeck& deck_;
  MeshFile& file_;
  const NumberIndex& nodes_;
  NumberIndex elements_;
  KeywordBoxes boxes_;
  GivenOnce given_;
  Numbered sorted_nodes_, sorted_elements_;  ///< by number, made where a range asks for it
};

}  // namespace pinball
