#include "near_faces.hpp"

#include <algorithm>
#include <cmath>

#include "outward.hpp"

namespace pinball {

namespace {

/// What two distances of one point differ by at most that were found from two faces, over the distance [-].
constexpr double same_distance = 1e-9;

/// How a point lies to a face as it is now.
template <class S>
NearestOnFace<double> nearest_on(const SurfaceSource<S>& source, const std::int32_t (&node)[4],
                                 const Vec3<double>& centre) {
  Vec3<double> x[4];
  for (int k = 0; k < 4; ++k) x[k] = double_vector_of(source.x(node[k]));
  return nearest_on_face(x, centre);
}

}  // namespace

template <class S>
void NearFaces<S>::collect(const SurfaceSource<S>& source, const SegmentSurface<S>& surface,
                           const SphereSurface<S>& spheres, const SphereLists<S>& lists, std::int64_t number) {
  candidates_.clear();
  const auto& sphere = spheres.spheres()[number];
  const Vec3<double> centre = double_vector_of(source.x(sphere.node));
  for (std::int64_t place = lists.first(number); place < lists.first(number + 1); ++place) {
    const std::int32_t s = lists.segment(place);
    if (!surface.active_segment(s)) continue;
    const auto& segment = surface.segments()[s];
    const double within =
        std::max(static_cast<double>(sphere.radius), deepest_centre * static_cast<double>(segment.thickness));
    Vec3<double> x[4];
    for (int k = 0; k < 4; ++k) x[k] = double_vector_of(source.x(segment.node[k]));
    const Vec3<double> to = centre - 0.25 * (x[0] + x[1] + x[2] + x[3]);
    const Vec3<double> diagonal1 = x[2] - x[0], diagonal2 = x[3] - x[1];
    const double extent2 = std::max(dot(diagonal1, diagonal1), dot(diagonal2, diagonal2));  // no corner is further off
    if (dot(to, to) > 2 * (within * within + extent2)) continue;
    const NearestOnFace<double> at = nearest_on_face(x, centre);
    if (at.distance < within) candidates_.push_back({s, segment.body, at});
  }
}

/// Whether no other face that has the same point on its rim comes nearer; of several that do not, the first.
template <class S>
bool NearFaces<S>::is_least(const SegmentSurface<S>& surface, const Candidate& candidate) const {
  if (candidate.at.rim[0] < 0) return true;
  const auto& own = surface.segments()[candidate.segment].node;
  const std::int32_t rim[2] = {own[candidate.at.rim[0]], own[candidate.at.rim[1]]};
  for (const Candidate& other : candidates_) {
    if (other.segment == candidate.segment) continue;
    const auto& node = surface.segments()[other.segment].node;
    const auto has = [&node](std::int32_t n) { return std::find(node, node + 4, n) != node + 4; };
    if (!has(rim[0]) || !has(rim[1])) continue;
    const bool inside = other.at.rim[0] < 0;
    if (inside ? other.at.distance <= (1 + same_distance) * candidate.at.distance
               : other.at.distance < candidate.at.distance ||
                     (other.at.distance == candidate.at.distance && other.segment < candidate.segment)) {
      return false;
    }
  }
  return true;
}

template <class S>
bool NearFaces<S>::is_nearest_of_body(const Candidate& candidate) const {
  return std::none_of(candidates_.begin(), candidates_.end(), [&](const Candidate& other) {
    return other.body == candidate.body &&
           (other.at.distance < candidate.at.distance ||
            (other.at.distance == candidate.at.distance && other.segment < candidate.segment));
  });
}

/// Whether some face around the rim of a candidate comes nearer, also one that is too thin, or too far off, to be a
/// candidate. The side of a rim on which a point lies says nothing then: it may be outside, over that face.
template <class S>
bool NearFaces<S>::is_passed(const SurfaceSource<S>& source, const SegmentSurface<S>& surface,
                             const Candidate& candidate, const Vec3<double>& centre) const {
  for (const int corner : candidate.at.rim) {
    if (corner < 0) return false;
    for (const std::int32_t s : surface.around(surface.slaves_of(candidate.segment)[corner])) {
      if (s == candidate.segment || !surface.active_segment(s)) continue;
      const double distance = nearest_on(source, surface.segments()[s].node, centre).distance;
      if (distance < (1 - same_distance) * candidate.at.distance) return true;
    }
  }
  return false;
}

template <class S>
const std::vector<FaceTouch>& NearFaces<S>::find(const SurfaceSource<S>& source, const SegmentSurface<S>& surface,
                                                 const SphereSurface<S>& spheres, const SphereLists<S>& lists,
                                                 std::int64_t number) {
  collect(source, surface, spheres, lists, number);
  touches_.clear();
  const double radius = spheres.spheres()[number].radius;
  const Vec3<double> centre = double_vector_of(source.x(spheres.spheres()[number].node));
  for (const Candidate& candidate : candidates_) {
    if (!is_least(surface, candidate)) continue;
    const Outward outward = outward_at(source, surface, candidate.segment, candidate.at.rim);
    const double along = dot(candidate.at.away, outward.normal);
    const bool behind = along < 0;
    if (behind && !(outward.closed && is_nearest_of_body(candidate))) continue;
    if (behind && is_passed(source, surface, candidate, centre)) continue;
    FaceTouch touch{};
    touch.segment = candidate.segment;
    std::copy(std::begin(candidate.at.weight), std::end(candidate.at.weight), touch.weight);
    touch.depth = radius + (behind ? candidate.at.distance : -candidate.at.distance);
    if (behind && !(candidate.at.distance < deepest_centre * surface.segments()[candidate.segment].thickness)) {
      continue;
    }
    if (!(touch.depth > 0)) continue;
    const bool on_the_surface = !(candidate.at.distance > same_distance * radius);
    touch.direction = on_the_surface ? outward.normal : ((behind ? -1 : 1) / candidate.at.distance) * candidate.at.away;
    touches_.push_back(touch);
  }
  return touches_;
}

template class NearFaces<double>;
template class NearFaces<float>;

}  // namespace pinball
