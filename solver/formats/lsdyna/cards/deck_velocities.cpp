#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "boundary_keys.hpp"
#include "deck_parts.hpp"

namespace pinball {

namespace {

using VelocityKeys = DeckKeys<InitialVelocity>;

VelocityKeys begin_velocity(const KeywordBlock& block, const DeckPlace& place, const Point& velocity,
                            DeckScene& scene) {
  auto keys = scene.entry<InitialVelocity>("initial_velocity", card_of(block, place));
  keys.set("velocity", velocity);
  return keys;
}

/// IRIGID: whether velocities of nodes count before those of *PART_INERTIA.
void take_irigid(DeckData& data, const KeywordBlock& block, const Fields& f) {
  if (f.integer("IRIGID") == 0) return;
  if (data.inertia.empty()) {
    data.report.unused(f.place(), block.star_name() + ": IRIGID", "no part has a *PART_INERTIA");
  } else {
    data.report.reject(f.place(), block.star_name() + " with IRIGID",
                       "give the rigid part its velocity by *INITIAL_VELOCITY_RIGID_BODY");
  }
}

}  // namespace

bool gives_velocity_of_nodes(const KeywordBlock& block) { return block.name == "INITIAL_VELOCITY_NODE"; }

void tell_order_of_velocities(DeckData& data) {
  std::vector<std::string> names;
  for (const KeywordBlock& block : data.deck.blocks) {
    if (block.name == "INITIAL_VELOCITY_RIGID_BODY" || gives_velocity_of_nodes(block)) continue;  // they count before
    if (block.name.starts_with("INITIAL_VELOCITY") && std::ranges::find(names, block.star_name()) == names.end())
      names.push_back(block.star_name());
  }
  if (names.size() > 1)
    data.report.understood(fmt::format("{}: of a node that several of them have, the last one in the deck counts",
                                       fmt::join(names, ", ")));
}

namespace {

/// Bodies that are not in the set NSIDEX with all of their nodes.
std::vector<std::string> bodies_with_nodes_outside(const DeckData& data, const KeywordBlock& block, const Fields& f) {
  const std::int64_t without = f.integer("NSIDEX");
  const MeshSet* set =
      without == 0 ? nullptr : find_set(data.mesh.node_sets, std::to_string(set_number(block, without)));
  if (set == nullptr) return all_bodies(data);
  std::vector<bool> outside(data.mesh.parts.size(), false), left_out(data.used.size(), false);
  for (const std::int32_t node : set->members) left_out[node] = true;
  for (std::size_t e = 0; e < data.mesh.part.size(); ++e) {
    for (const std::int32_t node : data.mesh.mesh.hexahedra[e])
      outside[data.mesh.part[e]] = outside[data.mesh.part[e]] || !left_out[node];
  }
  std::vector<std::string> bodies;
  for (const DeckPart& part : data.parts) {
    const auto place = std::ranges::find(data.mesh.parts, part.id, &MeshPart::id) - data.mesh.parts.begin();
    if (outside[place]) bodies.push_back(part.body);
  }
  return bodies;
}

}  // namespace

/// Set, and then velocity; with NSIDEX that of the nodes that are left out, too.
void translate_initial_velocity(DeckData& data, const KeywordBlock& block, DeckScene& scene) {
  Cards cards(block);
  const Card head = cards.require("the set of nodes");
  const Card card = cards.require("the velocity");
  const Fields f = data.fields(head, layout::velocity_nodes);
  take_irigid(data, block, f);
  const auto velocity_of = [&](const Fields& numbers) {
    return in_system(data, block, f.integer("ICID"), numbers.point(numbers.name(0)), head.place);
  };
  const Point velocity = velocity_of(data.fields(card, layout::velocity));
  if (f.integer("NSID") == 0 && f.integer("BOXID") == 0) {
    for (const std::string& body : bodies_with_nodes_outside(data, block, f)) {
      const VelocityKeys keys = begin_velocity(block, block.place, velocity, scene);
      keys.set("body", body);
      set_selection(data, block, f, keys);
    }
  } else {
    set_selection(data, block, f, begin_velocity(block, block.place, velocity, scene));
  }
  const Card last = cards.next_or_blank();
  const Fields exempt = data.fields(last, layout::velocity_exempt);
  const std::int64_t others = f.integer("NSIDEX");
  if (others == 0) return;
  begin_velocity(block, block.place, velocity_of(exempt), scene)
      .set("set", std::to_string(set_number(block, others)), "nsidex");
}

void translate_initial_velocity_of_nodes(DeckData& data, const KeywordBlock& block, DeckScene& scene) {
  struct Given {
    Point velocity;
    DeckPlace place;
  };
  std::map<std::int64_t, Given> last;  // of each node
  for_each_card(block, [&](const Card& card) {
    const Fields f = data.fields(card, layout::velocity_node);
    const Given given{in_system(data, block, f.integer("ICID"), f.point("VX"), card.place), card.place};
    const std::int64_t number = node_number(block, f.integer("NID"));
    const auto [found, is_new] = last.try_emplace(number, given);
    if (!is_new && found->second.velocity != given.velocity)
      data.report.unused(found->second.place, block.star_name() + " of a node that has another one behind it");
    found->second = given;
  });
  NodesByKind<Point> nodes(data);
  for (const auto& [number, given] : last) nodes.add(block, given.place, number, given.velocity);
  for (const auto& [velocity, of_velocity] : nodes.all())
    begin_velocity(block, block.place, velocity, scene).set("nodes", of_velocity.numbers, "node");
}

namespace {

/// A velocity and a spin about an axis.
struct Motion {
  Point velocity{}, angular_velocity{}, centre{};
};

/// The axis of a spin: NX, NY, NZ through XC, YC, ZC, or, where NX is -999, through node NY to node NZ. centre: a point
/// on it.
Point axis_of(DeckData& data, const KeywordBlock& block, const Fields& f, std::int64_t system, Point& centre) {
  Point axis = f.point("NX");
  centre = f.point("XC");
  if (axis[0] == -999) {
    Point ends[2];
    for (std::size_t i = 0; i < 2; ++i) {
      const std::int64_t node = node_number(block, f.integer(i == 0 ? "NY" : "NZ"));
      const std::int32_t place = data.nodes.find(node);
      if (place < 0) fail_at(f.place(), fmt::format("{}: node {} is not there", block.star_name(), node));
      ends[i] = data.mesh.mesh.nodes[place];
    }
    axis = minus(ends[1], ends[0]);
    system = 0;
    if (centre != Point{})
      data.report.unused(f.place(), block.star_name() + ": XC, YC, ZC", "NX is -999: the axis goes through node NY");
    centre = ends[0];
  }
  const double length = norm(axis);
  if (!(length > 0)) fail_at(f.place(), block.star_name() + ": expected the axis of the spin (NX, NY, NZ)");
  for (double& component : axis) component /= length;
  return in_system(data, block, system, axis, f.place());
}

/// Of the two cards of a generation; the spin needs the second one.
Motion motion_of(DeckData& data, const KeywordBlock& block, const Fields& f, const Fields& spin) {
  const std::int64_t system = f.integer("ICID");
  Motion motion;
  motion.velocity = in_system(data, block, system, f.point("VX"), f.place());
  const double omega = f.number("OMEGA");
  if (omega == 0) return motion;
  motion.angular_velocity = axis_of(data, block, spin, system, motion.centre);
  for (double& component : motion.angular_velocity) component *= omega;
  return motion;
}

void add_motion(const KeywordBlock& block, const DeckPlace& place, const Motion& motion, KeyOf<InitialVelocity> key,
                const std::string& value, DeckScene& scene) {
  const VelocityKeys keys = begin_velocity(block, place, motion.velocity, scene);
  keys.set(key, value, "id");
  if (motion.angular_velocity == Point{}) return;
  keys.set("angular_velocity", motion.angular_velocity, "omega");
  keys.set("centre", motion.centre, "xc, yc, zc");
}

/// IVATN 1: also the parts that are merged with these.
void add_merged(DeckData& data, const Fields& f, const std::string& star_name, std::vector<std::int64_t>& parts) {
  if (f.integer("IVATN") == 0) return;
  const std::size_t named = parts.size();
  for (std::size_t i = 0; i < named; ++i) {
    const DeckPart* part = data.find_part(parts[i]);
    for (const DeckPart& other : data.parts) {
      if (part != nullptr && part->is_rigid() && other.lead == part->lead && other.id != part->id)
        parts.push_back(other.id);
    }
  }
  if (parts.size() == named)
    data.report.unused(f.place(), star_name + ": IVATN", "no other part is merged with one of these");
}

}  // namespace

/// Two cards each; the second one, of the spin, may be blank.
void translate_velocity_generation(DeckData& data, const KeywordBlock& block, DeckScene& scene) {
  Cards cards(block);
  while (const auto card = cards.next_filled()) {
    const Card second = cards.next_or_blank();
    const Fields f = data.fields(*card, layout::velocity_generation), spin = data.fields(second, layout::velocity_axis);
    const Motion motion = motion_of(data, block, f, spin);
    take_irigid(data, block, spin);
    const std::int64_t id = f.integer("ID"), kind = id == 0 ? 0 : f.integer("STYP");
    std::vector<std::int64_t> parts;
    std::vector<std::string> bodies;
    if (id == 0) {
      bodies = all_bodies(data);
    } else if (kind == 1) {
      parts = data.part_set(set_number(block, id), card->place);
    } else if (kind == 2) {
      parts = {id + offset_of(block, &DeckTransform::part)};
    } else if (kind == 3) {
      add_motion(block, card->place, motion, "set", std::to_string(set_number(block, id)), scene);
    } else {
      f.fail("STYP", fmt::format("expected 1, 2 or 3, got {}", kind));
    }
    if (!parts.empty()) {
      add_merged(data, f, block.star_name(), parts);
      bodies = bodies_of(data, parts, card->place);
    }
    for (const std::string& body : bodies) add_motion(block, card->place, motion, "body", body, scene);
  }
}

}  // namespace pinball
