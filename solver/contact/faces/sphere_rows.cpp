#include "sphere_rows.hpp"

#include <algorithm>
#include <cmath>

#include <kernels/face_projection.hpp>

namespace pinball {

template <class S>
void SphereRows<S>::add(const SurfaceSource<S>& source, const FeatureRow& row, const StepReach& step) {
  double closing = 0;
  for (int k = 0; k < row.nodes; ++k) {
    closing += row.weight[k] * dot(double_vector_of(source.v(row.node[k])), row.direction);
  }
  if (may_close(0 - row.depth, step.dt * closing, step.leap, row.reach)) rows_.push_back(row);
}

template <class S>
void SphereRows<S>::add_face(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, const Sphere& sphere,
                             std::int32_t number, const StepReach& step) {
  if (!surface.active_segment(number)) return;
  const auto& segment = surface.segments()[number];
  const Vec3<double> centre = double_vector_of(source.x(sphere.node));
  Vec3<double> x[4];
  for (int k = 0; k < 4; ++k) x[k] = double_vector_of(source.x(segment.node[k]));
  const FaceProjection<double> at = project_onto_face(x, centre, 0.0, 0.0);
  if (!(at.outside < INFINITY)) return;
  Vec3<double> to = centre;
  for (int k = 0; k < 4; ++k) to = to - at.weight[k] * x[k];
  const double distance = std::sqrt(dot(to, to));
  FeatureRow row;
  const bool inside = at.gap < 0;  // the centre has gone through: out by the way that it came
  const double radius = sphere.radius;
  if (inside && (at.outside > 0 || at.gap < -static_cast<double>(segment.thickness) / 2)) return;
  row.direction = inside || !(distance > 0) ? at.normal : (1 / distance) * to;
  row.first = sphere.node;
  row.second = static_cast<std::int64_t>(segment.slot) * 6 + segment.face;
  row.depth = radius - (inside ? at.gap : distance);
  row.size = radius + segment.radius;
  row.reach = std::min(radius, static_cast<double>(segment.size));
  row.add_node(sphere.node, -1);
  row.add_side(segment.node, at.weight, 1);
  add(source, row, step);
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
  for (const auto& [sphere, segment] : pairs.with_segments) {
    if (takes_part(sphere)) add_face(source, surface, spheres.spheres()[sphere], segment, step);
  }
  for (const auto& [first, second] : pairs.with_spheres) {
    if (!takes_part(first) || !takes_part(second)) continue;
    add_sphere(source, spheres.spheres()[first], spheres.spheres()[second], step);
  }
}

template class SphereRows<double>;
template class SphereRows<float>;

}  // namespace pinball
