#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include <solver/base/error.hpp>
#include <solver/model/element_checks.hpp>
#include <solver/model/initial_overlap.hpp>
#include <solver/model/place_names.hpp>
#include <solver/model/rigid/rigid_nodes.hpp>
#include <solver/model/selection/node_selection.hpp>

#include "overlapping_bodies.hpp"

namespace pinball {

namespace {

/// Nodes are moved by half of their depths at first, because nodes on the other side may move as far; where there are
/// none, the halves add up, and the last passes move them all the way.
constexpr int passes_by_halves = 6, most_passes = 10;
/// Depth that is not worth a way, over the size of a face.
constexpr double least_way = 1e-6;

/// The directions in which nodes stay where they are.
class Held {
 public:
  Held(const Scene& scene, const std::vector<TiedNode>& ties, const ModelMesh& mesh) : directions_(mesh.nodes.size()) {
    for (const PlaneConstraint& plane : scene.constraints) {
      for (const std::int32_t n : matching_nodes(mesh, nodes_of(plane))) hold(n, plane.normal);
    }
    for (const FixedConstraint& fixed : scene.fixed_constraints) {
      for (const std::int32_t n : matching_nodes(mesh, fixed.nodes)) {
        if (fixed.frame != Frame::global) hold_all(n);
        for (const Point& direction : fixed.directions) hold(n, direction);
      }
    }
    for (const TiedNode& tied : ties) hold_all(tied.node);
  }
  /// What of a way a node may go.
  Point free_part(std::size_t node, Point way) const {
    for (const Point& d : directions_[node]) {
      const double along = dot(way, d);
      for (std::size_t k = 0; k < 3; ++k) way[k] -= along * d[k];
    }
    return way;
  }

 private:
  void hold(std::int32_t node, Point direction) {
    if (make_orthogonal(direction, directions_[node]) > 1e-6) directions_[node].push_back(direction);
  }
  void hold_all(std::int32_t node) {
    for (std::size_t k = 0; k < 3; ++k) {
      Point axis{};
      axis[k] = 1;
      hold(node, axis);
    }
  }
  std::vector<std::vector<Point>> directions_;  ///< per node, at right angles to each other
};

void check_volumes(const Scene& scene, const ModelMesh& mesh, const std::vector<std::uint8_t>& moved) {
  for (std::int64_t e = 0; e < mesh.element_count(); ++e) {
    const auto& nodes = mesh.hexahedra[e];
    if (std::none_of(nodes.begin(), nodes.end(), [&](std::int32_t n) { return moved[n] != 0; })) continue;
    const std::string problem = volume_problem(mesh.corners(e), scene.precision);
    if (problem.empty()) continue;
    throw InputError(
        fmt::format("{}{} {} when its nodes are put on the surface of the body that they lie in "
                    "(contact.overlap = \"adjust\"): move the bodies apart",
                    message_head(scene), element_name(mesh, e), problem));
  }
}

}  // namespace

void adjust_initial_overlaps(const Scene& scene, const std::vector<TiedNode>& ties, ModelMesh& mesh) {
  if (scene.contact.method == ContactMethod::none || scene.contact.overlap != ContactOverlap::adjust) return;
  const Held held(scene, ties, mesh);
  std::vector<std::uint8_t> moved(mesh.nodes.size(), 0);
  bool any = true;
  for (int pass = 0; pass < most_passes && any; ++pass) {
    any = false;
    const OverlappingBodies bodies(mesh, scene.contact_pairs, rigid_body_of_bodies(scene));
    NodeDepths depths(scene, mesh, bodies);
    std::vector<std::pair<std::size_t, Point>> ways;
    bodies.for_each([&](std::size_t a, std::size_t b, const Bounds& box) {
      depths.for_each(a, b, box, least_way, [&](std::size_t node, const BodyDepth& depth) {
        ways.emplace_back(node, held.free_part(node, depth.out));
      });
      return true;
    });
    const double part = pass < passes_by_halves ? 0.5 : 1.0;
    for (const auto& [node, way] : ways) {
      if (!(dot(way, way) > 0)) continue;
      any = true;
      moved[node] = 1;
      for (std::size_t k = 0; k < 3; ++k) mesh.nodes[node][k] += part * way[k];
    }
  }
  check_volumes(scene, mesh, moved);
}

}  // namespace pinball
