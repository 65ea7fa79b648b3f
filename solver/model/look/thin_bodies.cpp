#include "thin_bodies.hpp"

#include <fmt/core.h>

#include <solver/base/faces.hpp>
#include <solver/base/point.hpp>
#include <solver/model/exposed_faces.hpp>
#include <solver/model/nodes_of_bodies.hpp>
#include <solver/model/selection/node_selection.hpp>

namespace pinball {

namespace {

/// A layer has a node above and one below: no mesh of one layer has fewer nodes, and of meshes of more only bars of few
/// elements have as many.
constexpr double nodes_of_layer = 1.99;
/// Part of the outer faces of a body that lie opposite to each other on one element: of a plate of one layer all but
/// the rim, of a bar of one element all but its ends.
constexpr double most_faces = 0.6;

/// Nodes that cannot move freely, with the directions in which they cannot.
class Stopped {
 public:
  Stopped(const Scene& scene, const ModelMesh& mesh) : of_node_(mesh.nodes.size()) {
    const auto stop = [&](const NodeSelection& nodes, const std::vector<Point>& directions) {
      for (const std::int32_t n : matching_nodes(mesh, nodes)) {
        auto& own = of_node_[n];
        own.insert(own.end(), directions.begin(), directions.end());
      }
    };
    for (const PlaneConstraint& plane : scene.constraints) stop(nodes_of(plane), {plane.normal});
    for (const FixedConstraint& fixed : scene.fixed_constraints) {
      if (fixed.frame == Frame::global) stop(fixed.nodes, fixed.directions);
    }
  }
  /// Whether all corners of a face are held along its normal.
  bool stops(const ModelMesh& mesh, std::size_t element, int face) const {
    const Point normal = face_normal(mesh, element, face);
    for (const int i : face_nodes[face]) {
      const std::size_t n = mesh.hexahedra[element][i];
      const bool held =
          std::ranges::any_of(of_node_[n], [&](const Point& d) { return std::abs(dot(d, normal)) > 0.7; });
      if (!held) return false;
    }
    return true;
  }

 private:
  std::vector<std::vector<Point>> of_node_;
};

/// Elements of bodies that may be one layer.
struct Candidate {
  std::int32_t body;
  std::vector<std::size_t> elements;
};

bool is_of_rigid_body(const Scene& scene, const std::string& body) {
  return std::ranges::any_of(scene.rigid_bodies, [&](const RigidBody& rigid) {
    return std::ranges::find(rigid.bodies, body) != rigid.bodies.end();
  });
}

std::vector<Candidate> candidates(const Scene& scene, const ModelMesh& mesh) {
  const std::vector<std::size_t> material = material_of_bodies(scene);
  std::vector<double> nodes(scene.bodies.size(), 0.0), elements(scene.bodies.size(), 0.0);
  for_nodes_of_bodies(mesh, [&](std::int32_t b, std::int32_t) { ++nodes[b]; });
  for (const std::int32_t b : mesh.body) ++elements[b];
  std::vector<Candidate> found;
  std::vector<std::int32_t> place(scene.bodies.size(), -1);
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    if (!scene.materials[material[b]].plastic || nodes[b] < nodes_of_layer * elements[b]) continue;
    if (is_of_rigid_body(scene, scene.bodies[b].name)) continue;  // it does not bend
    place[b] = found.size();
    found.push_back({static_cast<std::int32_t>(b), {}});
  }
  if (found.empty()) return found;
  for (std::size_t e = 0; e < mesh.body.size(); ++e) {
    const std::int32_t own = place[mesh.body[e]];
    if (own >= 0) found[own].elements.push_back(e);
  }
  return found;
}

/// Part of the free outer faces of some elements that have another one opposite on the same element.
double share_of_one_layer(const ModelMesh& mesh, const std::vector<std::size_t>& elements, const Stopped& stopped) {
  std::vector<std::array<std::int32_t, 8>> hexahedra;
  for (const std::size_t e : elements) hexahedra.push_back(mesh.hexahedra[e]);
  const auto neighbours = face_neighbours(hexahedra);
  double outer = 0, opposite = 0;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const auto is_free = [&](int f) { return neighbours[i][f] == -1 && !stopped.stops(mesh, elements[i], f); };
    for (int f = 0; f < 6; f += 2) {  // faces 2 k and 2 k + 1 lie opposite to each other
      const bool one = is_free(f), other = is_free(f + 1);
      outer += (one ? 1 : 0) + (other ? 1 : 0);
      opposite += one && other ? 2 : 0;
    }
  }
  return outer > 0 ? opposite / outer : 0.0;
}

}  // namespace

std::string find_thin_body(const Scene& scene, const ModelMesh& mesh) {
  const std::vector<Candidate> all = candidates(scene, mesh);
  if (all.empty()) return "";
  const Stopped stopped(scene, mesh);
  for (const Candidate& candidate : all) {
    if (share_of_one_layer(mesh, candidate.elements, stopped) < most_faces) continue;
    return fmt::format(
        "body {} has one layer of elements through its thickness, {} in all: what yields in bending, or is pierced, "
        "needs three layers or more",
        mesh.body_names[candidate.body], candidate.elements.size());
  }
  return "";
}

}  // namespace pinball
