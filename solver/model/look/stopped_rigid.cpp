#include "stopped_rigid.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include <solver/model/selection/node_selection.hpp>

#include "initial_motion.hpp"

namespace pinball {

namespace {

constexpr double none = 1e-9;  ///< of a velocity over all of it [-]

/// Of its centre; nothing where its nodes have several.
std::optional<Point> velocity_at_start(const RigidBody& rigid, const std::vector<std::int32_t>& nodes,
                                       const std::vector<Point>& of_node) {
  if (rigid.velocity) return rigid.velocity;
  if (nodes.empty()) return {};
  const Point first = of_node[nodes.front()];
  const auto is_other = [&](std::int32_t n) { return norm(minus(of_node[n], first)) > none * norm(first); };
  if (std::ranges::any_of(nodes, is_other)) return {};
  return first;
}

}  // namespace

std::vector<std::string> stopped_rigid_bodies(const Scene& scene, const ModelMesh& mesh) {
  std::vector<std::string> found;
  if (scene.rigid_bodies.empty()) return found;
  const std::vector<std::vector<std::int32_t>> nodes = nodes_of_rigid_bodies(scene, mesh);
  const std::vector<Point> of_node = initial_velocities(scene, mesh);
  for (std::size_t r = 0; r < nodes.size(); ++r) {
    const RigidBody& rigid = scene.rigid_bodies[r];
    const std::optional<Point> velocity = velocity_at_start(rigid, nodes[r], of_node);
    if (!velocity) continue;
    std::vector<Point> held = rigid.held;
    for (const PlaneConstraint& plane : scene.constraints) {
      const std::vector<std::int32_t> on_plane = matching_nodes(mesh, nodes_of(plane));
      const auto is_held = [&](std::int32_t n) { return std::ranges::binary_search(on_plane, n); };
      if (std::ranges::any_of(nodes[r], is_held)) held.push_back(plane.normal);
    }
    double stopped = 0;
    for (const Point& direction : held) stopped = std::max(stopped, std::abs(dot(*velocity, direction)));
    if (!(stopped > none * norm(*velocity))) continue;
    found.push_back(
        fmt::format("{}: rigid body {} is given a velocity of {:.4g} along a direction in which it is held: it "
                    "begins without",
                    rigid.where, rigid.name, stopped));
  }
  return found;
}

}  // namespace pinball
