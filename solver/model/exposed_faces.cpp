#include "exposed_faces.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <kernels/hexahedron.hpp>
#include <solver/base/face_corners.hpp>
#include <solver/base/point.hpp>
#include <solver/model/selection/node_selection.hpp>

namespace pinball {

namespace {

/// Cosine between the normals of a face and of the plane in which it lies: nodes of a rough mesh are off the plane by
/// up to the tolerance of the constraint.
constexpr double least_cosine = 0.7;

/// Per node of the mesh whether a plane of symmetry holds it.
std::vector<bool> held_by(const PlaneConstraint& plane, const ModelMesh& mesh) {
  std::vector<bool> held(mesh.nodes.size(), false);
  for (const std::int32_t n : matching_nodes(mesh, nodes_of(plane))) held[n] = true;
  return held;
}

}  // namespace

Point face_normal(const ModelMesh& mesh, std::size_t element, std::size_t face) {
  const auto corner = [&](int i) { return mesh.corner(element, face_nodes[face][i]); };
  Point normal = cross(minus(corner(2), corner(0)), minus(corner(3), corner(1)));
  const double length = norm(normal);
  for (double& n : normal) n /= length > 0 ? length : 1;
  return normal;
}

std::vector<std::uint8_t> find_exposed_faces(const ModelMesh& mesh, const std::vector<PlaneConstraint>& symmetry,
                                             const std::vector<std::array<std::int32_t, 6>>& neighbours) {
  std::vector<std::uint8_t> exposed(neighbours.size(), 0);
  std::vector<std::vector<bool>> held;
  for (const PlaneConstraint& plane : symmetry) held.push_back(held_by(plane, mesh));
  for (std::size_t e = 0; e < neighbours.size(); ++e) {
    const std::string& body = mesh.body_of_element(e);
    for (unsigned f = 0; f < 6; ++f) {
      if (neighbours[e][f] != -1) continue;
      bool continued = false;
      for (std::size_t p = 0; p < symmetry.size() && !continued; ++p) {
        if (!symmetry[p].body.empty() && symmetry[p].body != body) continue;
        continued = std::all_of(std::begin(face_nodes[f]), std::end(face_nodes[f]),
                                [&](int corner) { return held[p][mesh.hexahedra[e][corner]]; }) &&
                    std::abs(dot(face_normal(mesh, e, f), symmetry[p].normal)) > least_cosine;
      }
      if (!continued) exposed[e] |= 1U << f;
    }
  }
  return exposed;
}

std::vector<std::uint8_t> find_split_faces(const ModelMesh& mesh,
                                           const std::vector<std::array<std::int32_t, 6>>& neighbours) {
  using Corners = std::array<std::int32_t, 4>;
  using Place = std::pair<std::size_t, unsigned>;  // an element and its face
  std::vector<std::uint8_t> split(neighbours.size(), 0);
  std::map<Corners, Place> triangles;
  std::vector<Place> quadrangles;
  for (std::size_t e = 0; e < neighbours.size(); ++e) {
    for (unsigned f = 0; f < 6; ++f) {
      if (neighbours[e][f] != -1) continue;
      const Corners key = face_key(face_of(mesh.hexahedra[e], f));
      if (key[3] >= 0)
        quadrangles.push_back({e, f});
      else
        triangles[key] = {e, f};
    }
  }
  if (triangles.empty()) return split;
  for (const auto& [e, f] : quadrangles) {
    const Corners q = face_of(mesh.hexahedra[e], f);
    const Point normal = face_normal(mesh, e, f);
    for (std::size_t first = 0; first < 2; ++first) {  // the corner at which the diagonal begins
      const auto half = [&](std::size_t second, std::size_t third) {
        const auto found = triangles.find(face_key({q[first], q[second], q[third], q[third]}));
        const bool opposite = found != triangles.end() &&
                              dot(face_normal(mesh, found->second.first, found->second.second), normal) < -least_cosine;
        return opposite ? &found->second : nullptr;
      };
      const Place* const one = half(first + 1, first + 2);
      const Place* const other = half(first + 2, (first + 3) % 4);
      if (one == nullptr || other == nullptr) continue;
      for (const Place& place : {Place{e, f}, *one, *other}) split[place.first] |= 1U << place.second;
    }
  }
  return split;
}

}  // namespace pinball
