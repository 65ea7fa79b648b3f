#include <fmt/format.h>

#include <algorithm>

#include <solver/formats/radioss/layouts/radioss_boundary_cards.hpp>

#include "radioss_inertia.hpp"

/// /ADMAS: masses of main nodes of rigid bodies.
namespace pinball {

namespace {

/// A line of an /ADMAS of type 0 or 1.
struct AddedMass {
  double of_node = 0;  ///< of each node of the group [mass]
  const MeshSet* group = nullptr;
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
    const MeshSet& group = data.node_group(f.integer("grnd_ID"), line->place);
    const double nodes = std::max<double>(1, static_cast<double>(group.members.size()));
    masses.push_back({block.numbers[0] == 1 ? mass / nodes : mass, &group, line->place});
  }
  return masses;
}

}  // namespace

double mass_added_to(const RadiossData& data, std::int32_t main) {
  double sum = 0;
  for (const RadiossBlock* block : data.blocks_of("ADMAS")) {
    if (!is_of_group(*block)) continue;
    for (const AddedMass& added : masses_of(data, *block))
      sum += added.of_node * std::ranges::count(added.group->members, main);
  }
  return sum;
}

void reject_other_added_masses(RadiossData& data) {
  const auto is_main = [&](std::int32_t node) { return data.rigid_at(node) != nullptr; };
  for (const RadiossBlock* block : data.blocks_of("ADMAS")) {
    if (!is_of_group(*block)) {
      if (block->log != nullptr) block->log->done(block);
      data.report.reject(block->place, block->title + " of another type than 0 and 1", "give it groups of nodes");
      continue;
    }
    if (block->numbers.size() > 2 && block->numbers[2] != 0)
      data.report.reject(block->place, block->title + " in units of its own", "give it those of the deck");
    for (const AddedMass& added : masses_of(data, *block)) {
      if (!std::ranges::all_of(added.group->members, is_main))
        data.report.reject(added.place, "/ADMAS of nodes that are no main nodes of an /RBODY",
                           "the density of a part in their place");
    }
  }
}

}  // namespace pinball
