#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <map>
#include <vector>

#include <solver/formats/deck/deck_scene.hpp>
#include <solver/formats/lsdyna/layouts/boundary_cards.hpp>

#include "deck_data.hpp"

/// What the keywords of constraints, motion, velocities, walls, loads and contact have in common. Numbers that the deck
/// does not have are InputErrors that name the card.
namespace pinball {

/// BIRTH and DEATH [time]; a DEATH of 0 is none.
struct DeckSpan {
  double birth = 0, death = 0;
  auto operator<=>(const DeckSpan&) const = default;
};
/// BIRTH and DEATH of a card.
DeckSpan span_of(const Fields& f);
void set_span(const DeckSpan& span, const DeckKeys<TimeSpan>& keys);

// Numbers of a deck, with what *INCLUDE_TRANSFORM adds to them.
std::int64_t set_number(const KeywordBlock& block, std::int64_t id);
std::int64_t node_number(const KeywordBlock& block, std::int64_t id);
/// Of a vector or a system; 0 stays 0: none.
std::int64_t definition_number(const KeywordBlock& block, std::int64_t id);
/// Of a curve or a table, the same.
std::int64_t curve_number(const KeywordBlock& block, std::int64_t id);

/// A keyword at the place of one of its cards.
inline DeckCard card_of(const KeywordBlock& block, const DeckPlace& place) { return {block.star_name(), place}; }

/// Bodies of all parts with solids, in the order of their numbers.
std::vector<std::string> all_bodies(const DeckData& data);
/// Those of some parts, in the same order, each once; parts without solids have none.
std::vector<std::string> bodies_of(const DeckData& data, const std::vector<std::int64_t>& parts,
                                   const DeckPlace& place);

/// NSID, NSIDEX and BOXID of a card: keys of a selection.
void set_selection(const DeckData& data, const KeywordBlock& block, const Fields& f,
                   const DeckKeys<NodeSelection>& keys);

/// The nodes of a card: a set of them, or one.
void set_target(const KeywordBlock& block, bool set, std::int64_t id, const DeckKeys<NodeSelection>& keys);

/// The same in the mesh, of a number in this field; those of a set that is not there are none, which is said elsewhere.
/// Throws InputError for a set that has something wrong.
std::vector<std::int32_t> nodes_of_card(const DeckData& data, const KeywordBlock& block, bool set, const Fields& f,
                                        std::size_t field = 0);

/// ENDTIM; without it as late as can be [time]
double end_of_run(const DeckData& data);
/// Times and factors of the curve of this number, multiplied by SF; an SF of 0 is 1. used: when it acts; its times
/// count from the birth, before OFFA it is zero, and where it has no points, it is reported what holds there.
void set_curve(const DeckData& data, const KeywordBlock& block, std::int64_t curve, double scale,
               const DeckPlace& place, const DeckKeys<TimeTable>& keys, const DeckSpan& used = {});

/// A vector in components of a local system; 0: the global one.
Point in_system(const DeckData& data, const KeywordBlock& block, std::int64_t system, const Point& vector,
                const DeckPlace& place);

/// Nodes of cards that name one each, those of one kind together.
template <class Kind>
class NodesByKind {
 public:
  struct Nodes {
    std::vector<std::int64_t> numbers;
    DeckPlace first;
  };

  explicit NodesByKind(const DeckData& data) : data_(data) {}

  /// Leaves out nodes of no solid. Throws InputError for one that is not there.
  void add(const KeywordBlock& block, const DeckPlace& place, std::int64_t number, const Kind& kind) {
    const std::int32_t found = data_.nodes.find(number);
    if (found < 0) fail_at(place, fmt::format("{}: node {} is not there", block.star_name(), number));
    if (!data_.used[found]) return data_.report.ignore_node(place, block.star_name());
    Nodes& nodes = nodes_[kind];
    if (nodes.numbers.empty()) nodes.first = place;
    nodes.numbers.push_back(number);
  }
  const std::map<Kind, Nodes>& all() const { return nodes_; }

 private:
  const DeckData& data_;
  std::map<Kind, Nodes> nodes_;
};

}  // namespace pinball
