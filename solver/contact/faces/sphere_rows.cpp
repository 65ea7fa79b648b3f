#include "sphere_rows.hpp"

#include <algorithm>
#include <cmath>

namespace pinball {

namespace {

/// What two distances of one point differ by at most that were found from two faces, over the distance [-].
constexpr double same_distance = 1e-9;

}  // namespace

template <class S>
void SphereRows<S>::add(const SurfaceSource<S>& source, const FeatureRow& row, const StepReach& step) {
  double closing = 0;
  for (int k = 0; k < row.nodes; ++k) {
    closing += row.weight[k] * dot(double_vector_of(source.v(row.node[k])), row.direction);
  }
  if (may_close(0 - row.depth, step.dt * closing, step.leap, row.reach)) rows_.push_back(row);
}

template <class S>
typename SphereRows<S>::Meeting SphereRows<S>::meeting_of(const SurfaceSource<S>& source,
                                                          const SegmentSurface<S>& surface, const Sphere& sphere,
                                                          std::int32_t segment) {
  const Vec3<double> centre = double_vector_of(source.x(sphere.node));
  Vec3<double> x[4];
  for (int k = 0; k < 4; ++k) x[k] = double_vector_of(source.x(surface.segments()[segment].node[k]));
  Meeting face{segment, project_onto_face(x, centre, 0.0, 0.0), centre, INFINITY};
  if (!(face.at.outside < INFINITY)) return face;
  for (int k = 0; k < 4; ++k) face.to = face.to - face.at.weight[k] * x[k];
  face.distance = std::sqrt(dot(face.to, face.to));
  return face;
}

/// At an edge sharper than a right angle what is outside, in front of one face, is behind the other, and so is what is
/// near: only the nearest face of the body tells. It is among those that all lists have, but where the centre is deeper
/// than the radius; then faces around this one are looked at, too.
template <class S>
bool SphereRows<S>::has_come_through(const SurfaceSource<S>& source, const SegmentSurface<S>& surface,
                                     const Sphere& sphere, const Meeting& face) const {
  const auto& segment = surface.segments()[face.segment];
  const double radius = sphere.radius, depth = 0 - face.at.gap;
  const auto listed_within = [&](std::int32_t s) {
    return radius + near_gap * static_cast<double>(surface.segments()[s].size);
  };
  if (face.at.outside > 0 || depth > static_cast<double>(segment.thickness) / 2) return false;
  if (depth > listed_within(face.segment)) return false;
  const double nearer = (1 - same_distance) * depth;
  const auto comes_nearer = [&](const Meeting& other) {
    return other.distance < nearer && surface.segments()[other.segment].body == segment.body &&
           other.distance <= listed_within(other.segment);
  };
  if (std::any_of(meetings_.begin(), meetings_.end(), comes_nearer)) return false;
  if (depth <= radius) return true;
  for (const std::int32_t slave : surface.slaves_of(face.segment)) {
    for (const std::int32_t s : surface.around(slave)) {
      if (surface.active_segment(s) && meeting_of(source, surface, sphere, s).distance < nearer) return false;
    }
  }
  return true;
}

/// Rows with the faces that the sphere has met.
template <class S>
void SphereRows<S>::add_faces(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, const Sphere& sphere,
                              const StepReach& step) {
  for (const Meeting& face : meetings_) {
    const auto& segment = surface.segments()[face.segment];
    const bool behind = face.at.gap < 0;  // out by the way that it came
    if (behind && !has_come_through(source, surface, sphere, face)) continue;
    const double radius = sphere.radius;
    FeatureRow row;
    row.direction = behind || !(face.distance > 0) ? face.at.normal : (1 / face.distance) * face.to;
    row.first = sphere.node;
    row.second = static_cast<std::int64_t>(segment.slot) * 6 + segment.face;
    row.depth = radius - (behind ? face.at.gap : face.distance);
    row.size = radius + segment.radius;
    row.reach = std::min(radius, static_cast<double>(segment.size));
    row.add_node(sphere.node, -1);
    row.add_side(segment.node, face.at.weight, 1);
    add(source, row, step);
  }
}

template <class S>
void SphereRows<S>::add_sphere(const SurfaceSource<S>& source, const Sphere& first, const Sphere& second,
                               const StepReach& step) {
  const Vec3<double> to = double_vector_of(source.x(first.node)) - double_vector_of(source.x(second.node));
  const double distance = std::sqrt(dot(to, to));
  if (!(distance > 0)) return;
  const auto radius1 = static_cast<double>(first.radius), radius2 = static_cast<double>(second.radius);
  FeatureRow row;
  row.first = first.node;
  row.second = ~second.node;
  row.direction = (1 / distance) * to;
  row.depth = radius1 + radius2 - distance;
  row.size = radius1 + radius2;
  row.reach = std::min(radius1, radius2);
  row.add_node(first.node, -1);
  row.add_node(second.node, 1);
  add(source, row, step);
}

template <class S>
void SphereRows<S>::find(const SurfaceSource<S>& source, const SegmentSurface<S>& surface,
                         const SphereSurface<S>& spheres, const SpherePairs& pairs, const StepReach& step) {
  rows_.clear();
  const auto takes_part = [&](std::int32_t s) { return surface.topology().alive(spheres.spheres()[s].slot); };
  const auto& listed = pairs.with_segments;  // sphere by sphere
  for (std::size_t i = 0; i < listed.size();) {
    const std::int32_t sphere = listed[i][0];
    meetings_.clear();
    for (; i < listed.size() && listed[i][0] == sphere; ++i) {
      if (!takes_part(sphere) || !surface.active_segment(listed[i][1])) continue;
      const Meeting face = meeting_of(source, surface, spheres.spheres()[sphere], listed[i][1]);
      if (face.distance < INFINITY) meetings_.push_back(face);
    }
    add_faces(source, surface, spheres.spheres()[sphere], step);
  }
  for (const auto& [first, second] : pairs.with_spheres) {
    if (!takes_part(first) || !takes_part(second)) continue;
    add_sphere(source, spheres.spheres()[first], spheres.spheres()[second], step);
  }
}

template class SphereRows<double>;
template class SphereRows<float>;

}  // namespace pinball
