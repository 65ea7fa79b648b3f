#include <fmt/format.h>

#include <algorithm>

#include <solver/formats/radioss/layouts/radioss_boundary_cards.hpp>

#include "radioss_keys.hpp"

namespace pinball {

namespace {

/// Nodes of a group, and those on the free side within a distance at the start, without those of another.
std::vector<std::int64_t> nodes_of_wall(const RadiossData& data, const RadiossFields& f, double distance,
                                        const Point& point, const Point& normal, bool& is_group) {
  const std::int64_t with = f.integer("grnd_ID1"), without = f.integer("grnd_ID2");
  std::vector<bool> takes(data.used.size(), false);
  for (std::size_t n = 0; n < takes.size(); ++n) {
    const double height = dot(minus(data.mesh.mesh.nodes[n], point), normal);
    takes[n] = distance > 0 && height >= 0 && height <= distance;
  }
  if (with != 0) {
    for (const std::int32_t node : data.node_group(with, f.place()).members) takes[node] = true;
  }
  if (without != 0) {
    for (const std::int32_t node : data.node_group(without, f.place()).members) takes[node] = false;
  }
  is_group = with != 0 && without == 0 && !(distance > 0);
  std::vector<std::int64_t> numbers;
  for (std::size_t n = 0; n < takes.size(); ++n) {
    if (takes[n] && data.used[n]) numbers.push_back(data.mesh.node_ids[n]);
  }
  if (numbers.empty())
    f.fail("grnd_ID1", "expected nodes of solids: no group has any, and none is within d of the wall");
  return numbers;
}

void set_friction(const RadiossFields& f, const RadiossFields& friction, RadiossData& data, const RadiossBlock& block,
                  const DeckKeys<RigidWall>& keys) {
  const std::int64_t slide = f.integer("Slide");
  const double coefficient = friction.number("fric");
  if (slide == 1) keys.set("sliding", false, "Slide");
  if (slide == 2) keys.set("friction", coefficient, "fric");
  if (slide != 2 && coefficient != 0)
    data.report.unused(friction.place(), block.title + ": fric", "it counts with Slide 2");
}

/// A wall with a node is pushed along its normal; what it does along itself, nobody sees.
Point set_moving(RadiossData& data, const RadiossBlock& block, const RadiossFields& f, const RadiossFields& moving,
                 const Point& head, const DeckKeys<RigidWall>& keys) {
  const std::int32_t node = data.nodes.find(f.integer("node_ID"));
  if (node < 0) f.fail("node_ID", fmt::format("node {} is not there", f.integer("node_ID")));
  if (data.used[node]) data.report.reject(f.place(), block.title + " with a node of a solid", "give a node of its own");
  data.wall_nodes.insert(node);
  const Point point = data.mesh.mesh.nodes[node];
  const Point normal = radioss_unit(minus(head, point), f.place()), velocity = moving.point("VX0");
  const double mass = moving.number("Mass");
  if (!(mass > 0)) moving.fail("Mass", fmt::format("expected more than 0, got {}", mass));
  keys.set("mass", mass, "Mass");
  keys.set("speed", dot(velocity, normal), "VX0, VY0, VZ0");
  if (f.integer("Slide") != 0)
    data.report.reject(f.place(), block.title + " with a node that sticks or rubs",
                       "give Slide 0: it moves along its "
                       "normal alone");
  return point;
}

void translate_wall(RadiossData& data, const RadiossBlock& block, DeckScene& scene) {
  RadiossLines lines(block);
  const DataLine l1 = lines.require("the nodes of the wall"), l2 = lines.require("the distance of its nodes"),
                 l3 = lines.require("a point of the wall"), l4 = lines.require("the head of its normal");
  const RadiossFields f(l1, block, radioss::wall_nodes), friction(l2, block, radioss::wall_friction),
      tail(l3, block, f.integer("node_ID") == 0 ? radioss::wall_point : radioss::wall_mass),
      head(l4, block, radioss::wall_head);
  const auto keys = scene.entry<RigidWall>("rigid_wall", card_of(block, block.place));
  keys.comment(lines.title());
  keys.set("name", fmt::format("wall_{}", block.numbers.empty() ? ++data.walls : block.id()));
  const Point end = head.point("XM1"),
              point = f.integer("node_ID") == 0 ? tail.point("XM") : set_moving(data, block, f, tail, end, keys);
  const Point normal = radioss_unit(minus(end, point), l4.place);
  keys.set("point", point, "XM, YM, ZM");
  keys.set("normal", normal, "XM1, YM1, ZM1");
  set_friction(f, friction, data, block, keys);
  bool is_group = false;
  const auto numbers = nodes_of_wall(data, f, friction.number("d"), point, normal, is_group);
  if (is_group) {
    keys.set("set", std::to_string(f.integer("grnd_ID1")), "grnd_ID1");
  } else if (static_cast<std::ptrdiff_t>(numbers.size()) != std::ranges::count(data.used, true)) {
    keys.set("nodes", numbers, "d, grnd_ID1, grnd_ID2");
  }
}

}  // namespace

void translate_radioss_walls(RadiossData& data, DeckScene& scene) {
  for (const RadiossBlock& block : data.deck.blocks) {
    if (block.name == "RWALL/PLANE") translate_wall(data, block, scene);
  }
}

}  // namespace pinball
