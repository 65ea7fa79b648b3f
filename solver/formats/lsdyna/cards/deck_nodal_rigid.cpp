#include <fmt/format.h>

#include <algorithm>

#include <solver/formats/lsdyna/layouts/rigid_cards.hpp>

#include "boundary_keys.hpp"
#include "deck_parts.hpp"

/// *CONSTRAINED_NODAL_RIGID_BODY: nodes of parts that deform which move as one, under a number as parts have it.
namespace pinball {

namespace {

std::string name_of_nodal_rigid(std::int64_t number) { return fmt::format("nodal_rigid_body_{}", number); }

/// NSID; without it the set that has the number of the body.
std::int64_t set_of_nodal_rigid(const Fields& f) {
  const std::int64_t set = f.integer("NSID");
  return set == 0 ? f.integer("PID") : set;
}

}  // namespace

std::optional<std::string> nodal_rigid_body(const DeckData& data, std::int64_t number) {
  std::optional<std::string> found;
  for (const KeywordBlock* block : data.blocks_of("CONSTRAINED_NODAL_RIGID_BODY")) {
    for_each_card(*block, [&](const Card& card) {
      const std::int64_t id = data.fields(card, layout::nodal_rigid).integer("PID");
      if (id + offset_of(*block, &DeckTransform::part) == number) found = name_of_nodal_rigid(number);
    });
  }
  return found;
}

void translate_nodal_rigid_bodies(DeckData& data, const KeywordBlock& block, DeckScene& scene) {
  for_each_card(block, [&](const Card& card) {
    const Fields f = data.fields(card, layout::nodal_rigid);
    const std::int64_t id = f.integer("PID") + offset_of(block, &DeckTransform::part), set = set_of_nodal_rigid(f);
    if (data.find_part(id) != nullptr) f.fail("PID", fmt::format("expected a number that no *PART has, got {}", id));
    data.give_once(block, fmt::format("nodal rigid body {}", id), card.place);
    const MeshSet* members = find_set(data.mesh.node_sets, std::to_string(set_number(block, set)));
    if (members == nullptr) f.fail("NSID", fmt::format("no *SET_NODE has the number {}", set));
    if (std::ranges::none_of(members->members, [&](std::int32_t node) { return data.used[node]; }))
      return data.report.unused(card.place, fmt::format("{} {}", block.star_name(), id),
                                "no solid has one of its nodes");
    if (data.reject_rigid_nodes(members->members, card.place, block.star_name(),
                                "give these nodes to the part by *CONSTRAINED_EXTRA_NODES"))
      return;
    const auto body = scene.entry<RigidBody>("rigid_body", card_of(block, card.place));
    body.set("name", name_of_nodal_rigid(id), "pid");
    const auto nodes = scene.entry<AttachedNodes>("rigid_nodes", card_of(block, card.place));
    nodes.set("rigid_body", name_of_nodal_rigid(id), "pid");
    set_target(block, true, set, nodes);
    data.report.understood(fmt::format("{} ({}): the nodes of set {} move as one, with the masses of their elements",
                                       block.star_name(), card.place.text(), set));
  });
}

}  // namespace pinball
