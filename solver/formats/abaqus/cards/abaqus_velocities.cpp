#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "abaqus_parts.hpp"

namespace pinball {

namespace {

/// A label of *INITIAL CONDITIONS with the velocity that its lines give together.
struct Moving {
  AbaqusNodes nodes;
  DeckPlace place;
  Point velocity{};
  std::array<bool, 3> given{};
};

/// Whether a node is in two of them: what one leaves out, the other may give.
bool overlap(const std::vector<Moving>& all, std::size_t nodes) {
  std::vector<bool> taken(nodes, false);
  for (const Moving& one : all) {
    for (const std::int32_t node : one.nodes.members) {
      if (taken[node]) return true;
      taken[node] = true;
    }
  }
  return false;
}

/// Each node by itself: later lines replace the components that they give. all: a line each, in their order.
void write_by_node(const AbaqusData& data, const std::vector<Moving>& all, const AbaqusBlock& block, DeckScene& scene) {
  std::map<std::int32_t, Moving> of_node;
  for (const Moving& one : all) {
    std::size_t replaced = 0;
    for (const std::int32_t node : one.nodes.members) {
      Moving& of = of_node[node];
      for (std::size_t k = 0; k < 3; ++k) {
        if (!one.given[k]) continue;
        replaced += of.given[k] && of.velocity[k] != one.velocity[k];
        of.given[k] = true;
        of.velocity[k] = one.velocity[k];
      }
    }
    if (replaced > 0)
      data.report.understood(
          fmt::format("*INITIAL CONDITIONS ({}): takes the place of what lines before give {} of its "
                      "nodes",
                      one.place.text(), replaced));
  }
  std::map<Point, std::vector<std::int64_t>> nodes;
  for (const auto& [node, of] : of_node) {
    if (data.used[node]) {
      nodes[of.velocity].push_back(data.mesh.file.node_ids[node]);
    } else {
      data.report.ignore_node(block.place, "*INITIAL CONDITIONS");
    }
  }
  for (const auto& [velocity, numbers] : nodes) {
    const auto keys = scene.entry<InitialVelocity>("initial_velocity", card_of(block, block.place));
    keys.set("velocity", velocity);
    keys.set("nodes", numbers);
  }
}

}  // namespace

namespace {

/// A degree of freedom of a reference node; returns whether any of the nodes is one.
bool throw_rigid_bodies(AbaqusData& data, const AbaqusNodes& nodes, std::int64_t degree, double value) {
  bool any = false;
  for (const std::int32_t node : nodes.members) {
    AbaqusRigidBody* rigid = data.rigid_at(node);
    if (rigid == nullptr || degree < 1 || degree > 6) continue;
    any = true;
    if (!rigid->velocity) rigid->velocity = rigid->angular_velocity = Point{};
    (degree <= 3 ? *rigid->velocity : *rigid->angular_velocity)[(degree - 1) % 3] = value;
  }
  return any;
}

/// Nodes of rigid bodies have the velocity of the reference node.
void require_references(AbaqusData& data, const std::vector<Moving>& all) {
  if (data.rigid_of_node.empty()) return;
  for (const Moving& one : all) {
    for (const std::int32_t node : one.nodes.members) {
      const std::int32_t number = data.rigid_of_node[node];
      if (number < 0 || data.rigid[number].velocity) continue;
      data.report.reject(one.place, "*INITIAL CONDITIONS of nodes of a rigid body", "give them to its reference node");
      break;
    }
  }
}

bool has_element_nodes(const AbaqusData& data, const AbaqusNodes& nodes) {
  return std::ranges::any_of(nodes.members, [&](std::int32_t node) { return data.used[node]; });
}

/// A velocity and a spin about an axis from a point to another one: two lines of TYPE=ROTATING VELOCITY.
struct Spin {
  AbaqusNodes nodes;
  DeckPlace place;
  Point velocity{}, centre{}, angular_velocity{};
};

Spin read_spin(const AbaqusData& data, const DataLine& card, const DataLine& second) {
  const DataFields f(card), axis(second);
  Spin spin{data.nodes(f.text(0), card.place), card.place, {}, {}, {}};
  for (int k = 0; k < 3; ++k) {
    spin.velocity[k] = f.number(2 + k, "velocity", 0.0);
    spin.centre[k] = axis.number(k, "first point", 0.0);
    spin.angular_velocity[k] = axis.number(3 + k, "second point", 0.0) - spin.centre[k];
  }
  const double length = norm(spin.angular_velocity), omega = f.number(1, "angular velocity", 0.0);
  if (!(length > 0) && omega != 0)
    fail_at(axis.place(), "*INITIAL CONDITIONS: expected two points of the axis, got one");
  for (double& component : spin.angular_velocity) component *= length > 0 ? omega / length : 0.0;
  return spin;
}

/// Rigid bodies move by their reference nodes. Returns whether one of them has a velocity already.
bool spin_rigid_bodies(AbaqusData& data, const Spin& spin) {
  bool repeated = false;
  for (const std::int32_t node : spin.nodes.members) {
    AbaqusRigidBody* rigid = data.rigid_at(node);
    if (rigid == nullptr) continue;
    repeated |= rigid->velocity.has_value();
    Point arm = data.mesh.file.mesh.nodes[node];
    for (std::size_t k = 0; k < 3; ++k) arm[k] -= spin.centre[k];
    rigid->velocity = cross(spin.angular_velocity, arm);
    for (std::size_t k = 0; k < 3; ++k) (*rigid->velocity)[k] += spin.velocity[k];
    rigid->angular_velocity = spin.angular_velocity;
  }
  return repeated;
}

/// taken: per node, whether a line of TYPE=VELOCITY or one before has it. What is of both is refused.
void translate_spins(AbaqusData& data, std::vector<bool> taken, DeckScene& scene) {
  for (const AbaqusBlock& block : data.deck.blocks) {
    if (block.name != "INITIALCONDITIONS" || block.option("TYPE") != "ROTATINGVELOCITY") continue;
    DataLines lines(block);
    while (const auto card = lines.next()) {
      const Spin spin = read_spin(data, *card, lines.require("two points of the axis"));
      bool repeated = spin_rigid_bodies(data, spin);
      require_references(data, {Moving{spin.nodes, spin.place, {}, {}}});
      for (const std::int32_t node : spin.nodes.members) {
        repeated |= taken[node];
        taken[node] = true;
      }
      if (repeated) {
        data.report.reject(spin.place, "*INITIAL CONDITIONS, TYPE=ROTATING VELOCITY of nodes with another velocity");
      } else if (has_element_nodes(data, spin.nodes)) {
        const auto keys = scene.entry<InitialVelocity>("initial_velocity", card_of(block, spin.place));
        keys.set("velocity", spin.velocity);
        keys.set("angular_velocity", spin.angular_velocity);
        keys.set("centre", spin.centre);
        set_nodes(spin.nodes, keys);
      }
    }
  }
}

}  // namespace

void translate_abaqus_initial_velocities(AbaqusData& data, DeckScene& scene) {
  std::vector<Moving> all, of_lines;
  std::map<std::string, std::size_t> known;
  const AbaqusBlock* last = nullptr;
  for (const AbaqusBlock& block : data.deck.blocks) {
    const std::string type = block.option("TYPE");
    if (block.name != "INITIALCONDITIONS" || type != "VELOCITY") continue;
    last = &block;
    DataLines lines(block);
    while (const auto card = lines.next()) {
      const DataFields f(*card);
      const std::int64_t degree = f.integer(1, "degree of freedom");
      const double value = f.number(2, "velocity", 0.0);
      const AbaqusNodes nodes = data.nodes(f.text(0), card->place);
      const bool is_thrown = throw_rigid_bodies(data, nodes, degree, value);
      if (is_thrown && !has_element_nodes(data, nodes)) continue;
      if (!is_translation(data, block, card->place, degree)) continue;
      const auto [found, is_new] = known.try_emplace(label_key(f.text(0)), all.size());
      if (is_new) all.push_back({nodes, card->place, {}, {}});
      all[found->second].velocity[degree - 1] = value;
      all[found->second].given[degree - 1] = true;
      Moving& line = of_lines.emplace_back(Moving{nodes, card->place, {}, {}});
      line.velocity[degree - 1] = value;
      line.given[degree - 1] = true;
    }
  }
  require_references(data, all);
  std::vector<bool> taken(data.used.size(), false);
  for (const Moving& one : all) {
    for (const std::int32_t node : one.nodes.members) taken[node] = true;
  }
  translate_spins(data, std::move(taken), scene);
  const bool singles = std::ranges::any_of(all, [](const Moving& one) { return one.nodes.set.empty(); });
  if (singles || overlap(all, data.used.size())) {
    write_by_node(data, of_lines, *last, scene);
    return;
  }
  for (const Moving& one : all) {
    const auto keys = scene.entry<InitialVelocity>("initial_velocity", card_of(*last, one.place));
    keys.set("velocity", one.velocity);
    set_nodes(one.nodes, keys);
  }
}

}  // namespace pinball
