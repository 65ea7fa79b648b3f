#include <fmt/format.h>

#include "boundary_keys.hpp"
#include "deck_parts.hpp"

namespace pinball {

namespace {

constexpr const char* hold_rigid = "hold the part by CMO, CON1 and CON2 of its *MAT_RIGID";

/// Directions that are held, by their bits x, y, z, the local system that they are of, and when.
struct Held {
  unsigned directions = 0;
  std::int64_t system = 0;
  DeckSpan when{};
  auto operator<=>(const Held&) const = default;
};

/// The keys of a constraint, but for its nodes.
void set_held(const DeckData& data, const Held& held, const DeckPlace& place, const DeckKeys<FixedConstraint>& keys) {
  const std::array<Point, 3> axes = data.axes(held.system, place);
  GivenArray directions;
  for (unsigned k = 0; k < 3; ++k) {
    if ((held.directions >> k & 1U) == 0) continue;
    directions.push_back(held.system == 0 ? given(std::string(1, "xyz"[k])) : given(axes[k]));
  }
  keys.set("type", "fixed");
  if (last_card(data, "DATABASE_SPCFORC")) keys.set("name", "spc");
  keys.set("directions", directions);
  set_span(held.when, keys);
}

/// What the numbers behind that of a node or a set say; nothing for rotations alone.
Held held_of(const Fields& f, const KeywordBlock& block) {
  Held held;
  held.system = definition_number(block, f.integer("CID"));
  for (unsigned k = 0; k < 3; ++k) {
    static constexpr std::array<const char*, 3> names{"DOFX", "DOFY", "DOFZ"};
    if (f.integer(names[k]) != 0) held.directions |= 1U << k;
  }
  return held;
}

}  // namespace

void translate_node_codes(DeckData& data, DeckScene& scene) {
  std::map<unsigned, std::vector<std::int64_t>> nodes;
  LeftOut left_out;
  const auto blocks = data.blocks_of("NODE");
  const DeckPlace of_nodes = blocks.empty() ? DeckPlace{} : blocks.front()->place;
  for (std::size_t n = 0; n < data.mesh.held.size(); ++n) {
    if (data.mesh.held[n] == 0) continue;
    if (data.reject_rigid_nodes({static_cast<std::int32_t>(n)}, of_nodes, "TC of *NODE", hold_rigid)) {
      continue;
    }
    if (data.used[n]) {
      nodes[data.mesh.held[n]].push_back(data.mesh.node_ids[n]);
    } else {
      left_out.add(data.mesh.node_ids[n]);
    }
  }
  if (left_out.count > 0)
    data.report.understood(fmt::format("*NODE: TC of {} node{} of no solid is not used, the first is node {}",
                                       left_out.count, left_out.count == 1 ? "" : "s", left_out.first));
  if (data.mesh.held_rotations > 0)
    data.report.understood(fmt::format("*NODE: RC of {} node{} is not used: nodes of solids have no rotations",
                                       data.mesh.held_rotations, data.mesh.held_rotations == 1 ? "" : "s"));
  for (const auto& [directions, numbers] : nodes) {
    const auto keys = scene.entry<FixedConstraint>("constraint", {});
    keys.comment("TC of *NODE");
    set_held(data, {directions, 0, {}}, {}, keys);
    keys.set("nodes", numbers);
  }
}

namespace {

/// Constraints of sets become tables at once, those of nodes are gathered.
void read_constraints(DeckData& data, const KeywordBlock& block, NodesByKind<Held>& nodes, DeckScene& scene) {
  const bool set = block.name.starts_with("BOUNDARY_SPC_SET"), spans = block.name.ends_with("_BIRTH_DEATH");
  for_each_card(block, [&](const Card& card, Cards& cards) {
    const Fields f = data.fields(card, set ? layout::held_set : layout::held_node);
    Held held = held_of(f, block);
    if (spans) {
      const Card span = cards.next_or_blank();
      held.when = span_of(data.fields(span, layout::held_span));
    }
    if (held.directions == 0) {
      f.integer(set ? "NSID" : "NID");
      data.report.unused(card.place, block.star_name(), "it holds no direction of a node of a solid");
      return;
    }
    const auto nodes_held = nodes_of_card(data, block, set, f);
    if (data.reject_rigid_nodes(nodes_held, card.place, block.star_name(), hold_rigid)) return;
    if (set) {
      const auto keys = scene.entry<FixedConstraint>("constraint", card_of(block, card.place));
      set_held(data, held, card.place, keys);
      set_target(block, true, f.integer("NSID"), keys);
    } else {
      nodes.add(block, card.place, node_number(block, f.integer("NID")), held);
    }
  });
}

}  // namespace

void translate_single_point_constraints(DeckData& data, DeckScene& scene) {
  NodesByKind<Held> nodes(data);
  for (const KeywordBlock& block : data.deck.blocks) {
    if (block.name.starts_with("BOUNDARY_SPC_")) read_constraints(data, block, nodes, scene);
  }
  for (const auto& [held, of_kind] : nodes.all()) {
    const auto keys = scene.entry<FixedConstraint>("constraint", {"*BOUNDARY_SPC_NODE", of_kind.first});
    set_held(data, held, of_kind.first, keys);
    keys.set("nodes", of_kind.numbers, "node");
  }
}

}  // namespace pinball
