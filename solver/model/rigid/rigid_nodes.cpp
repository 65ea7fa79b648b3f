#include "rigid_nodes.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <span>

#include <solver/base/error.hpp>
#include <solver/model/selection/node_selection.hpp>

namespace pinball {

namespace {

/// Gives nodes to a rigid body. Throws InputError where one is of another. where: of who gives them; null: of the
/// bodies.
void take_nodes(const Scene& scene, std::span<const std::int32_t> nodes, std::int32_t rigid, const std::string* where,
                std::vector<std::int32_t>& of_node) {
  for (const std::int32_t n : nodes) {
    std::int32_t& own = of_node[n];
    if (own >= 0 && own != rigid) {
      throw InputError(
          fmt::format("{}: expected rigid bodies without common nodes, {} and {} share some: name the "
                      "bodies of both in one [[rigid_body]]",
                      where != nullptr ? *where : scene.rigid_bodies[std::max(own, rigid)].where,
                      scene.rigid_bodies[own].name, scene.rigid_bodies[rigid].name));
    }
    own = rigid;
  }
}

/// Number of the rigid body of each node of the scene, or -1. of_body: the same of its bodies.
std::vector<std::int32_t> rigid_body_of_nodes(const Scene& scene, const ModelMesh& mesh,
                                              const std::vector<std::int32_t>& of_body) {
  std::vector<std::int32_t> of_node(mesh.nodes.size(), -1);
  for (std::size_t e = 0; e < mesh.hexahedra.size(); ++e) {
    const std::int32_t rigid = of_body[mesh.body[e]];
    if (rigid < 0) continue;
    take_nodes(scene, mesh.hexahedra[e], rigid, nullptr, of_node);
  }
  for (const AttachedNodes& attached : scene.attached_nodes) {
    take_nodes(scene, select_nodes(mesh, attached.nodes), rigid_body_of_name(scene, attached.rigid_body),
               &attached.nodes.where, of_node);
  }
  return of_node;
}

/// Refuses what would act on single nodes of a rigid body.
class NodesThatMove {
 public:
  NodesThatMove(const Scene& scene, const std::vector<std::int32_t>& rigid_of_node)
      : scene_(scene), rigid_of_node_(rigid_of_node) {}

  void check(const std::vector<std::int32_t>& nodes, const std::string& where, const char* what,
             const char* instead) const {
    for (const std::int32_t n : nodes) {
      const std::int32_t rigid = rigid_of_node_[n];
      if (rigid < 0) continue;
      throw InputError(fmt::format("{}: {} nodes of the rigid body {}: expected none of them; {}", where, what,
                                   scene_.rigid_bodies[rigid].name, instead));
    }
  }

 private:
  const Scene& scene_;
  const std::vector<std::int32_t>& rigid_of_node_;
};

/// A direction that is held already, or a part of it, counts once.
void add_direction(std::vector<Point>& directions, Point direction) {
  if (make_orthogonal(direction, directions) > 1e-6) directions.push_back(direction);
}

/// What lies across a plane of symmetry mirrors what lies on this side: a body that reaches it moves along it and turns
/// about its normal.
void hold_at_plane(const Point& normal, RigidNodes& rigid) {
  add_direction(rigid.held, normal);
  const Point one = std::abs(normal[0]) < 0.5 ? Point{1, 0, 0} : Point{0, 1, 0};
  const Point along = cross(normal, one);
  std::vector<Point> tangents;
  add_direction(tangents, along);
  add_direction(tangents, cross(normal, along));
  for (const Point& tangent : tangents) add_direction(rigid.held_rotations, tangent);
}

}  // namespace

std::int32_t rigid_body_of_name(const Scene& scene, const std::string& name) {
  const auto found = std::ranges::find(scene.rigid_bodies, name, &RigidBody::name);
  return static_cast<std::int32_t>(found - scene.rigid_bodies.begin());
}

std::vector<std::int32_t> rigid_body_of_bodies(const Scene& scene) {
  std::vector<std::int32_t> of_body(scene.bodies.size(), -1);
  for (std::size_t r = 0; r < scene.rigid_bodies.size(); ++r) {
    for (const std::string& name : scene.rigid_bodies[r].bodies) {
      const auto body = std::ranges::find(scene.bodies, name, &Body::name);
      if (body != scene.bodies.end()) of_body[body - scene.bodies.begin()] = static_cast<std::int32_t>(r);
    }
  }
  return of_body;
}

std::size_t body_with(const Scene& scene, const ModelMesh& mesh, const RigidBody& rigid) {
  if (!rigid.bodies.empty())
    return std::ranges::find(scene.bodies, rigid.bodies.front(), &Body::name) - scene.bodies.begin();
  const auto attached = std::ranges::find(scene.attached_nodes, rigid.name, &AttachedNodes::rigid_body);
  return mesh.body_of_node[matching_nodes(mesh, attached->nodes).front()];
}

std::vector<RigidNodes> find_rigid_nodes(const Scene& scene, const ModelMesh& mesh,
                                         const std::vector<TiedNode>& tied_nodes) {
  std::vector<RigidNodes> all(scene.rigid_bodies.size());
  if (all.empty()) return all;
  const std::vector<std::int32_t> of_body = rigid_body_of_bodies(scene);
  const std::vector<std::int32_t> of_node = rigid_body_of_nodes(scene, mesh, of_body);
  for (std::size_t n = 0; n < of_node.size(); ++n) {
    if (of_node[n] >= 0) all[of_node[n]].nodes.push_back(n);
  }
  for (std::size_t r = 0; r < all.size(); ++r) {
    if (all[r].nodes.empty()) {
      const RigidBody& rigid = scene.rigid_bodies[r];
      throw InputError(fmt::format("{}: rigid body {}: expected bodies, or nodes of [[rigid_nodes]], it has none",
                                   rigid.where, rigid.name));
    }
    const auto first = std::ranges::find(of_body, static_cast<std::int32_t>(r));
    if (first != of_body.end()) all[r].first_body = static_cast<std::int32_t>(first - of_body.begin());
    all[r].held = scene.rigid_bodies[r].held;
    all[r].held_rotations = scene.rigid_bodies[r].held_rotations;
  }
  for (const PlaneConstraint& plane : scene.constraints) {
    std::vector<bool> reaches(all.size(), false);
    for (const std::int32_t n : matching_nodes(mesh, nodes_of(plane))) {
      if (of_node[n] >= 0) reaches[of_node[n]] = true;
    }
    for (std::size_t r = 0; r < all.size(); ++r) {
      if (reaches[r]) hold_at_plane(plane.normal, all[r]);
    }
  }
  const NodesThatMove check(scene, of_node);
  for (const FixedConstraint& fixed : scene.fixed_constraints)
    check.check(matching_nodes(mesh, fixed.nodes), fixed.nodes.where, "holds",
                "rigid_body.held and held_rotations hold the body");
  for (const PrescribedVelocity& given : scene.prescribed_velocities)
    check.check(matching_nodes(mesh, given.nodes), given.nodes.where, "moves", "[[rigid_motion]] moves the body");
  for (const RigidWall& wall : scene.rigid_walls)
    check.check(matching_nodes(mesh, nodes_of(wall)), wall.where, "would stop single",
                "rigid walls know no rigid bodies in this version, contact with one that is held does");
  for (const TiedNode& tied : tied_nodes) {
    const auto& c = tied.corner;
    check.check({tied.node, c[0], c[1], c[2], c[3]}, scene.tied_contacts[tied.tie].where, "ties",
                "ties know no rigid bodies in this version; nodes that bodies share with a rigid one move with it");
  }
  return all;
}

void number_rigid_nodes(std::vector<RigidNodes>& all, const std::vector<std::int32_t>& node_of_scene_node) {
  for (RigidNodes& rigid : all) {
    for (std::int32_t& node : rigid.nodes) node = node_of_scene_node[node];
    std::ranges::sort(rigid.nodes);
  }
}

void set_given_masses(Scene& scene, const ModelMesh& mesh) {
  if (std::ranges::none_of(scene.rigid_bodies, [](const RigidBody& rigid) { return rigid.mass > 0; })) return;
  const std::vector<std::int32_t> of_body = rigid_body_of_bodies(scene);
  const std::vector<std::size_t> material = material_of_bodies(scene);
  std::vector<double> mass(scene.rigid_bodies.size(), 0.0);
  for (std::size_t e = 0; e < mesh.hexahedra.size(); ++e) {
    const std::size_t body = mesh.body[e];
    if (of_body[body] >= 0) mass[of_body[body]] += scene.materials[material[body]].density * element_volume(mesh, e);
  }
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    if (of_body[b] < 0) continue;
    const RigidBody& rigid = scene.rigid_bodies[of_body[b]];
    if (!(rigid.mass > 0)) continue;
    Material own = scene.materials[material[b]];
    own.density *= rigid.mass / mass[of_body[b]];
    own.name = fmt::format("{} of {}", own.name, scene.bodies[b].name);  // no name of a file has a space
    scene.bodies[b].material = own.name;
    scene.materials.push_back(own);
  }
}

}  // namespace pinball
