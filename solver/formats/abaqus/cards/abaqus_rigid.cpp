#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>

#include <solver/mesh/quality.hpp>

#include "abaqus_parts.hpp"

namespace pinball {

namespace {

constexpr double in_centre = 1e-3;  ///< of the size of a body: a reference node this near to its centre is in it

/// From the centre of the masses at the nodes to a point, or nothing where that is as good as there.
Point offset_of(const AbaqusData& data, const std::vector<std::int32_t>& elements, const Point& point) {
  const std::map<std::string, double> densities = abaqus_densities(data.deck);
  std::vector<double> density(data.mesh.file.parts.size(), 0.0);
  for (const AbaqusBody& body : data.bodies) {
    const auto found = densities.find(body.material);
    if (found != densities.end()) density[body.section] = found->second;
  }
  const Mesh& mesh = data.mesh.file.mesh;
  double mass = 0, size = 0;
  Point first{};
  for (const std::int32_t e : elements) {
    std::array<Point, 8> corners;
    for (std::size_t c = 0; c < 8; ++c) corners[c] = minus(mesh.nodes[mesh.hexahedra[e][c]], point);
    const double of_corner = density[data.mesh.file.part[e]] * volume_by_quadrature(corners) / 8;
    for (const Point& corner : corners) {
      mass += of_corner;
      for (std::size_t k = 0; k < 3; ++k) first[k] -= of_corner * corner[k];
      size = std::max(size, norm(minus(corner, corners[0])));
    }
  }
  for (double& component : first) component /= mass;
  for (const std::int32_t e : elements) {
    for (const std::int32_t node : mesh.hexahedra[e]) {
      const Point from_point = minus(mesh.nodes[node], point);
      size = std::max(size, norm(Point{from_point[0] + first[0], from_point[1] + first[1], from_point[2] + first[2]}));
    }
  }
  return norm(first) <= in_centre * size ? Point{} : first;
}

/// Place of the reference node in the mesh.
std::int32_t reference_of(const AbaqusData& data, const std::string& label, const DeckPlace& place) {
  const AbaqusNodes nodes = data.nodes(label, place);
  if (nodes.members.size() != 1)
    fail_at(place, fmt::format("*RIGID BODY: expected one reference node, got {}", nodes.members.size()));
  return nodes.members[0];
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
    rigid.offset = offset_of(data, elements, data.mesh.file.mesh.nodes[rigid.node]);
  for (const std::int32_t e : elements) {
    for (const std::int32_t node : data.mesh.file.mesh.hexahedra[e])
      data.rigid_of_node[node] = static_cast<std::int32_t>(data.rigid.size());
  }
  return rigid;
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
    for (const AbaqusBlock* block : component.blocks) {
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
    keys.set("bodies", rigid.bodies);
    if ((rigid.held & 7U) != 0) keys.set("held", direction_names(rigid.held));
    if (rigid.held >> 3U != 0) keys.set("held_rotations", direction_names(rigid.held >> 3U));
    if (rigid.velocity || rigid.angular_velocity) {
      const Point spin = rigid.angular_velocity.value_or(Point{});
      keys.set("velocity", minus(rigid.velocity.value_or(Point{}), cross(spin, rigid.offset)));
      keys.set("angular_velocity", spin);
      data.report.understood(
          fmt::format("*RIGID BODY ({}): the initial velocities of its reference node are those of all "
                      "of it",
                      rigid.card.place.text()));
    }
    if (std::popcount(rigid.angles) > 1)
      data.report.reject(rigid.card.place, "*BOUNDARY of angles of a rigid body about several axes",
                         "give TYPE=VELOCITY");
    if (!moves_as_centre(rigid))
      data.report.reject(rigid.card.place, "*RIGID BODY that is held or moved at a point that is not its centre",
                         "hold its rotations, or give POSITION=CENTER OF MASS");
  }
}

}  // namespace pinball
