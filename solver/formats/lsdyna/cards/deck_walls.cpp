#include <fmt/format.h>

#include <optional>

#include "boundary_text.hpp"
#include "deck_parts.hpp"

namespace pinball {

namespace {

/// A rectangle: head of its first side, and the lengths of both; 0: without end.
void write_rectangle(const Fields& f, const Point& corner, TomlText& scene) {
  const std::vector<double> size{f.number("LENL"), f.number("LENM")};
  if (size[0] == 0 && size[1] == 0) return;
  scene.key("edge", minus(f.point("XHEV"), corner));
  scene.key("size", size);
}

/// MASS and V0, along the normal.
void write_mass(const Fields& f, TomlText& scene) {
  const double mass = f.number("MASS");
  if (!(mass > 0)) f.fail("MASS", fmt::format("expected a number > 0, got {}", mass));
  scene.key("mass", mass);
  scene.key("speed", f.number("V0"));
}

/// FRIC: a coefficient below 1; 1: nodes do not slide; 2 and 3, nodes that stick, are not there.
void write_friction(DeckData& data, const KeywordBlock& block, const Fields& plane, TomlText& scene) {
  const double friction = plane.number("FRIC");
  if (friction == 1) {
    scene.key("sliding", false);
  } else if (friction < 1) {
    scene.key("friction", friction);
  } else {
    data.report.refuse(plane.place(), block.star_name() + " with nodes that stick (FRIC > 1)", "1: nodes do not slide");
  }
}

/// A point of the wall: a corner, where it is a rectangle.
Point write_wall(DeckData& data, const KeywordBlock& block, const Card& head, const Card& card, std::size_t number,
                 TomlText& scene) {
  const Fields f = data.fields(head, layout::wall_nodes), plane = data.fields(card, layout::wall_plane);
  const Point point = plane.point("XT");
  scene.key("name", fmt::format("wall_{}", number));
  scene.key("point", point);
  scene.key("normal", minus(plane.point("XH"), point));
  write_friction(data, block, plane, scene);
  write_selection(data, block, f, scene);
  write_span(span_of(f), scene);
  return point;
}

}  // namespace

/// Two to four cards each, and with _ID one more before them. Blank ones at the end are no wall.
void translate_rigid_walls(DeckData& data, const KeywordBlock& block, std::size_t& count, TomlText& scene) {
  Cards cards(block);
  for (bool is_first = true;; is_first = false) {
    if (block.id && !cards.next()) return;
    std::optional<Card> head = cards.next();
    if (!head && !is_first) return;
    if (!head) head = cards.require("the nodes of the wall");
    const std::optional<Card> plane = cards.next();
    if (!is_first && head->blank() && (!plane || plane->blank())) return;
    write_head("rigid_wall", block, is_first ? block.place : head->place, scene);
    const Point corner =
        write_wall(data, block, *head, plane ? *plane : cards.require("the plane of the wall"), count++, scene);
    if (block.name.find("_FINITE") != std::string::npos) {
      const Card rectangle = cards.require("the rectangle of the wall");
      write_rectangle(data.fields(rectangle, layout::wall_rectangle), corner, scene);
    }
    if (block.name.find("_MOVING") != std::string::npos) {
      const Card mass = cards.require("the mass of the wall");
      write_mass(data.fields(mass, layout::wall_mass), scene);
    }
  }
}

}  // namespace pinball
