#include <fmt/format.h>

#include <set>

#include "boundary_keys.hpp"
#include "deck_parts.hpp"

namespace pinball {

namespace {

/// Nodes or solids of a deck, each of which becomes a probe at most once.
class ProbeKeywords {
 public:
  /// kind: the key of a probe; used: whether a solid has it, empty: all count.
  ProbeKeywords(const DeckData& data, KeyOf<Probe> kind, const std::vector<std::int64_t>& ids,
                const std::vector<MeshSet>& sets, const std::vector<bool>& used)
      : data_(data), kind_(kind), ids_(ids), sets_(sets), used_(used), index_(ids) {}

  /// Eight numbers on a card, with _ID one and a title. add: what *INCLUDE_TRANSFORM adds to them.
  void translate(const KeywordBlock& block, std::int64_t add, DeckScene& scene) {
    Cards cards(block);
    while (auto card = cards.next_filled()) {
      if (block.id) card->log = nullptr;  // what follows the number is a title
      const Fields f = data_.fields(*card, block.id ? layout::history_named : layout::members);
      for (std::size_t i = 0; i < (block.id ? 1U : 8U); ++i) {
        const std::int64_t number = f.integer(i);
        if (number == 0) continue;
        if (block.name.ends_with("_SET")) {
          for (const std::int32_t place : members(block, set_number(block, number), card->place))
            write(block, place, card->place, scene);
        } else {
          write(block, place_of(block, number + add, card->place), card->place, scene);
        }
      }
    }
  }

 private:
  std::size_t place_of(const KeywordBlock& block, std::int64_t number, const DeckPlace& place) const {
    const std::int32_t found = index_.find(number);
    if (found < 0) fail_at(place, fmt::format("{}: {} {} is not there", block.star_name(), kind_.name, number));
    return found;
  }
  const std::vector<std::int32_t>& members(const KeywordBlock& block, std::int64_t number,
                                           const DeckPlace& place) const {
    const MeshSet* set = find_set(sets_, std::to_string(number));
    if (set == nullptr)
      fail_at(place, fmt::format("{}: there is no set {} of {}s", block.star_name(), number, kind_.name));
    if (!set->problem.empty()) fail_at(place, fmt::format("{}: {}", block.star_name(), set->problem));
    return set->members;
  }
  void write(const KeywordBlock& block, std::size_t at, const DeckPlace& place, DeckScene& scene) {
    if (!watched_.insert(ids_[at]).second) return;
    if (!used_.empty() && !used_[at]) return data_.report.ignore_node(place, block.star_name());
    const auto keys = scene.entry<Probe>("probe", card_of(block, place));
    keys.set("name", fmt::format("{}_{}", kind_.name, ids_[at]));
    keys.set(kind_, ids_[at]);
  }

  const DeckData& data_;
  KeyOf<Probe> kind_;
  const std::vector<std::int64_t>& ids_;
  const std::vector<MeshSet>& sets_;
  const std::vector<bool>& used_;
  NumberIndex index_;
  std::set<std::int64_t> watched_;
};

}  // namespace

void translate_probes(DeckData& data, DeckScene& scene) {
  const std::vector<bool> all;
  ProbeKeywords nodes(data, "node", data.mesh.node_ids, data.mesh.node_sets, data.used);
  ProbeKeywords elements(data, "element", data.mesh.element_ids, data.mesh.element_sets, all);
  for (const KeywordBlock& block : data.deck.blocks) {
    if (block.name == "DATABASE_HISTORY_NODE" || block.name == "DATABASE_HISTORY_NODE_SET")
      nodes.translate(block, offset_of(block, &DeckTransform::node), scene);
    if (block.name == "DATABASE_HISTORY_SOLID" || block.name == "DATABASE_HISTORY_SOLID_SET")
      elements.translate(block, offset_of(block, &DeckTransform::element), scene);
  }
}

}  // namespace pinball
