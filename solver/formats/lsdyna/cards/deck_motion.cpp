#include <fmt/format.h>

#include <cstdlib>

#include "boundary_keys.hpp"
#include "deck_parts.hpp"

namespace pinball {

namespace {

/// Along which a card moves its nodes; DOF 4 and -4: along the vector VID.
Point direction_of(const DeckData& data, const KeywordBlock& block, std::int64_t degree, const Fields& f) {
  if (degree == 4 || degree == -4) return data.vector(definition_number(block, f.integer("VID")), f.place());
  Point axis{};
  axis[degree - 1] = 1;
  return axis;
}

/// What is not done of a card; empty: all of it is.
std::string rejected_of(const KeywordBlock& block, std::int64_t degree, std::int64_t quantity) {
  const bool along = (degree >= 1 && degree <= 4) || degree == -4;
  if (!along) return fmt::format("{} with DOF {}", block.star_name(), degree);
  return quantity < 0 || quantity > 2 ? fmt::format("{} with VAD {}", block.star_name(), quantity) : "";
}

/// A set, a node, or all nodes of a part that deforms.
void set_moved(DeckData& data, const KeywordBlock& block, const Fields& f, const DeckKeys<NodeSelection>& keys) {
  const std::int64_t id = f.integer(std::size_t{0});
  if (!block.name.ends_with("_RIGID")) return set_target(block, block.name.ends_with("_SET"), id, keys);
  const std::int64_t part = id + offset_of(block, &DeckTransform::part);
  const auto body = data.body_of(part, f.place());
  if (!body) fail_at(f.place(), fmt::format("{}: part {} has no solids", block.star_name(), part));
  keys.set("body", *body, "pid");
  data.report.understood(
      fmt::format("{} ({}): part {} is not rigid, all of its nodes move so; other directions are free",
                  block.star_name(), f.place().text(), part));
}

constexpr const char* quantities[] = {"velocity", "acceleration", "displacement"};

/// Of a rigid body; DOF 5 to 7 turn it about an axis through its centre, 8 and -8 about the vector VID.
void translate_rigid_motion(DeckData& data, const KeywordBlock& block, const Fields& f, const std::string& body,
                            DeckScene& scene) {
  const std::int64_t degree = f.integer("DOF"), quantity = f.integer("VAD");
  const bool turns = std::abs(degree) >= 5;
  if (degree == 0 || degree < -8 || degree > 8 || (degree < 0 && degree != -4 && degree != -8))
    return data.report.reject(f.place(), fmt::format("{} with DOF {}", block.star_name(), degree),
                              "of rigid parts DOF 1 to 8, -4 and -8 are read");
  if (quantity < 0 || quantity > 2)
    return data.report.reject(f.place(), fmt::format("{} with VAD {}", block.star_name(), quantity),
                              "VAD 0 to 2 are read");
  const Point direction = direction_of(data, block, turns ? (degree < 0 ? degree + 4 : degree - 4) : degree, f);
  const auto begin = [&](const Point& along) {
    const auto keys = scene.entry<RigidMotion>("rigid_motion", card_of(block, f.place()));
    keys.set("rigid_body", body, "pid");
    keys.set(turns ? KeyOf<RigidMotion>("axis") : KeyOf<RigidMotion>("direction"), along, "dof");
    set_span(span_of(f), keys);
    return keys;
  };
  const auto keys = begin(direction);
  keys.set(turns ? KeyOf<RigidMotion>("angular_speed") : KeyOf<RigidMotion>("speed"), 1.0);
  keys.set("quantity", quantities[quantity], "vad");
  set_curve(data, block, f.integer("LCID"), f.number("SF"), f.place(), keys, span_of(f));
  if (degree > 0) return;
  const Point one = std::abs(direction[0]) < 0.5 ? Point{1, 0, 0} : Point{0, 1, 0};
  Point across = cross(direction, one);
  const double length = norm(across);
  for (double& component : across) component /= length;
  begin(across);  // held across it
  begin(cross(direction, across));
}

/// One card of the keyword.
void translate_motion(DeckData& data, const KeywordBlock& block, const Fields& f, DeckScene& scene) {
  if (block.name.ends_with("_RIGID")) {
    const std::int64_t id = f.integer("PID") + offset_of(block, &DeckTransform::part);
    const DeckPart* part = data.find_part(id);
    if (part != nullptr && part->is_rigid())
      return translate_rigid_motion(data, block, f, data.find_part(part->lead)->body, scene);
    if (const auto body = nodal_rigid_body(data, id)) return translate_rigid_motion(data, block, f, *body, scene);
  }
  const std::int64_t degree = f.integer("DOF"), quantity = f.integer("VAD");
  if (degree >= 5 && degree <= 7 && !block.name.ends_with("_RIGID")) {
    data.report.understood(fmt::format("{} ({}): a rotation of nodes of solids (DOF {}) means nothing",
                                       block.star_name(), f.place().text(), degree));
    return;
  }
  if (const std::string rejected = rejected_of(block, degree, quantity); !rejected.empty()) {
    data.report.reject(f.place(), rejected, "DOF 1 to 4 and -4 are read, and VAD 0 to 2");
    return;
  }
  const bool set = block.name.ends_with("_SET");
  if (!block.name.ends_with("_RIGID") &&
      data.reject_rigid_nodes(nodes_of_card(data, block, set, f), f.place(), block.star_name(),
                              "move the part by *BOUNDARY_PRESCRIBED_MOTION_RIGID"))
    return;
  const Point direction = direction_of(data, block, degree, f);
  const auto keys = scene.entry<PrescribedVelocity>("prescribed_velocity", card_of(block, f.place()));
  ++data.motions;
  if (last_card(data, "DATABASE_BNDOUT")) keys.set("name", fmt::format("motion_{}", data.motions));
  if (degree == -4) {  // and held across it
    keys.set("velocity", direction);
  } else {
    keys.set("direction", direction);
    keys.set("speed", 1.0);
  }
  keys.set("quantity", quantities[quantity], "vad");
  set_curve(data, block, f.integer("LCID"), f.number("SF"), f.place(), keys, span_of(f));
  set_span(span_of(f), keys);
  set_moved(data, block, f, keys);
}

/// Whether a second line belongs to a card: of a motion about a node, or relative to another one, which are refused.
bool has_second_line(const Fields& f) {
  const std::int64_t degree = std::abs(f.integer("DOF"));
  return (degree >= 9 && degree <= 11) || f.integer("VAD") == 4;
}

}  // namespace

void translate_prescribed_motion(DeckData& data, const KeywordBlock& block, DeckScene& scene) {
  const CardLayout& layout = block.name.ends_with("_RIGID") ? layout::motion_part
                             : block.name.ends_with("_SET") ? layout::motion_set
                                                            : layout::motion_node;
  for_each_card(block, [&](const Card& card, Cards& cards) {
    const Fields f = data.fields(card, layout);
    if (has_second_line(f)) cards.next();
    translate_motion(data, block, f, scene);
  });
}

}  // namespace pinball
