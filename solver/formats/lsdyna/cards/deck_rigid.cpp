#include <fmt/format.h>

#include <algorithm>

#include <solver/formats/lsdyna/layouts/rigid_cards.hpp>

#include "boundary_keys.hpp"
#include "deck_parts.hpp"

namespace pinball {

namespace {

/// What CMO, CON1 and CON2 of a *MAT_RIGID hold.
struct RigidHeld {
  GivenArray along, about;
  DeckPlace place;
  bool is_used = false;  ///< of a part that leads

  bool any() const { return !along.empty() || !about.empty(); }
};

/// CON1 and CON2 of CMO 1: directions by their bits x, y, z.
GivenArray global_directions(const Fields& f, const char* name) {
  static constexpr unsigned directions_of_code[8] = {0, 1, 2, 4, 3, 6, 5, 7};
  const std::int64_t code = f.integer(name);
  if (code < 0 || code > 7) f.fail(name, fmt::format("expected 0 to 7, got {}", code));
  GivenArray directions;
  for (unsigned k = 0; k < 3; ++k) {
    if ((directions_of_code[code] >> k & 1U) != 0) directions.push_back(given(std::string(1, "xyz"[k])));
  }
  return directions;
}

/// CMO -1: CON1 is a system, and CON2 six digits, one for each direction along and about its axes.
void add_local_directions(const DeckData& data, const KeywordBlock& block, const Fields& f, RigidHeld& held) {
  const std::array<Point, 3> axes = data.axes(definition_number(block, f.integer("CON1")), f.place());
  std::int64_t rest = f.integer("CON2"), power = 100'000;
  const std::int64_t code = rest;
  for (std::size_t i = 0; i < 6; ++i, power /= 10) {
    const std::int64_t digit = rest / power;
    if (digit < 0 || digit > 1 || rest < 0) f.fail("CON2", fmt::format("expected six digits of 0 and 1, got {}", code));
    rest %= power;
    if (digit == 1) (i < 3 ? held.along : held.about).push_back(given(axes[i % 3]));
  }
}

RigidHeld read_held(const DeckData& data, const KeywordBlock& block) {
  Cards cards(block);
  if (block.title) cards.next();
  cards.next();
  const Card constraint = cards.next_or_blank(), system = cards.next_or_blank();
  const Fields f = data.fields(constraint, layout::rigid_held);
  data.fields(system, layout::rigid_system);
  RigidHeld held;
  held.place = constraint.place;
  const double option = f.number("CMO");
  if (option == 1) {
    held.along = global_directions(f, "CON1");
    held.about = global_directions(f, "CON2");
  } else if (option == -1) {
    add_local_directions(data, block, f, held);
  } else if (option != 0) {
    f.fail("CMO", fmt::format("expected 1, 0 or -1, got {}", option));
  }
  return held;
}

/// A velocity of the centre and a rotation, and the card that they are of.
struct RigidVelocity {
  Point velocity{}, angular_velocity{};
  DeckCard card;
};

void set_inertia(const DeckInertia& given, DeckKeys<RigidBody>& keys) {
  keys.from(given.card);
  keys.set("mass", given.mass, "tm");
  keys.set("centre", given.centre, "xc, yc, zc");
  keys.set("inertia", given_list(given.inertia), "ixx to izz");
}

/// *INITIAL_VELOCITY_RIGID_BODY, by leading parts.
std::map<std::int64_t, RigidVelocity> read_velocities(DeckData& data) {
  std::map<std::int64_t, RigidVelocity> all;
  for (const KeywordBlock* block : data.blocks_of("INITIAL_VELOCITY_RIGID_BODY")) {
    for_each_card(*block, [&](const Card& card) {
      const Fields f = data.fields(card, layout::velocity_rigid);
      const std::int64_t id = f.integer("PID") + offset_of(*block, &DeckTransform::part), system = f.integer("ICID");
      RigidVelocity given{in_system(data, *block, system, f.point("VX"), card.place),
                          in_system(data, *block, system, f.point("VXR"), card.place), card_of(*block, card.place)};
      if (!data.body_of(id, card.place))
        return data.report.unused(card.place, fmt::format("{} of part {}", block->star_name(), id), "it has no solids");
      const std::int64_t lead = data.find_part(id)->lead;
      if (lead == 0)
        fail_at(card.place, fmt::format("{}: part {} is not rigid: *INITIAL_VELOCITY_GENERATION gives it a velocity",
                                        block->star_name(), id));
      data.give_once(*block, fmt::format("the velocity of the rigid part {}", lead), card.place);
      all[lead] = std::move(given);
    });
  }
  return all;
}

/// Nodes that rigid shells share with solids move with the body of the shells.
void attach_nodes_of_shells(DeckData& data, DeckScene& scene) {
  std::map<std::int64_t, std::vector<std::int64_t>> nodes;
  for (const LayerNodes& layer : data.mesh.layers) {
    std::vector<std::int64_t>& own = nodes[data.find_part(data.mesh.parts[layer.part].id)->lead];
    const std::int64_t number = data.mesh.node_ids[layer.middle];
    if (data.used[layer.middle] && (own.empty() || own.back() != number)) own.push_back(number);
  }
  for (auto& [lead, numbers] : nodes) {
    if (numbers.empty()) continue;
    const DeckPart& part = *data.find_part(lead);
    if (data.inertia.contains(lead))
      data.report.reject(part.place, "shells of a part with *PART_INERTIA that share nodes with solids",
                         "give the part its mass by its density");
    std::ranges::sort(numbers);
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    const auto keys = scene.entry<AttachedNodes>("rigid_nodes", {"*ELEMENT_SHELL", part.place});
    keys.set("rigid_body", part.body);
    keys.set("nodes", numbers);
  }
}

}  // namespace

void translate_rigid_bodies(DeckData& data, DeckScene& scene) {
  std::map<std::int64_t, RigidHeld> held_by;
  for (const auto& [number, block] : data.rigid_materials) {
    if (data.is_used(number)) held_by[number] = read_held(data, *block);
  }
  const std::map<std::int64_t, RigidVelocity> velocities = read_velocities(data);
  for (const DeckPart& part : data.parts) {
    if (!part.is_rigid()) continue;
    if (part.hourglass != 0)
      data.report.unused(part.place, "*PART: HGID of rigid parts", "they have no hourglass modes");
    if (part.lead != part.id) continue;
    const KeywordBlock& block = *data.rigid_materials.at(part.material);
    RigidHeld& held = held_by[part.material];
    held.is_used = true;
    auto keys = scene.entry<RigidBody>("rigid_body", card_of(block, held.place));
    keys.set("name", part.body);
    keys.set("bodies", data.bodies_with(part.id));
    if (!held.along.empty()) keys.set("held", held.along, "con1");
    if (!held.about.empty()) keys.set("held_rotations", held.about, "con2");
    const auto inertia = data.inertia.find(part.id);
    const bool has_inertia = inertia != data.inertia.end();
    if (has_inertia) set_inertia(inertia->second, keys);
    if (const auto given = velocities.find(part.id); given != velocities.end()) {
      keys.from(given->second.card);
      keys.set("velocity", given->second.velocity, "vx, vy, vz");
      keys.set("angular_velocity", given->second.angular_velocity, "vxr, vyr, vzr");
      if (has_inertia && (inertia->second.velocity != Point{} || inertia->second.angular_velocity != Point{}))
        data.report.unused(inertia->second.card.place, "*PART_INERTIA: VTX to VRZ",
                           "*INITIAL_VELOCITY_RIGID_BODY counts");
    } else if (has_inertia) {
      keys.set("velocity", inertia->second.velocity, "vtx, vty, vtz");
      keys.set("angular_velocity", inertia->second.angular_velocity, "vrx, vry, vrz");
      data.report.understood(
          fmt::format("part {}: its velocities are those of *PART_INERTIA ({}), whatever those of its "
                      "nodes",
                      part.id, inertia->second.card.place.text()));
    }
  }
  attach_nodes_of_shells(data, scene);
  for (const auto& [number, held] : held_by) {
    if (!held.is_used && held.any())
      data.report.unused(held.place, "*MAT_RIGID: CON1, CON2",
                         "of a part that is merged into another one those of the other one hold");
  }
}

void translate_extra_nodes(DeckData& data, const KeywordBlock& block, DeckScene& scene) {
  const bool set = block.name.ends_with("_SET");
  for_each_card(block, [&](const Card& card) {
    const Fields f = data.fields(card, set ? layout::attached_set : layout::attached_node);
    const std::int64_t id = f.integer("PID") + offset_of(block, &DeckTransform::part);
    const std::string what = fmt::format("{} of part {}", block.star_name(), id);
    if (!data.body_of(id, card.place)) return data.report.unused(card.place, what, "it has no solids");
    const std::int64_t lead = data.find_part(id)->lead;
    if (lead == 0)
      fail_at(card.place, fmt::format("{}: part {} is not rigid: give it a *MAT_RIGID", block.star_name(), id));
    if (data.inertia.contains(lead))
      return data.report.reject(card.place, block.star_name() + " of a part with *PART_INERTIA",
                                "give the nodes to the part by solids that have them");
    const std::size_t of_set = 1;
    const std::vector<std::int32_t> nodes = nodes_of_card(data, block, set, f, of_set);
    const auto is_idle = [&](std::int32_t node) { return node >= 0 && !data.used[node]; };
    if (!nodes.empty() && std::ranges::all_of(nodes, is_idle))  // what is not there is said elsewhere
      return data.report.unused(card.place, what, "they are nodes of no solid, which joints alone know");
    const auto keys = scene.entry<AttachedNodes>("rigid_nodes", card_of(block, card.place));
    keys.set("rigid_body", data.find_part(lead)->body, "pid");
    set_target(block, set, f.integer(of_set), keys);
  });
}

}  // namespace pinball
