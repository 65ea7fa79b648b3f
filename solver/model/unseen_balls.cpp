#include "unseen_balls.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <solver/base/faces.hpp>

#include "exposed_faces.hpp"
#include "nodes_of_bodies.hpp"

namespace pinball {

namespace {

constexpr double soundest = 0.25;        ///< depth at which balls of two bodies have to overlap at the latest [-]
constexpr double soundest_folded = 0.5;  ///< of one body: deeper, balls push out on the other side [-]

/// The axis that is nearest to a direction.
std::size_t axis_of(const Point& direction) {
  std::size_t along = 0;
  for (std::size_t k = 1; k < 3; ++k) along = std::abs(direction[k]) > std::abs(direction[along]) ? k : along;
  return along;
}

struct Bounds {
  Point low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};
  void take(const Bounds& other) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], other.low[k]);
      high[k] = std::max(high[k], other.high[k]);
    }
  }
  void take(const Point& x) { take({x, x}); }
  /// Whether a part of it lies in front of a plane, by more than `least`.
  bool in_front(const Point& x, const Point& normal, double least) const {
    double height = 0;
    for (std::size_t k = 0; k < 3; ++k) height += ((normal[k] > 0 ? high[k] : low[k]) - x[k]) * normal[k];
    return height > least;
  }
  double edge(std::size_t k) const { return high[k] - low[k]; }
  /// Least edge that is across a normal.
  double width(const Point& normal) const {
    const std::size_t along = axis_of(normal);
    return std::min(edge((along + 1) % 3), edge((along + 2) % 3));
  }
  /// Whether a body in it is so thin along a normal that it may fold.
  bool thin(const Point& normal) const {
    constexpr double slender = 8;
    return std::max({edge(0), edge(1), edge(2)}) >= slender * edge(axis_of(normal));
  }
};

/// A ball behind a face.
struct FaceBall {
  std::int32_t element = -1;
  double radius = 0;     ///< of the ball [length]
  double thickness = 0;  ///< of the element, twice the distance from its centre to the face [length]
  double between = 0;    ///< half of the diagonal of the element along the face [length]
  double width = 0;      ///< of the body across the normal of the face [length]
};

/// What stands out of the faces of a body: the worst pairs are among these.
struct Extremes {
  FaceBall longest, broadest, smallest, largest;
  void take(const FaceBall& face) {
    const auto more = [&face](FaceBall& than, double value, double other) {
      if (than.element < 0 || value > other) than = face;
    };
    more(longest, face.thickness * longest.radius, longest.thickness * face.radius);
    more(broadest, face.between * broadest.radius, broadest.between * face.radius);
    more(smallest, smallest.radius, face.radius);
    more(largest, face.radius, largest.radius);
  }
  std::array<FaceBall, 4> all() const { return {longest, broadest, smallest, largest}; }
};

struct BodyFaces {
  Bounds box, others;
  Extremes towards_others;
};

/// Depth at which balls begin to overlap that are `apart` along the faces.
double depth_unseen(const FaceBall& a, const FaceBall& b, double apart) {
  const double reach = a.radius + b.radius, square = reach * reach - apart * apart;
  return square > 0 ? 1 - std::sqrt(square) / (0.5 * (a.thickness + b.thickness)) : 1.0;
}

/// Largest distance along the faces from a ball of one body to the nearest of the other.
double apart(const FaceBall& a, const FaceBall& b) {
  const FaceBall &small = a.between < b.between ? a : b, &large = a.between < b.between ? b : a;
  // Half the diagonal of a square as wide as the body, less the half elements at its ends.
  const double reaches_out = std::max(0.0, small.width / std::sqrt(2.0) - small.between);
  return std::max(small.between, large.between - reaches_out);
}

/// Elements of a mesh and what of them can be touched.
class MeshSurface {
 public:
  MeshSurface(const ModelMesh& mesh, const std::vector<PlaneConstraint>& symmetry, double radius_factor)
      : mesh_(mesh),
        radius_factor_(radius_factor),
        neighbours_(face_neighbours(mesh.hexahedra)),
        exposed_(find_exposed_faces(mesh, symmetry, neighbours_)) {}

  bool any_exposed(std::size_t e) const { return exposed_[e] != 0; }
  bool exposed(std::size_t e, std::size_t face) const { return (exposed_[e] >> face & 1U) != 0; }
  double radius(std::size_t e) const { return radius_factor_ * std::cbrt(3 * element_volume(mesh_, e) / (4 * M_PI)); }
  Point middle(std::size_t e, std::size_t face) const {
    Point mean{};
    for (const int corner : face_nodes[face]) {
      for (std::size_t k = 0; k < 3; ++k) mean[k] += mesh_.corner(e, corner)[k] / 4;
    }
    return mean;
  }
  /// Extent of an element along one of its axes; none between planes of symmetry.
  double extent(std::size_t e, std::size_t axis) const {
    const auto mirrored = [&](std::size_t face) { return neighbours_[e][face] == -1 && !exposed(e, face); };
    if (mirrored(2 * axis) && mirrored(2 * axis + 1)) return 0;
    return norm(minus(middle(e, 2 * axis + 1), middle(e, 2 * axis)));
  }
  FaceBall ball_behind(std::size_t e, std::size_t face, const Bounds& body) const {
    const Point towards = face_normal(mesh_, e, face);
    const std::size_t axis = face / 2;
    const double below = dot(minus(middle(e, face), element_centre(mesh_, e)), towards);
    const double across = std::hypot(extent(e, (axis + 1) % 3), extent(e, (axis + 2) % 3));
    return {static_cast<std::int32_t>(e), radius(e), 2 * below, 0.5 * across, body.width(towards)};
  }

 private:
  const ModelMesh& mesh_;
  double radius_factor_;
  std::vector<std::array<std::int32_t, 6>> neighbours_;
  std::vector<std::uint8_t> exposed_;
};

/// Boxes of the bodies, each with that of all others.
std::vector<BodyFaces> boxes_of(const ModelMesh& mesh) {
  std::vector<BodyFaces> bodies(mesh.body_names.size());
  for_nodes_of_bodies(mesh, [&](std::int32_t b, std::int32_t n) { bodies[b].box.take(mesh.nodes[n]); });
  Bounds before, after;
  for (BodyFaces& body : bodies) {
    body.others.take(before);
    before.take(body.box);
  }
  for (auto body = bodies.rbegin(); body != bodies.rend(); ++body) {
    body->others.take(after);
    after.take(body->box);
  }
  return bodies;
}

/// The pair that is farthest beyond what is sound.
struct Worst {
  std::optional<UnseenBalls> pair;
  double excess = 0;
  void take(const FaceBall& a, const FaceBall& b, double distance, double bound) {
    if (a.element < 0 || b.element < 0) return;
    const double depth = depth_unseen(a, b, distance);
    if (!(depth - bound > excess)) return;
    excess = depth - bound;
    pair = UnseenBalls{a.element, b.element, depth};
  }
};

}  // namespace

std::optional<UnseenBalls> find_unseen_balls(const Scene& scene, const ModelMesh& mesh) {
  const ContactSettings& contact = scene.contact;
  if (contact.method != ContactMethod::pinball || contact.gap != ContactGap::pinball) return {};
  const MeshSurface surface(mesh, scene.constraints, contact.radius_factor);
  std::vector<BodyFaces> bodies = boxes_of(mesh);
  Worst worst;
  for (std::size_t e = 0; e < mesh.hexahedra.size(); ++e) {
    if (!surface.any_exposed(e)) continue;
    BodyFaces& body = bodies[mesh.body[e]];
    for (std::size_t f = 0; f < 6; ++f) {
      if (!surface.exposed(e, f)) continue;
      const FaceBall face = surface.ball_behind(e, f, body.box);
      if (!(face.thickness > 0)) continue;
      const Point normal = face_normal(mesh, e, f);
      if (body.others.in_front(surface.middle(e, f), normal, 1e-6 * face.radius)) body.towards_others.take(face);
      const bool broad = face.thickness <= std::sqrt(2.0) * face.between;  // not thicker than wide
      if (contact.self && broad && body.box.thin(normal)) worst.take(face, face, face.between, soundest_folded);
    }
  }
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      for (const FaceBall& a : bodies[j].towards_others.all()) {
        for (const FaceBall& b : bodies[i].towards_others.all()) worst.take(a, b, apart(a, b), soundest);
      }
    }
  }
  return worst.pair;
}

}  // namespace pinball
