#include <fmt/format.h>

#include <algorithm>

#include "abaqus_parts.hpp"

/// Analytical surfaces of rigid bodies: one straight line, drawn along an axis without end, is a rigid wall.
namespace pinball {

namespace {

/// The *SURFACE of this name in a component. Throws InputError where there is none.
const AbaqusBlock& surface_of(const AbaqusComponent& component, const std::string& name, const DeckPlace& place) {
  const auto is_it = [&](const AbaqusBlock* block) {
    return block->name == "SURFACE" && label_key(block->value("NAME").value_or("")) == label_key(name);
  };
  const auto found = std::ranges::find_if(component.blocks, is_it);
  if (found == component.blocks.end()) fail_at(place, fmt::format("there is no *SURFACE {} beside it", name));
  return **found;
}

/// Where its line begins and ends, in the plane of the first two axes; nothing where it is more than one straight line,
/// which is refused.
std::optional<std::array<Point, 2>> line_of(AbaqusData& data, const AbaqusBlock& surface) {
  std::vector<Point> points;
  bool straight = surface.option("TYPE") == "CYLINDER";
  DataLines lines(surface);
  while (const auto card = lines.next()) {
    const DataFields f(*card);
    const std::string kind = squeezed(f.text(0));
    straight = straight && kind == (points.empty() ? "START" : "LINE");
    if (straight) points.push_back({f.number(1, "x", 0.0), f.number(2, "y", 0.0), 0.0});
  }
  if (straight && points.size() == 2) {
    if (points[0] == points[1]) fail_at(surface.place, "*SURFACE, TYPE=CYLINDER: expected a line with a length");
    return std::array{points[0], points[1]};
  }
  if (surface.log != nullptr) surface.log->done(&surface);
  data.report.reject(surface.place, "*SURFACE of a rigid body that is not one straight line of TYPE=CYLINDER",
                     "solids in its place; axes of its own are not read");
  return {};
}

Point along(const Point& from, const Point& to) {
  const Point way = minus(to, from);
  const double length = norm(way);
  return {way[0] / length, way[1] / length, way[2] / length};
}

}  // namespace

void AbaqusData::add_wall(const AbaqusComponent& component, const AbaqusBlock& block) {
  const std::string name = block.require("ANALYTICALSURFACE");
  const auto line = line_of(*this, surface_of(component, name, block.place));
  if (!line) return;
  const auto& [start, end] = *line;
  // The free side is to the left of the line, seen against the third axis.
  const Point left{start[0] - (end[1] - start[1]), start[1] + (end[0] - start[0]), 0.0};
  const auto& placement = component.placement;
  AbaqusWall wall{card_of(block, block.place), {}, placement.apply(start), {}, {}, 0};
  wall.keys.insert(label_key(name));
  if (!component.name.empty()) wall.keys.insert(label_key(component.name + '.' + name));
  wall.normal = along(wall.point, placement.apply(left));
  wall.edge = along(wall.point, placement.apply(end));
  wall.length = norm(minus(end, start));
  walls.push_back(std::move(wall));
}

AbaqusWall* AbaqusData::wall(const std::string& label) {
  const std::string key = label_key(label);
  const auto found = std::ranges::find_if(walls, [&](const AbaqusWall& wall) { return wall.keys.contains(key); });
  return found == walls.end() ? nullptr : &*found;
}

DeckKeys<RigidWall> begin_wall(AbaqusData& data, AbaqusWall& wall, DeckScene& scene) {
  const auto keys = scene.entry<RigidWall>("rigid_wall", wall.card);
  keys.set("point", wall.point);
  keys.set("normal", wall.normal);
  keys.set("edge", wall.edge);
  keys.set("size", std::vector<double>{wall.length, 0.0});
  if (!wall.is_used)
    data.report.understood(
        fmt::format("{}: a rigid wall, which nodes meet on the side to the left of its line", wall.card.text()));
  wall.is_used = true;
  return keys;
}

void tell_unused_walls(AbaqusData& data) {
  for (const AbaqusWall& wall : data.walls) {
    if (!wall.is_used) data.report.unused(wall.card.place, "*RIGID BODY, ANALYTICAL SURFACE", "no contact has it");
  }
}

}  // namespace pinball
