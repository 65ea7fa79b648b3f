#include <fmt/format.h>

#include <optional>

#include <solver/formats/lsdyna/layouts/contact_cards.hpp>

#include "boundary_keys.hpp"
#include "deck_parts.hpp"

namespace pinball {

namespace {

/// A rectangle: head of its first side, and the lengths of both; 0: without end.
void set_rectangle(const Fields& f, const Point& corner, const DeckKeys<RigidWall>& keys) {
  const std::vector<double> size{f.number("LENL"), f.number("LENM")};
  if (size[0] == 0 && size[1] == 0) return;
  keys.set("edge", minus(f.point("XHEV"), corner), "xhev, yhev, zhev");
  keys.set("size", size, "lenl, lenm");
}

/// MASS and V0, along the normal.
void set_mass(const Fields& f, const DeckKeys<RigidWall>& keys) {
  const double mass = f.number("MASS");
  if (!(mass > 0)) f.fail("MASS", fmt::format("expected a number > 0, got {}", mass));
  keys.set("mass", mass, "mass");
  keys.set("speed", f.number("V0"), "v0");
}

/// FRIC: a coefficient below 1; 1: nodes do not slide; 2 and 3, nodes that stick, are not there.
void set_friction(DeckData& data, const KeywordBlock& block, const Fields& plane, const DeckKeys<RigidWall>& keys) {
  const double friction = plane.number("FRIC");
  if (friction == 1) {
    keys.set("sliding", false, "fric");
  } else if (friction < 1) {
    keys.set("friction", friction, "fric");
  } else {
    data.report.reject(plane.place(), block.star_name() + " with nodes that stick (FRIC > 1)", "1: nodes do not slide");
  }
}

/// A point of the wall: a corner, where it is a rectangle.
Point set_wall(DeckData& data, const KeywordBlock& block, const Card& head, const Card& card, std::size_t number,
               const DeckKeys<RigidWall>& keys) {
  const Fields f = data.fields(head, layout::wall_nodes), plane = data.fields(card, layout::wall_plane);
  const Point point = plane.point("XT");
  keys.set("name", fmt::format("wall_{}", number));
  keys.set("point", point, "xt, yt, zt");
  keys.set("normal", minus(plane.point("XH"), point), "xh, yh, zh");
  set_friction(data, block, plane, keys);
  set_selection(data, block, f, keys);
  set_span(span_of(f), keys);
  return point;
}

}  // namespace

namespace {

/// Of the card of _ID.
void give_number_once(DeckData& data, const KeywordBlock& block, Card number) {
  number.log = nullptr;  // what follows it is a title
  const std::int64_t id = data.fields(number, layout::contact_number).integer("CID");
  if (id != 0)
    data.give_once(block, fmt::format("rigid wall {}", id + offset_of(block, &DeckTransform::part)), number.place);
}

}  // namespace

/// Two to four cards each, and with _ID one more before them. Blank ones at the end are no wall.
void translate_rigid_walls(DeckData& data, const KeywordBlock& block, DeckScene& scene) {
  Cards cards(block);
  for (bool is_first = true;; is_first = false) {
    if (block.id) {
      const std::optional<Card> number = cards.next();
      if (!number) return;
      give_number_once(data, block, *number);
    }
    std::optional<Card> head = cards.next();
    if (!head && !is_first) return;
    if (!head) head = cards.require("the nodes of the wall");
    const std::optional<Card> plane = cards.next();
    if (!is_first && head->blank() && (!plane || plane->blank())) return;
    const auto keys = scene.entry<RigidWall>("rigid_wall", card_of(block, is_first ? block.place : head->place));
    const Point corner =
        set_wall(data, block, *head, plane ? *plane : cards.require("the plane of the wall"), data.walls++, keys);
    if (block.name.find("_FINITE") != std::string::npos) {
      const Card rectangle = cards.require("the rectangle of the wall");
      set_rectangle(data.fields(rectangle, layout::wall_rectangle), corner, keys);
    }
    if (block.name.find("_MOVING") != std::string::npos) {
      const Card mass = cards.require("the mass of the wall");
      set_mass(data.fields(mass, layout::wall_mass), keys);
    }
  }
}

}  // namespace pinball
