#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <solver/base/lists_in_order.hpp>

#include "feature_lists.hpp"

/// What lists take in while they last: what erosion exposes, and what nodes meet that have strayed.
namespace pinball {

namespace {

/// What is looked at of a segment that has changed: its corners, their boxes, and its edges.
constexpr std::int64_t numbers_of_segment = 64;

}  // namespace

template <class S>
void FeatureLists<S>::mark_changed(const SegmentSurface<S>& surface) {
  changed_slave_.resize(surface.slaves().size());
  near_change_.resize(surface.segments().size());
  changed_features_.resize(surface.segments().size());
  near_segments_.clear();
  for (const std::int32_t slave : changed_slaves_) changed_slave_[slave] = is_changed;
  for (const std::int32_t slave : changed_slaves_) {
    for (const std::int32_t s : surface.around(slave)) {
      if (near_change_[s] != 0) continue;
      near_change_[s] = is_changed;
      near_segments_.push_back(s);
    }
  }
}

template <class S>
void FeatureLists<S>::unmark_changed(const SegmentSurface<S>& surface) {
  for (const std::int32_t slave : changed_slaves_) changed_slave_[slave] = 0;
  for (const std::int32_t s : near_segments_) {
    near_change_[s] = changed_features_[s] = 0;
    was_active_[s] = surface.active_segment(s) ? 1 : 0;
  }
}

/// What meets a segment that is new, and whatever a node or an edge of a changed one meets: it may have belonged to one
/// that has ended, or the mesh may have kept it apart.
template <class S>
bool FeatureLists<S>::follow_erosion(const SegmentSurface<S>& surface, const EdgeTable<S>& edges,
                                     const SphereSurface<S>& spheres) {
  if (!valid_) return false;
  changed_slaves_.clear();
  for (const std::int32_t changed : surface.just_changed()) {
    const auto& slaves = surface.slaves_of(changed);
    changed_slaves_.insert(changed_slaves_.end(), slaves.begin(), slaves.end());
  }
  const std::int64_t before = entries();
  edges_.forget_flat();
  mark_changed(surface);
  take_in_more(surface, edges, spheres);
  return entries() > before;
}

/// Where a segment with such a node looks may have changed, too, and so what its other nodes and all of its edges may
/// meet.
template <class S>
bool FeatureLists<S>::follow_strays(const SurfaceSource<S>& source, const SegmentSurface<S>& surface,
                                    const EdgeTable<S>& edges, const SphereSurface<S>& spheres,
                                    const std::vector<float>& depth) {
  constexpr std::int64_t part = 16;  // of the nodes: where more have strayed a search takes less
  if (!valid_ || clock_.over() || spheres.count() != 0) return false;
  motion_.find_strayed(source.position, clock_.elapsed(), strayed_);  // slaves are watched in their order
  if (part * std::ssize(strayed_) > std::ssize(surface.slaves())) return false;
  std::vector<std::int32_t> nodes;
  for (const std::int32_t slave : strayed_) {
    nodes.push_back(surface.slaves()[slave].node);
    const S* const x = source.x(nodes.back());
    if (!std::isfinite(x[0] + x[1] + x[2])) return false;
    scope_.depth[slave] = std::max(scope_.depth[slave], depth[nodes.back()]);
  }
  source.before_motion(nodes);
  motion_.restart(strayed_, source.position, source.velocity, skin_, clock_.elapsed(),
                  scope_.horizon - clock_.elapsed());
  bounds_.move(surface, strayed_, scope_);
  edges_.forget_flat();
  changed_slaves_ = strayed_;
  for (const std::int32_t slave : strayed_) {
    for (const std::int32_t s : surface.around(slave)) {
      if (!bounds_.turn(surface, s)) continue;
      changed_slaves_.insert(changed_slaves_.end(), surface.slaves_of(s).begin(), surface.slaves_of(s).end());
    }
  }
  mark_changed(surface);
  for (const std::int32_t slave : strayed_) {
    changed_slave_[slave] = has_strayed;
    for (const std::int32_t s : surface.around(slave)) near_change_[s] = has_strayed;
  }
  take_in_more(surface, edges, spheres);
  return true;
}

/// Edges of a segment that looks elsewhere or has eroded have changed at both ends.
template <class S>
std::uint8_t FeatureLists<S>::changed_features_of(const SegmentSurface<S>& surface, const EdgeTable<S>& edges,
                                                  std::int32_t segment) const {
  // Where the segment has changed itself all that it has is looked at anyway.
  const bool owned = which_features() == FeaturesOf::owner && !has_changed(segment);
  unsigned bits = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::int32_t slave = surface.slaves_of(segment)[k], edge = edges.edges_of(segment)[k];
    if (changed_slave_[slave] != 0 && (!owned || surface.slaves()[slave].owner == segment)) bits |= 1U << k;
    if (edge < 0) continue;
    const auto& ends = edges.edges()[edge].slave;
    const std::uint8_t a = changed_slave_[ends[0]], b = changed_slave_[ends[1]];
    const bool has_changed = (a != 0 && b != 0) || std::max(a, b) == has_strayed;
    if (has_changed && (!owned || owner_of(surface, edges, edge) == segment)) {
      bits |= 1U << (SegmentFeatures<S>::first_edge + k);
    }
  }
  return static_cast<std::uint8_t>(bits);
}

/// Those around a node have much the same near them: what is far from all of them is looked at once.
template <class S>
void FeatureLists<S>::find_near_pairs(const SegmentSurface<S>& surface, const SphereSurface<S>& spheres) {
  constexpr std::int64_t most_together = 4;
  const std::int32_t segments = surface.segments().size();
  const std::int64_t looking = std::ssize(looking_segments_), runs = (looking + most_together - 1) / most_together;
  parallel_for("segments near changes", RangePolicy<>{0, fixed_pieces}, [&](std::int64_t piece) {
    PairColumns& found = near_pairs_[piece];
    found.pairs = 0;
    found_sphere_segments_[piece].clear();
    for (std::int64_t run = runs * piece / fixed_pieces; run < runs * (piece + 1) / fixed_pieces; ++run) {
      const std::int64_t first = run * most_together, count = std::min(most_together, looking - first);
      MovingBox<S> boxes[most_together];
      for (std::int64_t i = 0; i < count; ++i) boxes[i] = bounds_.segment_box(looking_segments_[first + i]);
      std::vector<std::int32_t>& groups = near_groups_[piece];
      pairs_.find_groups(std::span(boxes, count), groups);
      for (std::int64_t i = 0; i < count; ++i) {
        const std::int32_t own = looking_segments_[first + i];
        const auto look_at = [&](std::int32_t box) {
          if (box >= segments) {
            const bool is_new = was_active_[own] == 0 && may_touch(surface, spheres, self_, own, box);
            if (is_new) found_sphere_segments_[piece].push_back({box - segments, own});
            return;
          }
          const std::int32_t other = bounds_.segment_of(box);
          const bool again = other <= own && looks_anew(other);
          if (!again && may_touch(surface, spheres, self_, own, other)) found.add(own, other);
        };
        for (const std::int32_t group : groups) pairs_.for_each_meeting(group, boxes[i], look_at);
      }
    }
  });
}

/// Boxes of segments around a change are made anew, and pairs with these found anew.
template <class S>
void FeatureLists<S>::take_in_more(const SegmentSurface<S>& surface, const EdgeTable<S>& edges,
                                   const SphereSurface<S>& spheres) {
  pairs_.prepare_to_look_up(bounds_.boxes());
  looking_segments_.clear();
  const std::int64_t near = std::ssize(near_segments_);
  for_all_of("changed segments", near, near * numbers_of_segment, [&](std::int64_t i) {
    const std::int32_t s = near_segments_[i];
    if (!surface.active_segment(s)) return;
    features_.forget(s);
    bounds_.renew_box(surface, s);
    changed_features_[s] = changed_features_of(surface, edges, s);
  });
  for (const std::int32_t s : near_segments_) {
    if (!surface.active_segment(s)) continue;
    pairs_.include(bounds_.segment_box(s), bounds_.box_of_segment(s));
    if (looks_anew(s)) looking_segments_.push_back(s);
  }
  find_near_pairs(surface, spheres);
  features_.collect_those_of(near_pairs_, bounds_, surface, edges, which_features());
  const FeatureScope<S> scope{surface, edges, bounds_, features_, allowed_};
  const Changed changed{*this};
  parallel_for("features near changes", RangePolicy<>{0, fixed_pieces}, [&](std::int64_t piece) {
    PairColumns &nodes = more_nodes_.found()[piece], &crossing = more_edges_.found()[piece];
    nodes.pairs = 0;
    crossing.pairs = 0;
    const PairColumns& pairs = near_pairs_[piece];
    for (std::size_t pair = 0; pair < pairs.pairs; ++pair) {
      add_features_of_pair(scope, pairs.first[pair], pairs.second[pair], changed, nodes, crossing);
    }
  });
  more_nodes_.sort_few();
  more_edges_.sort_few();
  nodes_.take_in(more_nodes_, surface);
  edges_.take_in(more_edges_, surface, edges);
  std::vector<Pair>& with_spheres = spheres_.with_segments;
  for (const auto& some : found_sphere_segments_) with_spheres.insert(with_spheres.end(), some.begin(), some.end());
  std::sort(with_spheres.begin(), with_spheres.end());
  unmark_changed(surface);
}

#define PINBALL_INSTANTIATE(S)                                                                                         \
  template bool FeatureLists<S>::follow_erosion(const SegmentSurface<S>&, const EdgeTable<S>&,                         \
                                                const SphereSurface<S>&);                                              \
  template bool FeatureLists<S>::follow_strays(const SurfaceSource<S>&, const SegmentSurface<S>&, const EdgeTable<S>&, \
                                               const SphereSurface<S>&, const std::vector<float>&);
PINBALL_INSTANTIATE(double)
PINBALL_INSTANTIATE(float)
#undef PINBALL_INSTANTIATE

}  // namespace pinball
