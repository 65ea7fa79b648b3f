#include <fmt/format.h>

#include "boundary_text.hpp"
#include "deck_parts.hpp"

namespace pinball {

namespace {

/// A rectangle: head of its first side, and the lengths of both; 0: without end.
void write_rectangle(const Fields& f, const Point& corner, TomlText& scene) {
  const std::vector<double> size{f.number(3, "lenl", 0.0), f.number(4, "lenm", 0.0)};
  if (size[0] == 0 && size[1] == 0) return;
  scene.key("edge", minus(point_of(f, 0, "edge"), corner));
  scene.key("size", size);
}

/// MASS and V0, along the normal.
void write_mass(const Fields& f, const KeywordBlock& block, TomlText& scene) {
  const double mass = f.number(0, "mass", 0.0);
  if (!(mass > 0)) fail_at(f.place(), fmt::format("{}: mass: expected a number > 0, got {}", block.star_name(), mass));
  scene.key("mass", mass);
  scene.key("speed", f.number(1, "v0", 0.0));
}

/// FRIC: a coefficient below 1; 1: nodes do not slide; 2 and 3, nodes that stick, are not there.
void write_friction(DeckData& data, const KeywordBlock& block, const Fields& plane, TomlText& scene) {
  const double friction = plane.number(6, "fric", 0.0);
  if (friction == 1) {
    scene.key("sliding", false);
  } else if (friction < 1) {
    scene.key("friction", friction);
  } else {
    data.report.refuse(plane.place(), block.star_name() + " with nodes that stick (FRIC > 1)");
  }
}

}  // namespace

void translate_rigid_wall(DeckData& data, const KeywordBlock& block, std::size_t number, TomlText& scene) {
  Cards cards(block);
  if (block.id) cards.next();
  const Card head = cards.require("the nodes of the wall");
  const Card card = cards.require("the plane of the wall");
  const Fields f = data.fields(head), plane = data.fields(card);
  const Point point = point_of(plane, 0, "tail");
  write_head("rigid_wall", block, block.place, scene);
  scene.key("name", fmt::format("wall_{}", number));
  scene.key("point", point);
  scene.key("normal", minus(point_of(plane, 3, "head"), point));
  write_friction(data, block, plane, scene);
  write_selection(data, block, f, scene);
  write_span(span_of(f, 4, 5), scene);
  if (f.number(3, "offset", 0.0) > 0)
    data.report.understood(fmt::format("{} ({}): nodes further from the wall than OFFSET are looked at, too",
                                       block.star_name(), head.place.text()));
  if (block.name.find("_FINITE") != std::string::npos) {
    const Card rectangle = cards.require("the rectangle of the wall");
    write_rectangle(data.fields(rectangle), point, scene);
  }
  if (block.name.find("_MOVING") != std::string::npos) {
    const Card mass = cards.require("the mass of the wall");
    write_mass(data.fields(mass), block, scene);
  }
}

}  // namespace pinball
