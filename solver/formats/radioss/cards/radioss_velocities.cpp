#include <fmt/format.h>

#include <solver/formats/radioss/layouts/radioss_boundary_cards.hpp>

#include "radioss_keys.hpp"

namespace pinball {

namespace {

using VelocityKeys = DeckKeys<InitialVelocity>;

/// What is in the components of a local system.
Point in_axes(const std::array<Point, 3>& axes, const Point& vector) {
  Point global{};
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t c = 0; c < 3; ++c) global[c] += vector[k] * axes[k][c];
  }
  return global;
}

/// Calls set(keys) for the nodes of a group, or, without one, for those of each body.
template <class Set>
void add_velocity(RadiossData& data, const RadiossBlock& block, const DeckPlace& place, std::int64_t id,
                  const Point& velocity, bool spins, DeckScene& scene, const Set& set) {
  const auto begin = [&] {
    const VelocityKeys keys = scene.entry<InitialVelocity>("initial_velocity", card_of(block, place));
    keys.set("velocity", velocity, "Vx, Vy, Vz");
    set(keys);
    return keys;
  };
  if (id == 0) {
    for (const RadiossBody& body : data.bodies) begin().set("body", body.name);
    return;
  }
  const MeshSet& group = data.node_group(id, place);
  const auto mains = data.rigid_in(group);
  for (RadiossRigidBody* rigid : mains) {
    if (data.has_used(group)) break;  // the nodes of the body have it, too
    rigid->velocity = velocity;
    if (spins) data.report.reject(place, block.title + " of a main node with a spin", "give the nodes of the body");
  }
  if (data.has_used(group)) {
    begin().set("set", std::to_string(id), "grnod_ID");
  } else if (mains.empty()) {
    data.report.ignore(place, fmt::format("/{} of nodes of no solid", block.name));
  }
}

void translate_straight(RadiossData& data, const RadiossBlock& block, DeckScene& scene) {
  RadiossLines lines(block);
  const DataLine line = lines.require("a velocity and a group"), start = lines.next_or_blank();
  const RadiossFields f(line, block, radioss::velocity), s(start, block, radioss::velocity_start);
  const Point velocity = in_axes(data.axes(f.integer("skew_ID"), line.place), f.point("Vx"));
  add_velocity(data, block, line.place, f.integer("grnod_ID"), velocity, false, scene, [](const VelocityKeys&) {});
}

/// Of main nodes: how their bodies turn. Of several of the same node the last counts, as in the starter.
void translate_turning(RadiossData& data, const RadiossBlock& block) {
  RadiossLines lines(block);
  const DataLine line = lines.require("an angular velocity and a group"), start = lines.next_or_blank();
  const RadiossFields f(line, block, radioss::velocity_of_turning), s(start, block, radioss::velocity_start);
  const Point velocity = in_axes(data.axes(f.integer("skew_ID"), line.place), f.point("Vxr"));
  const auto mains = data.rigid_in(data.node_group(f.integer("grnod_ID"), line.place));
  if (mains.empty())
    data.report.unused(line.place, block.title + ": Vxr, Vyr, Vzr", "only main nodes of rigid bodies turn");
  for (RadiossRigidBody* rigid : mains) {
    if (rigid->angular_velocity)
      data.report.understood(fmt::format("{} ({}): takes the place of the one before of the same main node",
                                         block.title, line.place.text()));
    rigid->angular_velocity = velocity;
  }
}

/// The axis goes through the origin of the frame.
void translate_spin(RadiossData& data, const RadiossBlock& block, DeckScene& scene) {
  RadiossLines lines(block);
  const DataLine line = lines.require("a direction, a frame and a group"),
                 second = lines.require("a velocity and a spin"), start = lines.next_or_blank();
  const RadiossFields f(line, block, radioss::velocity_axis), v(second, block, radioss::velocity_spin),
      s(start, block, radioss::velocity_start);
  const int degree = degree_of(f, "Dir");
  if (degree >= 3) f.fail("Dir", "expected X, Y or Z");
  const auto [origin, axes] = data.frame(f.integer("frame_ID"), line.place);
  Point spin = axes[degree];
  for (double& component : spin) component *= v.number("Vr");
  add_velocity(data, block, line.place, f.integer("grnod_ID"), in_axes(axes, v.point("Vxt")), true, scene,
               [&, centre = origin](const VelocityKeys& keys) {
                 keys.set("angular_velocity", spin, "Vr");
                 keys.set("centre", centre, "frame_ID");
               });
}

}  // namespace

void translate_radioss_velocities(RadiossData& data, DeckScene& scene) {
  for (const RadiossBlock& block : data.deck.blocks) {
    if (block.name == "INIVEL/TRA") translate_straight(data, block, scene);
    if (block.name == "INIVEL/AXIS") translate_spin(data, block, scene);
    if (block.name == "INIVEL/ROT") translate_turning(data, block);
  }
}

}  // namespace pinball
