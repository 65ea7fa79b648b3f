#include <fmt/format.h>

#include <algorithm>

#include <solver/formats/deck/deck_point_masses.hpp>
#include <solver/formats/lsdyna/layouts/mesh_cards.hpp>

#include "boundary_keys.hpp"
#include "deck_parts.hpp"

/// *ELEMENT_MASS: masses of nodes.
namespace pinball {

namespace {

/// Nodes that are not in the scene, or are of a rigid part whose mass is given.
bool rejects_nodes(DeckData& data, const KeywordBlock& block, const std::vector<std::int32_t>& members,
                   const DeckPlace& place) {
  const auto reject = [&](const char* which, const char* instead) {
    data.report.reject(place, fmt::format("{} of nodes {}", block.star_name(), which), instead);
    return true;
  };
  if (!std::ranges::all_of(members, [&](std::int32_t node) { return data.used[node]; }))
    return reject("that no solid has", "give it to nodes of the part that it moves with");
  const auto is_given = [&](std::int32_t node) { return data.inertia.contains(data.lead_of_node[node]); };
  if (!data.lead_of_node.empty() && std::ranges::any_of(members, is_given))
    return reject("of a part with *PART_INERTIA", "put the mass into its TM");
  return false;
}

}  // namespace

void translate_node_masses(DeckData& data, const KeywordBlock& block, DeckScene& scene) {
  const bool set = block.name.ends_with("_NODE_SET");
  DeckPointMasses masses;
  for_each_card(block, [&](const Card& card) {
    const Fields f = data.fields(card, set ? layout::node_set_mass : layout::node_mass);
    data.give_once(block, fmt::format("mass {}", f.integer("EID") + offset_of(block, &DeckTransform::element)),
                   card.place);
    const double mass = f.number("MASS");
    const std::int64_t id = f.integer(1);
    const std::vector<std::int32_t> members = nodes_of_card(data, block, set, f, 1);
    if (members.empty()) f.fail("NSID", fmt::format("no *SET_NODE with nodes has the number {}", id));
    if (members.front() < 0) f.fail("NID", fmt::format("node {} is not there", id));
    if (mass == 0) return data.report.unused(card.place, block.star_name(), "its MASS is 0");
    if (rejects_nodes(data, block, members, card.place)) return;
    for (const std::int32_t node : members)
      masses.add(node, mass / static_cast<double>(members.size()), card_of(block, card.place));
  });
  masses.write(data.mesh.node_ids, "mass", set ? "nsid" : "nid", scene);
}

}  // namespace pinball
