#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include <solver/formats/deck/deck_point_masses.hpp>
#include <solver/formats/radioss/layouts/radioss_boundary_cards.hpp>

#include "radioss_inertia.hpp"
#include "radioss_keys.hpp"

/// /ADMAS: masses of nodes that deform, and of main nodes of rigid bodies.
namespace pinball {

namespace {

/// A line of an /ADMAS of type 0 or 1.
struct AddedMass {
  double of_node = 0;                 ///< of each node of the group [mass]
  std::vector<std::int32_t> nodes{};  ///< of the group, without those that hexahedra of twenty nodes get
  DeckPlace place;
};

/// Whether the type of an /ADMAS is one of a group of nodes: 0 gives each of them the mass, 1 shares it among them.
bool is_of_group(const RadiossBlock& block) {
  return !block.numbers.empty() && (block.numbers[0] == 0 || block.numbers[0] == 1);
}

std::vector<AddedMass> masses_of(const RadiossData& data, const RadiossBlock& block) {
  std::vector<AddedMass> masses;
  RadiossLines lines(block);
  while (const auto line = lines.next_filled()) {
    const RadiossFields f(*line, block, radioss::added_mass);
    const double mass = f.number("MASS");
    if (!(mass >= 0)) f.fail("MASS", fmt::format("expected a mass >= 0, got {}", mass));
    std::vector<std::int32_t> nodes = data.node_group(f.integer("grnd_ID"), line->place).members;
    std::erase_if(nodes, [&](std::int32_t node) { return static_cast<std::size_t>(node) >= data.given_nodes; });
    const double count = std::max<double>(1, static_cast<double>(nodes.size()));
    masses.push_back({block.numbers[0] == 1 ? mass / count : mass, std::move(nodes), line->place});
  }
  return masses;
}

}  // namespace

double mass_added_to(const RadiossData& data, std::int32_t main) {
  double sum = 0;
  for (const RadiossBlock* block : data.blocks_of("ADMAS")) {
    if (!is_of_group(*block)) continue;
    for (const AddedMass& added : masses_of(data, *block)) sum += added.of_node * std::ranges::count(added.nodes, main);
  }
  return sum;
}

namespace {

/// What a node that is no main node can have no mass for; empty: it can.
const char* problem_of(const RadiossData& data, std::int32_t node) {
  if (!data.used[node]) return "that no solid has, and no main nodes of an /RBODY";
  const std::int32_t rigid = data.rigid_of_node[node];
  return rigid >= 0 && data.rigid[rigid].inertia ? "of an /RBODY whose main node has a mass or an inertia" : "";
}

void translate_added_mass(RadiossData& data, const RadiossBlock& block, const AddedMass& added,
                          DeckPointMasses& masses) {
  for (const std::int32_t node : added.nodes) {
    if (data.rigid_at(node) != nullptr || added.of_node == 0) continue;
    const std::string problem = problem_of(data, node);
    if (!problem.empty())
      return data.report.reject(added.place, "/ADMAS of nodes " + problem, "give it to other nodes, or to a main node");
    masses.add(node, added.of_node, card_of(block, added.place));
  }
}

}  // namespace

void translate_radioss_added_masses(RadiossData& data, DeckScene& scene) {
  DeckPointMasses masses;
  for (const RadiossBlock* block : data.blocks_of("ADMAS")) {
    if (!is_of_group(*block)) {
      if (block->log != nullptr) block->log->done(block);
      data.report.reject(block->place, block->title + " of another type than 0 and 1", "give it groups of nodes");
      continue;
    }
    if (block->numbers.size() > 2 && block->numbers[2] != 0)
      data.report.reject(block->place, block->title + " in units of its own", "give it those of the deck");
    for (const AddedMass& added : masses_of(data, *block)) translate_added_mass(data, *block, added, masses);
  }
  masses.write(data.mesh.node_ids, "MASS", "grnd_ID", scene);
}

}  // namespace pinball
