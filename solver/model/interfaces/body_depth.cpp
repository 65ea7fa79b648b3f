#include "body_depth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <kernels/face_projection.hpp>
#include <kernels/hexahedron.hpp>
#include <solver/base/face_corners.hpp>

namespace pinball {

namespace {

/// Cosine between the normals of faces that approximate one curved surface, and of faces that look at each other.
constexpr double one_surface = 0.7, against = -0.3;

std::vector<Bounds> boxes_of(const ModelMesh& mesh, const std::vector<std::size_t>& elements) {
  std::vector<Bounds> boxes(elements.size());
  for (std::size_t i = 0; i < elements.size(); ++i) {
    for (const Point& corner : mesh.corners(elements[i])) boxes[i].take(corner);
  }
  return boxes;
}

Point scaled(double factor, const Point& p) { return {factor * p[0], factor * p[1], factor * p[2]}; }
Vec3<double> vector_of_point(const Point& p) { return {p[0], p[1], p[2]}; }

/// From a point to the nearest of a face. At a collapsed corner, where a foot cannot be found, to the nearest corner.
Vec3<double> way_to(const Vec3<double> (&corner)[4], const Vec3<double>& at) {
  const FaceProjection<double> foot = project_onto_face(corner, at, 0.0, 0.0);
  Vec3<double> best = corner[0] - at;
  for (int k = 1; k < 4; ++k) {
    const Vec3<double> to = corner[k] - at;
    if (dot(to, to) < dot(best, best)) best = to;
  }
  if (!(foot.outside < INFINITY)) return best;
  Vec3<double> to = (-1.0) * at;
  for (int k = 0; k < 4; ++k) to = to + foot.weight[k] * corner[k];
  return to;
}

}  // namespace

double depth_in(const ModelMesh& mesh, std::size_t element, const Point& x) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& face : face_nodes) {
    const auto corner = [&](int i) -> const Point& { return mesh.corner(element, face[i]); };
    const Point one = minus(corner(2), corner(0)), other = minus(corner(3), corner(1));
    const Point normal = cross(one, other);
    const double length = norm(normal);
    if (!(length > collapsed_share * norm(one) * norm(other))) continue;
    Point centre{};
    for (int i = 0; i < 4; ++i) {
      for (std::size_t k = 0; k < 3; ++k) centre[k] += corner(i)[k] / 4;
    }
    const Point to = minus(centre, x);
    least = std::min(least, (to[0] * normal[0] + to[1] * normal[1] + to[2] * normal[2]) / length);
  }
  return least;
}

BodyInside::BodyInside(const ModelMesh& mesh, const std::vector<std::size_t>& elements, const Bounds& box)
    : mesh_(mesh), elements_(elements), grid_(boxes_of(mesh, elements), box) {}

bool BodyInside::holds(const Point& x, double depth) const {
  const auto& near = grid_.at(x);
  return std::any_of(near.begin(), near.end(), [&](std::size_t i) {
    const std::size_t e = elements_[i];
    return depth_in(mesh_, e, x) > depth * std::cbrt(std::max(0.0, element_volume(mesh_, e)));
  });
}

double BodyInside::depth_at(const Point& x) const {
  double deepest = 0;
  for (const std::size_t i : grid_.at(x)) deepest = std::max(deepest, depth_in(mesh_, elements_[i], x));
  return deepest;
}

BodySurface::BodySurface(const ModelMesh& mesh, const std::vector<std::size_t>& elements,
                         const std::vector<std::uint8_t>& exposed)
    : mesh_(mesh) {
  std::vector<Bounds> boxes;
  for (const std::size_t e : elements) {
    for (unsigned f = 0; f < 6; ++f) {
      if ((exposed[e] >> f & 1U) == 0) continue;
      const auto node = face_of(mesh.hexahedra[e], f);
      const auto at = [&](std::size_t i) -> const Point& { return mesh.nodes[node[i]]; };
      const Point area = scaled(0.5, cross(minus(at(2), at(0)), minus(at(3), at(1))));
      const double size = norm(area);
      if (!(size > 0)) continue;
      faces_.push_back({node, scaled(1 / size, area), std::sqrt(size)});
      Bounds& box = boxes.emplace_back();
      for (std::size_t i = 0; i < 4; ++i) {
        box.take(at(i));
        box_.take(at(i));
      }
    }
  }
  measure_facets();
  if (!faces_.empty()) grid_.emplace_back(boxes, box_);
}

/// An edge of length l between normals n_1 and n_2 is the chord of an arc that stands out of it by l |n_2 - n_1| / 8; a
/// face adds the two directions. The normal at a corner is the mean of the faces there that make one surface with it.
void BodySurface::measure_facets() {
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    for (const std::int32_t n : faces_[f].node) around_[n].push_back(f);
  }
  for (Face& face : faces_) {
    std::array<Point, 4> normal{};
    for (std::size_t i = 0; i < 4; ++i) {
      for (const std::size_t f : around_[face.node[i]]) {
        if (dot(faces_[f].normal, face.normal) < one_surface) continue;
        for (std::size_t k = 0; k < 3; ++k) normal[i][k] += faces_[f].normal[k];
      }
      normal[i] = scaled(1 / norm(normal[i]), normal[i]);
    }
    const auto arc = [&](std::size_t a, std::size_t b) {
      return norm(minus(mesh_.nodes[face.node[b]], mesh_.nodes[face.node[a]])) * norm(minus(normal[b], normal[a])) / 8;
    };
    face.facets = std::max(arc(0, 1), arc(2, 3)) + std::max(arc(1, 2), arc(3, 0));
  }
}

std::vector<Point> BodySurface::normals_at(std::int32_t node) const {
  std::vector<Point> normals;
  const auto found = around_.find(node);
  if (found == around_.end()) return normals;
  for (const std::size_t f : found->second) normals.push_back(faces_[f].normal);
  return normals;
}

BodyDepth BodySurface::depth_of(const Point& x, const std::vector<Point>& facing) const {
  BodyDepth best;
  if (grid_.empty()) return best;
  double nearest = INFINITY;
  const Vec3<double> at = vector_of_point(x);
  grid_.front().outwards(
      x,
      [&](std::size_t f) {
        const Face& face = faces_[f];
        const auto looks_at = [&](const Point& normal) { return dot(normal, face.normal) < against; };
        if (!facing.empty() && std::none_of(facing.begin(), facing.end(), looks_at)) return;
        Vec3<double> corner[4];
        for (std::size_t k = 0; k < 4; ++k) corner[k] = vector_of_point(mesh_.nodes[face.node[k]]);
        const Vec3<double> to = way_to(corner, at);
        const double distance = std::sqrt(dot(to, to));
        if (!(distance < nearest)) return;
        nearest = distance;
        best = {distance, face.facets, face.size, {to.x, to.y, to.z}};
      },
      [&] { return nearest; });
  return best;
}

}  // namespace pinball
