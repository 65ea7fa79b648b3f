#include "abaqus_interactions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <solver/mesh/quality.hpp>

namespace pinball {

namespace {

/// A constant; with EXPONENTIAL DECAY the one at rest, the one while sliding, and the decay between them, without which
/// it stays that at rest.
AbaqusFriction read_friction(AbaqusData& data, const AbaqusBlock& block) {
  DataLines lines(block);
  const auto card = lines.next();
  if (!card) return {};
  const DataFields f(*card);
  const double first = f.number(0, "coefficient", 0.0);
  if (block.has("EXPONENTIALDECAY")) {
    const double sliding = f.number(1, "coefficient while sliding"), decay = f.number(2, "decay", 0.0);
    if (decay > 0) return {sliding, first, decay};
    if (sliding != first)
      data.report.unused(card->place, "*FRICTION: coefficient while sliding",
                         "without a decay friction stays that at rest");
    return {first, first, 0.0};
  }
  for (std::size_t i = 1; i < 7; ++i) {
    if (!f.blank(i)) data.report.reject(block.place, "*FRICTION that depends on slip rate, pressure or temperature");
  }
  return {first, first, 0.0};
}

/// The largest Young's modulus of the bodies that deform [stress]; 0: none does.
double largest_modulus(const AbaqusData& data) {
  const std::map<std::string, double> moduli = abaqus_moduli(data.deck);
  double largest = 0;
  for (const AbaqusBody& body : data.bodies) {
    const bool is_rigid = std::ranges::any_of(
        data.rigid, [&](const AbaqusRigidBody& rigid) { return std::ranges::count(rigid.bodies, body.name) > 0; });
    const auto found = moduli.find(body.material);
    if (!is_rigid && found != moduli.end()) largest = std::max(largest, found->second);
  }
  return largest;
}

/// The edge of a cube of the mean volume of the elements [length].
double mean_edge(const Mesh& mesh) {
  double volume = 0;
  for (const auto& hexahedron : mesh.hexahedra) {
    std::array<Point, 8> corners;
    for (std::size_t c = 0; c < 8; ++c) corners[c] = mesh.nodes[hexahedron[c]];
    volume += volume_by_quadrature(corners);
  }
  return std::cbrt(volume / mesh.hexahedra.size());
}

/// A pressure of `slope` times the overclosure, which springs have in the place of a constraint. It lets surfaces
/// overlap as much as a layer of the thickness E/slope gives way: while that is less than an element, hard contact is
/// what it stands for; beyond it is a cushion, which contact here has not.
void tell_linear(AbaqusData& data, const AbaqusBlock& block) {
  DataLines lines(block);
  const DataLine card = lines.require("the slope of the pressure over the overclosure");
  const DataFields f(card);
  const double slope = f.number(0, "slope");
  if (!(slope > 0)) f.fail("slope", fmt::format("expected more than 0, got {}", slope));
  for (const auto& [field, name] : {std::pair{1, "sigma-infinity"}, std::pair{2, "c0"}}) {
    if (!f.blank(field))
      data.report.unused(card.place, fmt::format("*SURFACE BEHAVIOR: {}", name),
                         "of springs that reach beyond the surface: hard contact neither pulls nor reaches out");
  }
  const std::string what = "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR";
  const double modulus = largest_modulus(data), layer = modulus / slope, edges = layer / mean_edge(data.mesh.file.mesh);
  if (!(modulus > 0)) {
    data.report.reject(block.place, what + " of bodies that are all rigid",
                       "how they rebound is all in its slope; let one of them deform");
  } else if (edges > 1) {
    data.report.reject(block.place, what,
                       fmt::format("as soft as {:.3g} elements one behind the other, no contact of surfaces that stay "
                                   "apart: a layer of a soft material in its place, or HARD",
                                   edges));
  } else {
    data.report.understood(
        fmt::format("{} ({}): hard contact in its place. Under the deck's own law surfaces overlap by pressure/{:.6g}: "
                    "{:.3g} at a thousandth of Young's modulus {:.6g}, or {:.3g} of what an element gives way",
                    what, block.place.text(), slope, layer / 1000, modulus, edges));
  }
}

}  // namespace

AbaqusInteractions::AbaqusInteractions(AbaqusData& data) : data_(data) {
  Interaction* current = nullptr;
  std::string name;
  for (const AbaqusBlock& block : data_.deck.blocks) {
    if (block.name == "SURFACEINTERACTION") {
      name = label_key(block.require("NAME"));
      current = &interactions_[name];
    }
    if (current == nullptr || (block.name != "FRICTION" && block.name != "SURFACEBEHAVIOR")) continue;
    data_.give_once(block.star_name() + " of the interaction " + name, block.place);
    if (block.name == "FRICTION") {
      current->friction = read_friction(data_, block);
    } else {
      current->behavior = &block;
    }
  }
}

const AbaqusFriction& AbaqusInteractions::use(const std::string& name, const DeckPlace& place) {
  const auto found = interactions_.find(label_key(name));
  if (found == interactions_.end()) fail_at(place, fmt::format("there is no *SURFACE INTERACTION {}", name));
  Interaction& one = found->second;
  if (one.behavior != nullptr && one.behavior->option("PRESSURE-OVERCLOSURE") == "LINEAR")
    tell_linear(data_, *one.behavior);
  one.behavior = nullptr;
  return one.friction;
}

}  // namespace pinball
