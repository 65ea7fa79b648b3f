#include "sphere_lists.hpp"

#include <algorithm>
#include <array>

#include <kernels/exec.hpp>

namespace pinball {

namespace {

/// Where a node may be, with what lies within a distance of it.
template <class S>
MovingBox<S> box_of(const NodeRecords<S>& nodes, std::int32_t node, S horizon, S within) {
  MovingBox<S> box;
  for (int k = 0; k < 3; ++k) {
    const S begin = nodes.x(node)[k], end = begin + horizon * nodes.v(node)[k];
    box.bound[k] = begin - within;
    box.bound[3 + k] = begin + within;
    box.bound[6 + k] = end - within;
    box.bound[9 + k] = end + within;
  }
  return box;
}

template <class S>
void take(MovingBox<S>& box, const MovingBox<S>& other) {
  for (int k = 0; k < 12; ++k) {
    box.bound[k] = k % 6 < 3 ? minimum(box.bound[k], other.bound[k]) : maximum(box.bound[k], other.bound[k]);
  }
}

/// Whether boxes are on the same side of each other at the beginning and at the end.
template <class S>
bool are_apart(const MovingBox<S>& a, const MovingBox<S>& b) {
  for (int k = 0; k < 3; ++k) {
    if (a.bound[k] > b.bound[3 + k] && a.bound[6 + k] > b.bound[9 + k]) return true;
    if (a.bound[3 + k] < b.bound[k] && a.bound[9 + k] < b.bound[6 + k]) return true;
  }
  return false;
}

}  // namespace

template <class S>
void SphereLists<S>::set_boxes(const SurfaceSource<S>& source, const SegmentSurface<S>& surface,
                               const SphereSurface<S>& spheres, const SurfaceMotion<S>& motion, S horizon) {
  const std::int32_t segments = surface.segments().size();
  boxes_.reset(segments + spheres.count());
  MovingBox<S> all = empty_box<S>();
  for (std::int32_t i = 0; i < spheres.count(); ++i) {
    const auto& sphere = spheres.spheres()[i];
    const S within = S(1.01) * sphere.radius + motion.allowance(std::array{sphere.node});
    const MovingBox<S> box = box_of(source, sphere.node, horizon, within);
    take(all, box);
    boxes_.set(segments + i, box);
  }
  parallel_for("boxes of segments", RangePolicy<>{0, segments}, [&](std::int64_t i) {
    const auto& segment = surface.segments()[i];
    MovingBox<S> box = empty_box<S>();
    for (const std::int32_t node : segment.node) {
      const S within = static_cast<S>(deepest_centre) * segment.thickness + motion.allowance(std::array{node});
      take(box, box_of(source, node, horizon, within));
    }
    boxes_.set(i, are_apart(box, all) ? empty_box<S>() : box);
  });
}

template <class S>
void SphereLists<S>::build(const SurfaceSource<S>& source, const SegmentSurface<S>& surface,
                           const SphereSurface<S>& spheres, const SurfaceMotion<S>& motion,
                           const ContactSettings& settings, const JoinedBodies& joined, S horizon) {
  set_boxes(source, surface, spheres, motion, horizon);
  const std::int32_t segments = surface.segments().size();
  // As for pinballs: what belongs to one body, or to joined ones, may touch where it was apart in the undeformed mesh.
  const auto may_touch = [&](std::int32_t a, std::int32_t b) {
    if (a >= segments || b < segments) return false;
    const auto& segment = surface.segments()[a];
    const auto& sphere = spheres.spheres()[b - segments];
    const auto& corners = segment.corners;
    if (std::find(corners.begin(), corners.end(), sphere.node) != corners.end()) return false;
    if (!joined.are_one(segment.body, sphere.body)) return true;
    if (segment.body == sphere.body && !settings.self) return false;
    const Point c = source.element(segment.slot).centre(), s = source.element(sphere.slot).centre();
    const double reach =
        settings.radius_factor * static_cast<double>(segment.radius) + static_cast<double>(sphere.radius);
    const Point d{c[0] - s[0], c[1] - s[1], c[2] - s[2]};
    return d[0] * d[0] + d[1] * d[1] + d[2] * d[2] > reach * reach;
  };
  pairs_.find(boxes_, settings.search, may_touch);
  sort(segments, spheres.count());
}

/// Pairs come by their segments, ascending, and are counted and filled in by their spheres.
template <class S>
void SphereLists<S>::sort(std::int32_t segments, std::int32_t spheres) {
  first_.assign(spheres + 1, 0);
  segment_.resize(pairs_.pairs());
  for (std::int64_t piece = 0; piece < fixed_pieces; ++piece) {
    for (const std::int32_t sphere : pairs_.seconds(piece)) ++first_[sphere - segments + 1];
  }
  for (std::size_t s = 0; s + 1 < first_.size(); ++s) first_[s + 1] += first_[s];
  std::vector<std::int64_t> next(first_.begin(), first_.end() - 1);
  for (std::int64_t piece = 0; piece < fixed_pieces; ++piece) {
    const auto firsts = pairs_.firsts(piece), seconds = pairs_.seconds(piece);
    for (std::size_t i = 0; i < firsts.size(); ++i) {
      segment_[next[seconds[i] - segments]++] = firsts[i];
    }
  }
}

template <class S>
std::size_t SphereLists<S>::bytes() const {
  return first_.capacity() * sizeof(first_[0]) + segment_.capacity() * sizeof(segment_[0]) + boxes_.bytes() +
         pairs_.bytes();
}

template class SphereLists<double>;
template class SphereLists<float>;

}  // namespace pinball
