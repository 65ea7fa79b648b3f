#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <map>

#include <solver/mesh/quality.hpp>
#include <solver/mesh/shapes/wedges.hpp>

#include "abaqus_parts.hpp"

namespace pinball {

namespace {

/// From the centre of the masses at the nodes to a point, or nothing where that is as good as there. counts: whether a
/// node does.
template <class Counts>
Point offset_of(const AbaqusData& data, const std::vector<std::int32_t>& elements, const Point& point,
                const Counts& counts) {
  const std::vector<double> density = abaqus_densities_of_parts(data);
  const Mesh& mesh = data.mesh.file.mesh;
  double mass = 0, size = 0;
  Point first{};
  for (const std::int32_t e : elements) {
    std::array<Point, 8> corners;
    for (std::size_t c = 0; c < 8; ++c) corners[c] = minus(mesh.nodes[mesh.hexahedra[e][c]], point);
    const double of_element = density[data.mesh.file.part[e]] * volume_by_quadrature(corners);
    const CornerShares share = corner_shares(worked_as(mesh.hexahedra[e]), mesh.hexahedra[e]);
    for (std::size_t c = 0; c < 8; ++c) {
      if (!counts(mesh.hexahedra[e][c])) continue;
      const double of_corner = of_element * share[c];
      mass += of_corner;
      for (std::size_t k = 0; k < 3; ++k) first[k] -= of_corner * corners[c][k];
      size = std::max(size, norm(minus(corners[c], corners[0])));
    }
  }
  if (!(mass > 0)) return {};  // of rigid elements, which have none of their own
  for (double& component : first) component /= mass;
  for (const std::int32_t e : elements) {
    for (const std::int32_t node : mesh.hexahedra[e]) {
      if (!counts(node)) continue;
      const Point from_point = minus(mesh.nodes[node], point);
      size = std::max(size, norm(Point{from_point[0] + first[0], from_point[1] + first[1], from_point[2] + first[2]}));
    }
  }
  return norm(first) <= near_abaqus_centre * size ? Point{} : first;
}

/// Place of the reference node in the mesh.
std::int32_t reference_of(const AbaqusData& data, const std::string& label, const DeckPlace& place,
                          const char* star_name = "*RIGID BODY") {
  const AbaqusNodes nodes = data.nodes(label, place);
  if (nodes.members.size() != 1)
    fail_at(place, fmt::format("{}: expected one reference node, got {}", star_name, nodes.members.size()));
  return nodes.members[0];
}

/// Nodes of other elements.
void tie_node(const AbaqusData& data, std::int32_t node, const DeckPlace& place, AbaqusRigidBody& rigid) {
  if (rigid.own[node]) return;
  if (!data.used[node]) return data.report.ignore_node(place, "*RIGID BODY");
  rigid.tied.push_back(node);
}

void tie_nodes(const AbaqusData& data, const std::string& label, const DeckPlace& place, AbaqusRigidBody& rigid) {
  for (const std::int32_t node : data.nodes(label, place).members) {
    if (node != rigid.node) tie_node(data, node, place, rigid);
  }
}

/// Those that rigid elements have in common with solids.
void tie_common_nodes(const AbaqusData& data, AbaqusRigidBody& rigid) {
  for (const LayerNodes& layer : data.mesh.file.layers) {
    if (rigid.own[layer.below] && data.used[layer.middle] && !rigid.own[layer.middle])
      rigid.tied.push_back(layer.middle);
  }
  std::ranges::sort(rigid.tied);
  rigid.tied.erase(std::unique(rigid.tied.begin(), rigid.tied.end()), rigid.tied.end());
}

AbaqusRigidBody read_rigid_body(AbaqusData& data, const AbaqusComponent& component, const AbaqusBlock& block) {
  const auto label = [&](const std::string& own) { return component.name.empty() ? own : component.name + '.' + own; };
  AbaqusRigidBody rigid;
  rigid.card = card_of(block, block.place);
  if (block.has("ANALYTICALSURFACE")) {
    if (block.has("ELSET")) data.report.reject(block.place, "*RIGID BODY of an ELSET and an ANALYTICAL SURFACE");
    rigid.is_wall = true;
    rigid.node = reference_of(data, label(block.require("REFNODE")), block.place);
    data.add_wall(component, block);
    return rigid;
  }
  const std::string set = label(block.require("ELSET"));
  rigid.bodies = data.whole_bodies(set, block.place);
  if (rigid.bodies.empty())
    data.report.reject(block.place, "*RIGID BODY of a part of a section", "give its elements a section of their own");
  rigid.node = reference_of(data, label(block.require("REFNODE")), block.place);
  const std::vector<std::int32_t> elements = data.elements(set, block.place);
  if (block.option("POSITION") != "CENTEROFMASS")
    rigid.offset = offset_of(data, elements, data.mesh.file.mesh.nodes[rigid.node], [](std::int32_t) { return true; });
  rigid.own.assign(data.used.size(), false);
  for (const std::int32_t e : elements) {
    for (const std::int32_t node : data.mesh.file.mesh.hexahedra[e]) {
      data.rigid_of_node[node] = static_cast<std::int32_t>(data.rigid.size());
      rigid.own[node] = true;
    }
  }
  for (const char* option : {"TIENSET", "PINNSET"}) {  // nodes of solids have no rotations that a pin leaves free
    if (const auto tied = block.value(option)) tie_nodes(data, label(*tied), block.place, rigid);
  }
  tie_common_nodes(data, rigid);
  return rigid;
}

/// Whether *KINEMATIC couples nodes in all directions, as it does without any.
bool couples_all(const AbaqusBlock& kinematic) {
  DataLines lines(kinematic);
  unsigned coupled = 0;
  bool any = false;
  while (const auto card = lines.next()) {
    const DataFields f(*card);
    const std::int64_t first = f.integer(0, "first degree of freedom"), last = f.integer(1, "last one", first);
    for (std::int64_t degree = std::max<std::int64_t>(first, 1); degree <= std::min<std::int64_t>(last, 3); ++degree)
      coupled |= 1U << (degree - 1);
    any = true;
  }
  return !any || coupled == 7;
}

/// Nodes of a surface; their places in the mesh.
std::vector<bool> nodes_of_surface(const AbaqusData& data, const std::string& label, const DeckPlace& place) {
  std::vector<bool> nodes(data.used.size(), false);
  if (const FaceSet* set = data.find_faces(label)) {
    for (const auto& face : set->faces) {
      for (const std::int32_t node : face) {
        if (node >= 0) nodes[node] = true;
      }
    }
  } else {
    for (const std::int32_t node : data.nodes(label, place).members) nodes[node] = data.used[node];
  }
  return nodes;
}

/// *COUPLING with *KINEMATIC: the nodes of its surface move as one with their reference node. kinematic: what follows
/// it; null: nothing.
void read_coupling(AbaqusData& data, const AbaqusComponent& component, const AbaqusBlock& block,
                   const AbaqusBlock* kinematic) {
  const auto label = [&](const std::string& own) { return component.name.empty() ? own : component.name + '.' + own; };
  if (kinematic == nullptr || kinematic->name != "KINEMATIC")
    return data.report.reject(block.place, "*COUPLING without *KINEMATIC", "what is distributed is not there");
  if (!couples_all(*kinematic))
    return data.report.reject(kinematic->place, "*KINEMATIC of some directions", "give 1 to 3, or none, which is all");
  AbaqusRigidBody rigid;
  rigid.card = card_of(block, block.place);
  rigid.node = reference_of(data, label(block.require("REFNODE")), block.place, "*COUPLING");
  if (data.used[rigid.node])
    return data.report.reject(block.place, "*COUPLING with a reference node that an element has",
                              "give it a node of its own");
  if (data.rigid_at(rigid.node) != nullptr)
    return data.report.reject(block.place, "*COUPLING with the reference node of another one, or of a rigid body",
                              "give it a node of its own, or one surface to both");
  rigid.name = "coupling_" + AbaqusData::plain_name(label_key(block.require("CONSTRAINTNAME")));
  const std::string surface = label(block.require("SURFACE"));
  rigid.nodes = data.surface(surface, block.place).set;
  const std::vector<bool> coupled = nodes_of_surface(data, surface, block.place);
  if (std::ranges::none_of(coupled, std::identity{}))
    fail_at(block.place, fmt::format("*COUPLING: no element has a node of the surface {}", surface));
  rigid.offset = offset_of(data, data.elements("", block.place), data.mesh.file.mesh.nodes[rigid.node],
                           [&](std::int32_t node) { return coupled[node]; });
  if (data.rigid_of_node.empty()) data.rigid_of_node.assign(data.used.size(), -1);
  data.report.understood(fmt::format("*COUPLING ({}): the nodes of {} move as one, with the masses of their elements",
                                     block.place.text(), surface));
  data.rigid.push_back(std::move(rigid));
}

/// Directions are those of the centre: whether the reference node goes along with it in those that are held or moved.
bool moves_as_centre(const AbaqusRigidBody& rigid) {
  if (rigid.offset == Point{}) return true;
  std::vector<Point> turning;
  for (unsigned k = 0; k < 3; ++k) {
    if ((rigid.held >> (k + 3) & 1U) != 0) continue;
    turning.emplace_back();
    turning.back()[k] = 1;
  }
  if (turning.empty() || rigid.translations == 0) return true;
  if (turning.size() > 1) return false;
  const bool on_axis = norm(cross(turning[0], rigid.offset)) < 1e-9 * norm(rigid.offset);
  return on_axis || (rigid.translations == 1U && turning[0][0] == 1) ||
         (rigid.translations == 2U && turning[0][1] == 1) || (rigid.translations == 4U && turning[0][2] == 1);
}

}  // namespace

void find_abaqus_rigid_bodies(AbaqusData& data) {
  for (const AbaqusComponent& component : data.mesh.components) {
    for (const AbaqusBlock* const& block : component.blocks) {
      if (block->name == "COUPLING") {
        const AbaqusBlock* const* next = &block + 1;
        read_coupling(data, component, *block,
                      next == component.blocks.data() + component.blocks.size() ? nullptr : *next);
      }
      if (block->name != "RIGIDBODY") continue;
      if (data.rigid_of_node.empty()) data.rigid_of_node.assign(data.used.size(), -1);
      data.rigid.push_back(read_rigid_body(data, component, *block));
    }
  }
}

AbaqusRigidBody* AbaqusData::rigid_at(std::int32_t node) {
  const auto found = std::ranges::find(rigid, node, &AbaqusRigidBody::node);
  return found == rigid.end() ? nullptr : &*found;
}

bool AbaqusData::has_reference(const AbaqusNodes& nodes) {
  return std::ranges::any_of(nodes.members, [&](std::int32_t node) { return rigid_at(node) != nullptr; });
}

void translate_abaqus_rigid_bodies(AbaqusData& data, DeckScene& scene) {
  for (const AbaqusRigidBody& rigid : data.rigid) {
    if (rigid.is_wall) {
      if (rigid.held != 63U || rigid.velocity || rigid.angular_velocity)
        data.report.reject(rigid.card.place, "*RIGID BODY, ANALYTICAL SURFACE that is not held",
                           "hold its reference node (ENCASTRE), or give solids in its place");
      continue;
    }
    const auto keys = scene.entry<RigidBody>("rigid_body", rigid.card);
    if (rigid.is_coupling()) keys.set("name", rigid.name);
    if (!rigid.bodies.empty()) keys.set("bodies", rigid.bodies);
    set_abaqus_mass(data, rigid, keys);
    if ((rigid.held & 7U) != 0) keys.set("held", direction_names(rigid.held));
    if (rigid.held >> 3U != 0) keys.set("held_rotations", direction_names(rigid.held >> 3U));
    if (rigid.velocity || rigid.angular_velocity) {
      const Point spin = rigid.angular_velocity.value_or(Point{});
      keys.set("velocity", minus(rigid.velocity.value_or(Point{}), cross(spin, rigid.offset)));
      keys.set("angular_velocity", spin);
      data.report.understood(
          fmt::format("{} ({}): the initial velocities of its reference node are those of all "
                      "of it",
                      rigid.card.keyword, rigid.card.place.text()));
    }
    if (std::popcount(rigid.angles) > 1)
      data.report.reject(rigid.card.place, "*BOUNDARY of angles of a rigid body about several axes",
                         "give TYPE=VELOCITY");
    if (!moves_as_centre(rigid))
      data.report.reject(rigid.card.place,
                         rigid.card.keyword + " that is held or moved at a point that is not its centre",
                         "hold its rotations, or give POSITION=CENTER OF MASS");
  }
  for (const AbaqusRigidBody& rigid : data.rigid) {
    if (!rigid.tied.empty()) {
      std::vector<std::int64_t> numbers;
      for (const std::int32_t node : rigid.tied) numbers.push_back(data.mesh.file.node_ids[node]);
      const auto keys = scene.entry<AttachedNodes>("rigid_nodes", rigid.card);
      keys.set("rigid_body", rigid.bodies.front());
      keys.set("nodes", numbers);
    }
    if (!rigid.is_coupling()) continue;
    const auto keys = scene.entry<AttachedNodes>("rigid_nodes", rigid.card);
    keys.set("rigid_body", rigid.name);
    keys.set("set", rigid.nodes);
  }
}

}  // namespace pinball
