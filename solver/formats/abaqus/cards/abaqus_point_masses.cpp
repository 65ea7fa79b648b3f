#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include <solver/base/moments_of_inertia.hpp>
#include <solver/mesh/file/node_masses.hpp>

#include "abaqus_parts.hpp"

/// MASS and ROTARY INERTIA: masses of nodes that deform and of reference nodes, and what rigid bodies weigh with these.
namespace pinball {

namespace {

/// A set of elements by the key of its label.
struct SetName {
  std::size_t component = 0;
  std::string key;
  auto operator<=>(const SetName&) const = default;
};

std::optional<std::size_t> component_of(const AbaqusData& data, const std::string& instance) {
  const std::string key = label_key(instance);
  const auto& components = data.mesh.components;
  const auto found = std::ranges::find(components, key, &AbaqusComponent::key);
  if (key.empty() || found == components.end()) return std::nullopt;
  return static_cast<std::size_t>(found - components.begin());
}

/// Sets that a label may mean, as a component calls it.
void add_sets_of_label(const AbaqusData& data, std::size_t component, std::string_view label,
                       std::vector<SetName>& sets) {
  sets.push_back({component, label_key(label)});
  const auto parts = split_label(label);
  const auto other = parts ? component_of(data, std::string(parts->first)) : std::nullopt;
  if (other) sets.push_back({*other, label_key(parts->second)});
}

/// Whether an *ELSET lists a number; sets: those that it names are added to these.
bool lists(const AbaqusData& data, const AbaqusBlock& block, std::size_t component, const AbaqusPointElement& point,
           std::vector<SetName>& sets) {
  const bool generates = block.has("GENERATE"), is_its = component == point.component;
  DataLines lines(block);
  while (const auto card = lines.next()) {
    if (generates) {
      const DataFields f(*card);
      const std::int64_t first = f.integer(0, "first"), last = f.integer(1, "last", first),
                         step = std::max<std::int64_t>(1, f.integer(2, "step", 1));
      if (is_its && point.number >= first && point.number <= last && (point.number - first) % step == 0) return true;
      continue;
    }
    for (const std::string_view entry : entries_of(card->text)) {
      const auto number = deck_integer(entry);
      if (is_its && number == point.number) return true;
      if (!number && !entry.empty()) add_sets_of_label(data, component, entry, sets);
    }
  }
  return false;
}

/// Whether one of some sets, or of those that they name, has an element of one node.
bool have(const AbaqusData& data, std::vector<SetName> sets, const AbaqusPointElement& point) {
  std::set<SetName> seen;
  while (!sets.empty()) {
    const SetName name = std::move(sets.back());
    sets.pop_back();
    if (!seen.insert(name).second) continue;
    if (name.component == point.component && name.key == point.set) return true;
    for (const AbaqusBlock* block : data.mesh.components[name.component].blocks) {
      if (block->name != "ELSET" || label_key(block->value("ELSET").value_or("")) != name.key) continue;
      const std::size_t scope = component_of(data, block->value("INSTANCE").value_or("")).value_or(name.component);
      if (lists(data, *block, scope, point, sets)) return true;
    }
  }
  return false;
}

/// The elements of one node that a *MASS or a *ROTARY INERTIA is for.
std::vector<const AbaqusPointElement*> points_of(const AbaqusData& data, std::size_t component,
                                                 const AbaqusBlock& block) {
  std::vector<SetName> sets;
  add_sets_of_label(data, component, block.require("ELSET"), sets);
  std::vector<const AbaqusPointElement*> points;
  for (const AbaqusPointElement& point : data.mesh.points) {
    if (point.turns == (block.name == "ROTARYINERTIA") && have(data, sets, point)) points.push_back(&point);
  }
  return points;
}

/// Moments about the axes. Throws InputError for one below 0; products are refused.
Point moments_of(AbaqusData& data, const AbaqusBlock& block, const InstancePlacement& placement) {
  DataLines lines(block);
  const DataLine card = lines.require("the moments of inertia");
  const DataFields f(card);
  Point moments{};
  for (std::size_t k = 0; k < 3; ++k) {
    moments[k] = f.number(k, "moment of inertia", 0.0);
    if (!(moments[k] >= 0))
      fail_at(card.place, fmt::format("*ROTARY INERTIA: moment of inertia: expected >= 0, got {}", moments[k]));
  }
  bool has_products = false;
  for (std::size_t k = 3; k < 6; ++k) has_products = f.number(k, "product of inertia", 0.0) != 0 || has_products;
  if (has_products)
    data.report.reject(card.place, "*ROTARY INERTIA with products of inertia",
                       "turn the axes of the model to those of the body");
  if (placement.turns() && (moments[0] != moments[1] || moments[1] != moments[2]))
    data.report.reject(card.place, "*ROTARY INERTIA of an instance that is turned", "give it in the assembly");
  return moments;
}

double mass_of_line(const AbaqusBlock& block) {
  DataLines lines(block);
  const DataLine card = lines.require("the mass");
  const double mass = DataFields(card).number(0, "mass");
  if (!(mass >= 0)) fail_at(card.place, fmt::format("*MASS: expected a mass >= 0, got {}", mass));
  return mass;
}

/// Of the elements of some bodies. density: per part.
double mass_of_bodies(const AbaqusData& data, const std::vector<std::string>& names, std::vector<double> density) {
  for (const AbaqusBody& body : data.bodies) {
    if (std::ranges::count(names, body.name) == 0) density[body.section] = 0;
  }
  const std::vector<double> masses = node_masses(data.mesh.file, density);
  return std::accumulate(masses.begin(), masses.end(), 0.0);
}

/// With what is at its reference node. masses: what nodes have of elements.
AbaqusWeight weight_of(const AbaqusData& data, const AbaqusRigidBody& rigid, const std::vector<double>& masses) {
  const std::vector<Point>& places = data.mesh.file.mesh.nodes;
  std::vector<std::int32_t> nodes = rigid.tied;
  for (std::size_t n = 0; n < rigid.own.size(); ++n) {
    if (rigid.own[n]) nodes.push_back(static_cast<std::int32_t>(n));
  }
  const Point& reference = places[rigid.node];
  double mass = rigid.mass, size = 0;
  Point first{};
  for (const std::int32_t n : nodes) {
    const Point arm = minus(places[n], reference);
    mass += masses[n];
    for (std::size_t k = 0; k < 3; ++k) first[k] += masses[n] * arm[k];
    size = std::max(size, norm(arm));
  }
  AbaqusWeight weight{.centre = reference, .inertia = rigid.inertia};
  if (norm(first) > near_abaqus_centre * size * mass) {
    for (std::size_t k = 0; k < 3; ++k) weight.centre[k] += first[k] / mass;
  }
  add_moments(weight.inertia, rigid.mass, minus(reference, weight.centre));
  for (const std::int32_t n : nodes) add_moments(weight.inertia, masses[n], minus(places[n], weight.centre));
  return weight;
}

bool has_rigid_elements(const AbaqusData& data, const AbaqusRigidBody& rigid) {
  return std::ranges::any_of(data.bodies, [&](const AbaqusBody& body) {
    return body.is_rigid_elements() && std::ranges::count(rigid.bodies, body.name) > 0;
  });
}

/// Whether its mass is not that of its solids alone.
bool is_weighed(const AbaqusData& data, const AbaqusRigidBody& rigid) {
  return rigid.mass > 0 || rigid.inertia != std::array<Point, 3>{} || has_rigid_elements(data, rigid);
}

bool is_led_in_all_directions(const AbaqusData& data, const AbaqusRigidBody& rigid) {
  for (std::size_t k = 0; k < 6; ++k) {
    if (!rigid.is_led(k, data.end())) return false;
  }
  return true;
}

/// The moment about an axis about which the body is moved as given means nothing: where none is given it is the largest
/// of the others. Returns whether the body turns by itself about an axis without one.
bool fill_moments(const AbaqusData& data, const AbaqusRigidBody& rigid, std::array<Point, 3>& inertia) {
  const double largest = std::max({inertia[0][0], inertia[1][1], inertia[2][2]});
  bool lacks = false;
  for (std::size_t k = 0; k < 3; ++k) {
    if (inertia[k][k] > 0) continue;
    if (!rigid.is_led(3 + k, data.end())) lacks = true;
    inertia[k][k] = largest;
  }
  return lacks;
}

/// Those of which the mass is not that of their solids alone.
void weigh_rigid_bodies(AbaqusData& data) {
  std::vector<double> density, masses;
  for (AbaqusRigidBody& rigid : data.rigid) {
    if (rigid.is_coupling() || rigid.is_wall || !is_weighed(data, rigid)) continue;
    if (density.empty()) {
      density = abaqus_densities_of_parts(data);
      masses = node_masses(data.mesh.file, density);
    }
    rigid.weight = weight_of(data, rigid, masses);
    rigid.weight->mass = rigid.mass + mass_of_bodies(data, rigid.bodies, density);
    rigid.offset = minus(data.mesh.file.mesh.nodes[rigid.node], rigid.weight->centre);
  }
}

/// Whether a node moves by itself, with solids: no rigid body has it.
bool is_of_solids(const AbaqusData& data, std::int32_t node) {
  const bool is_rigid = std::ranges::any_of(
      data.rigid, [node](const AbaqusRigidBody& rigid) { return std::ranges::binary_search(rigid.tied, node); });
  return data.used[node] && !is_rigid && (data.rigid_of_node.empty() || data.rigid_of_node[node] < 0);
}

}  // namespace

void find_abaqus_point_masses(AbaqusData& data) {
  std::vector<bool> known(data.mesh.points.size(), false);
  for (std::size_t c = 0; c < data.mesh.components.size(); ++c) {
    const AbaqusComponent& component = data.mesh.components[c];
    for (const AbaqusBlock* block : component.blocks) {
      const bool is_mass = block->name == "MASS";
      if (!is_mass && block->name != "ROTARYINERTIA") continue;
      const double mass = is_mass ? mass_of_line(*block) : 0.0;
      const Point moments = is_mass ? Point{} : moments_of(data, *block, component.placement);
      const std::vector<const AbaqusPointElement*> points = points_of(data, c, *block);
      if (points.empty())
        data.report.unused(block->place, block->star_name(), "its ELSET has no elements of one node of that type");
      for (const AbaqusPointElement* point : points) {
        known[point - data.mesh.points.data()] = true;
        if (mass > 0) data.heavy_points.push_back(point);
        AbaqusRigidBody* rigid = data.rigid_at(point->node);
        if (is_mass && rigid == nullptr && is_of_solids(data, point->node)) {
          if (mass > 0) data.point_masses.add(point->node, mass, card_of(*block, block->place));
          continue;
        }
        if (rigid == nullptr || rigid->is_coupling() || rigid->is_wall) {
          data.report.reject(block->place, block->star_name() + " of a node that is no reference node of a rigid body",
                             is_mass ? "give it to that, or to a node of solids that deform" : "masses of nodes");
          continue;
        }
        rigid->mass += mass;
        for (std::size_t k = 0; k < 3; ++k) rigid->inertia[k][k] += moments[k];
      }
    }
  }
  for (std::size_t i = 0; i < known.size(); ++i) {
    if (!known[i])
      data.report.unused(data.mesh.points[i].place, "*ELEMENT of one node", "no *MASS or *ROTARY INERTIA is for it");
  }
  weigh_rigid_bodies(data);
}

bool set_has_point(const AbaqusData& data, const std::string& label, const AbaqusPointElement& point) {
  std::vector<SetName> sets;
  for (std::size_t c = 0; c < data.mesh.components.size(); ++c) add_sets_of_label(data, c, label, sets);
  return have(data, std::move(sets), point);
}

void set_abaqus_mass(AbaqusData& data, const AbaqusRigidBody& rigid, const DeckKeys<RigidBody>& keys) {
  if (!rigid.weight) return;
  if (rigid.weight->mass == 0) {
    if (!is_led_in_all_directions(data, rigid))
      return data.report.reject(
          rigid.card.place, "*RIGID BODY of rigid elements without mass",
          "*MASS and *ROTARY INERTIA of its reference node, or hold or move it in all directions");
    data.report.understood(
        fmt::format("*RIGID BODY ({}): the deck gives it no mass: it is held or moved in all "
                    "directions, and kinetic energies have that of its layer of solids, as light as "
                    "the lightest material",
                    rigid.card.place.text()));
    return;
  }
  keys.set("mass", rigid.weight->mass);
  if ((rigid.held >> 3U) == 7U) return;  // it does not turn
  std::array<Point, 3> inertia = rigid.weight->inertia;
  const bool lacks = fill_moments(data, rigid, inertia);
  if (lacks)
    return data.report.reject(rigid.card.place, "*RIGID BODY of rigid elements without moments of inertia",
                              "*ROTARY INERTIA of its reference node, or hold its rotations");
  if (inertia[0][0] == 0) return;
  keys.set("centre", rigid.weight->centre);
  keys.set("inertia", given_list(inertia));
}

}  // namespace pinball
