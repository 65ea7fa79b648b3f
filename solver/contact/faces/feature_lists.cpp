#include "feature_lists.hpp"

#include <algorithm>
#include <limits>

#include <kernels/simd.hpp>

namespace pinball {

namespace {

/// Whether features of two segments may touch: the mesh keeps elements with a common corner apart.
template <class S>
bool segments_may_touch(const SegmentSurface<S>& surface, std::int32_t a, std::int32_t b) {
  return surface.active_segment(a) && surface.active_segment(b) && !surface.beside(a, b);
}

/// All that is found in a new list.
struct Everything {
  static unsigned features(std::int32_t /*own*/, std::int32_t /*other*/) { return ~0U; }
  static bool node(std::int32_t /*slave*/, std::int32_t /*segment*/) { return true; }
  static bool edges(std::int32_t /*low*/, std::int32_t /*high*/) { return true; }
};

}  // namespace

template <class S>
void FeatureLists<S>::watch_nodes(const SurfaceSource<S>& source, const SegmentSurface<S>& surface,
                                  const SphereSurface<S>& spheres) {
  const std::int64_t slaves = std::ssize(surface.slaves());
  const auto node_of = [&](std::int64_t i) {
    return i < slaves ? surface.slaves()[i].node : spheres.spheres()[i - slaves].node;
  };
  motion_.watch(source.node_count, slaves + spheres.count(), node_of, [&](std::int64_t i) {
    if (i >= slaves) return spheres.spheres()[i - slaves].radius;
    S least = std::numeric_limits<S>::max();
    for (const std::int32_t s : surface.around(i)) least = std::min(least, surface.segments()[s].size);
    return least;
  });
}

/// Where lists are short beside the surface, bounds of all of it are most of a search, and what else comes into longer
/// lists costs little.
template <class S>
S FeatureLists<S>::steps_to_last(const SegmentSurface<S>& surface) const {
  const std::int64_t entries = nodes_.pieces.entries + edges_.pieces.entries;
  const bool is_short = 4 * entries < std::ssize(surface.segments());
  return is_short ? S(2) * horizon_steps : S(horizon_steps);
}

template <class S>
void FeatureLists<S>::build(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, const EdgeTable<S>& edges,
                            const SphereSurface<S>& spheres, const ContactSettings& settings,
                            const std::vector<float>& depth, S dt, S leap, bool last) {
  const S horizon = last ? steps_to_last(surface) * clock_.last_step() : S(0);
  if (watched_) motion_.adapt(source.position, clock_.elapsed(), horizon);
  if (!valid_) {
    bounds_.renumber();
    watch_nodes(source, surface, spheres);
  }
  watched_ = true;
  source.before_motion(motion_.nodes());
  motion_.start(source.position, source.velocity, last ? static_cast<S>(settings.skin) : S(0));
  scope_.last_step = std::max(dt, clock_.last_step());
  scope_.leap = leap;
  scope_.horizon = horizon;
  scope_.depth.resize(surface.slaves().size());
  parallel_for("depths", RangePolicy<>{0, std::ssize(scope_.depth)},
               [&](std::int64_t i) { scope_.depth[i] = depth[surface.slaves()[i].node]; });
  clock_.restart(horizon);
  valid_ = true;
  const PieceShare share(source.sharers, fixed_pieces, std::ssize(surface.segments()) + spheres.count());
  find_pairs(source, surface, spheres, settings, share);
  find_features(surface, edges, share);
}

template <class S>
bool FeatureLists<S>::may_touch(const SegmentSurface<S>& surface, const SphereSurface<S>& spheres, bool self,
                                std::int32_t a, std::int32_t b) const {
  const std::int32_t segments = surface.segments().size();
  if (b >= segments) {
    const auto body_of = [&](std::int32_t i) {
      return i < segments ? surface.segments()[i].body : spheres.spheres()[i - segments].body;
    };
    if (a < segments) {
      const auto& corners = surface.segments()[a].corners;  // a sphere may be at a node of an element
      const std::int32_t node = spheres.spheres()[b - segments].node;
      if (std::find(corners.begin(), corners.end(), node) != corners.end()) return false;
    }
    return self || body_of(a) != body_of(b);
  }
  const auto &own = surface.segments()[a], &other = surface.segments()[b];
  if (own.body == other.body && (!self || other.rigid)) return false;
  if (!segments_may_touch(surface, a, b)) return false;
  return allowed_ == nullptr || allowed_->faces_may(own.slot, own.face, own.node, other.slot, other.face, other.node);
}

template <class S>
void FeatureLists<S>::find_pairs(const NodeRecords<S>& nodes, const SegmentSurface<S>& surface,
                                 const SphereSurface<S>& spheres, const ContactSettings& settings,
                                 const PieceShare& share) {
  bounds_.update(nodes, surface, spheres, motion_, scope_);
  const std::int32_t segments = surface.segments().size();
  const auto number_of = [&](std::int32_t box) { return box < segments ? bounds_.segment_of(box) : box; };
  const auto keep = [&](std::int32_t a, std::int32_t b) {
    return may_touch(surface, spheres, settings.self, number_of(a), number_of(b));
  };
  pairs_.find(bounds_.boxes(), settings.search, keep, &bounds_.directions(), share);
  self_ = settings.self;
  skin_ = static_cast<S>(settings.skin);
  features_.clear(segments);
}

template <class S>
void FeatureLists<S>::find_features(const SegmentSurface<S>& surface, const EdgeTable<S>& edges,
                                    const PieceShare& share) {
  const std::int32_t segments = surface.segments().size();
  parallel_for("segments that meet", RangePolicy<>{0, fixed_pieces}, [&](std::int64_t piece) {
    const auto firsts = pairs_.firsts(piece), seconds = pairs_.seconds(piece);
    for (std::size_t pair = 0; pair < firsts.size(); ++pair) {
      if (seconds[pair] >= segments) continue;
      features_.ask_for(bounds_.segment_of(firsts[pair]));
      features_.ask_for(bounds_.segment_of(seconds[pair]));
    }
  });
  // Where only some may touch, a node need not be where its owner is: it is taken from all of its segments.
  features_.collect(bounds_, surface, edges, which_features());
  const FeatureScope<S> scope{surface, edges, bounds_, features_, allowed_};
  parallel_for("features", RangePolicy<>{0, fixed_pieces}, [&](std::int64_t piece) {
    PairColumns &nodes = nodes_.found()[piece], &crossing = edges_.found()[piece];
    nodes.pairs = 0;
    crossing.pairs = 0;
    found_sphere_segments_[piece].clear();
    found_spheres_[piece].clear();
    const auto firsts = pairs_.firsts(piece), seconds = pairs_.seconds(piece);
    for (std::size_t pair = 0; pair < firsts.size(); ++pair) {
      const std::int32_t a = firsts[pair], b = seconds[pair];
      if (b < segments) {
        add_features_of_pair(scope, bounds_.segment_of(a), bounds_.segment_of(b), Everything{}, nodes, crossing);
      } else if (a < segments) {
        found_sphere_segments_[piece].push_back({b - segments, bounds_.segment_of(a)});
      } else {
        found_spheres_[piece].push_back({a - segments, b - segments});
      }
    }
  });
  FoundFeatures{nodes_.found(), edges_.found(), found_sphere_segments_, found_spheres_}.add_from_others(share);
  nodes_.sort(surface.slaves().size(), native_width<S>, true);
  nodes_.fill(surface);
  edges_.sort(edges.edges().size(), native_width<S>, true);
  edges_.fill(surface, edges);
  edges_.find_flat(surface, edges, bounds_);
  join_sphere_pairs();
  was_active_.resize(surface.segments().size());
  parallel_for("active segments", RangePolicy<>{0, segments},
               [&](std::int64_t s) { was_active_[s] = surface.active_segment(s) ? 1 : 0; });
}

template <class S>
void FeatureLists<S>::join_sphere_pairs() {
  const auto join = [](const auto& found, std::vector<Pair>& list) {
    list.clear();
    for (const std::vector<Pair>& some : found) list.insert(list.end(), some.begin(), some.end());
    std::sort(list.begin(), list.end());
  };
  join(found_sphere_segments_, spheres_.with_segments);
  join(found_spheres_, spheres_.with_spheres);
}

/// Pairs of boxes are found again from where all was when they were found: erosions to come need them.
template <class S>
void FeatureLists<S>::persist(StateArchive& archive, const SegmentSurface<S>& surface, const EdgeTable<S>& edges,
                              const SphereSurface<S>& spheres, const ContactSettings& settings,
                              std::int32_t node_count) {
  archive(valid_, watched_, scope_.last_step, scope_.leap, scope_.horizon, scope_.depth, was_active_,
          spheres_.with_segments, spheres_.with_spheres);
  nodes_.persist(archive);
  edges_.persist(archive);
  clock_.persist(archive);
  motion_.persist(archive, node_count, valid_ || watched_);
  if (!archive.reads() || !valid_) return;
  check(archive, surface, edges, spheres);
  Array<S> position, velocity;
  motion_.put_start(position, velocity);
  NodeRecords<S> nodes;
  nodes.position = position.data();
  nodes.velocity = velocity.data();
  bounds_.renumber();
  find_pairs(nodes, surface, spheres, settings, PieceShare());
  nodes_.fill(surface);
  edges_.fill(surface, edges);
}

/// Of lists that were read, and hold: that they are of this surface.
template <class S>
void FeatureLists<S>::check(const StateArchive& archive, const SegmentSurface<S>& surface, const EdgeTable<S>& edges,
                            const SphereSurface<S>& spheres) const {
  const std::size_t segments = surface.segments().size(), slaves = surface.slaves().size();
  archive.require(scope_.depth.size() == slaves && was_active_.size() == segments);
  nodes_.check(archive, slaves, segments, native_width<S>);
  edges_.check(archive, edges.edges().size(), edges.edges().size(), native_width<S>);
  const auto check_spheres = [&](const std::vector<Pair>& pairs, std::size_t seconds) {
    for (const Pair& pair : pairs) {
      archive.require_all(std::array{pair[0]}, 0, spheres.spheres().size());
      archive.require_all(std::array{pair[1]}, 0, seconds);
    }
  };
  check_spheres(spheres_.with_segments, segments);
  check_spheres(spheres_.with_spheres, spheres.spheres().size());
}

template <class S>
std::size_t FeatureLists<S>::bytes() const {
  const auto of = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
  std::size_t sum = motion_.bytes() + bounds_.bytes() + pairs_.bytes() + of(scope_.depth) + nodes_.bytes() +
                    edges_.bytes() + of(spheres_.with_segments) + of(spheres_.with_spheres) + of(was_active_) +
                    of(changed_slave_) + of(near_change_) + of(changed_features_) + of(looking_segments_) +
                    more_nodes_.bytes() + more_edges_.bytes() + features_.bytes() + of(near_segments_) +
                    of(changed_slaves_) + of(strayed_);
  for (const PairColumns& pairs : near_pairs_) sum += pairs.bytes();
  for (const auto& groups : near_groups_) sum += of(groups);
  for (const auto* found : {&found_sphere_segments_, &found_spheres_}) {
    for (const std::vector<Pair>& pairs : *found) sum += of(pairs);
  }
  return sum;
}

template class FeatureLists<double>;
template class FeatureLists<float>;

}  // namespace pinball
