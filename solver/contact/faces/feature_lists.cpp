#include "feature_lists.hpp"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

#include <kernels/simd.hpp>

namespace pinball {

namespace {

template <class S>
bool meet(const MovingBox<S>& a, const MovingBox<S>& b) {
  bool all = true;
  for (int k = 0; k < 3; ++k) {
    all = all & ((a.bound[k] <= b.bound[3 + k]) | (a.bound[6 + k] <= b.bound[9 + k])) &
          ((a.bound[3 + k] >= b.bound[k]) | (a.bound[9 + k] >= b.bound[6 + k]));
  }
  return all;
}

/// Whether features of two segments may touch: the mesh keeps elements with a common corner apart.
template <class S>
bool segments_may_touch(const SegmentSurface<S>& surface, std::int32_t a, std::int32_t b) {
  return surface.active_segment(a) && surface.active_segment(b) && !surface.beside(std::span(&a, 1), std::span(&b, 1));
}

/// The segment that an edge belongs to: the first that is active.
template <class S>
std::int32_t owner_of(const SegmentSurface<S>& surface, const EdgeTable<S>& edges, std::int32_t edge) {
  for (const std::int32_t s : edges.segments_of(edge)) {
    if (surface.active_segment(s)) return s;
  }
  return -1;
}

}  // namespace

template <class S>
void FeatureLists<S>::watch_nodes(const SurfaceSource<S>& source, const SegmentSurface<S>& surface,
                                  const SphereSurface<S>& spheres) {
  motion_.clear(source.node_count);
  for (const auto& slave : surface.slaves()) {
    S least = std::numeric_limits<S>::max();
    for (const std::int32_t s : surface.around(&slave - surface.slaves().data())) {
      least = std::min(least, surface.segments()[s].size);
    }
    motion_.watch(slave.node, least);
  }
  for (const auto& sphere : spheres.spheres()) motion_.watch(sphere.node, sphere.radius);
}

/// Where lists are short beside the surface, bounds of all of it are most of a search, and what else comes into longer
/// lists costs little.
template <class S>
S FeatureLists<S>::steps_to_last(const SegmentSurface<S>& surface) const {
  const std::int64_t entries = nodes_.pieces.entries + edges_.pieces.entries;
  const bool is_short = 4 * entries < std::ssize(surface.segments());
  return is_short ? S(1.5) * horizon_steps : S(horizon_steps);
}

template <class S>
void FeatureLists<S>::build(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, const EdgeTable<S>& edges,
                            const SphereSurface<S>& spheres, const ContactSettings& settings,
                            const std::vector<float>& depth, S dt, bool last) {
  const S horizon = last ? steps_to_last(surface) * clock_.last_step() : S(0);
  if (watched_) motion_.adapt(source.position, clock_.elapsed(), horizon);
  if (!valid_) watch_nodes(source, surface, spheres);
  watched_ = true;
  source.before_motion(motion_.nodes());
  motion_.start(source.position, source.velocity, last ? static_cast<S>(settings.skin) : S(0));
  scope_.last_step = std::max(dt, clock_.last_step());
  scope_.horizon = horizon;
  scope_.depth.resize(surface.slaves().size());
  parallel_for("depths", RangePolicy<>{0, std::ssize(scope_.depth)},
               [&](std::int64_t i) { scope_.depth[i] = depth[surface.slaves()[i].node]; });
  clock_.restart(horizon);
  valid_ = true;
  find_pairs(source, surface, edges, spheres, settings);
  find_features(surface, edges);
}

template <class S>
void FeatureLists<S>::find_pairs(const NodeRecords<S>& nodes, const SegmentSurface<S>& surface,
                                 const EdgeTable<S>& edges, const SphereSurface<S>& spheres,
                                 const ContactSettings& settings) {
  bounds_.update(nodes, surface, edges, spheres, motion_, scope_);
  const std::int32_t segments = surface.segments().size();
  const auto body_of = [&](std::int32_t i) {
    return i < segments ? surface.segments()[i].body : spheres.spheres()[i - segments].body;
  };
  const auto allowed = [&](std::int32_t a, std::int32_t b) {
    if (allowed_ == nullptr || b >= segments) return true;
    const auto &own = surface.segments()[a], &other = surface.segments()[b];
    return allowed_->faces_may(own.slot, own.face, own.node, other.slot, other.face, other.node);
  };
  pairs_.find(bounds_.boxes(), settings.search, [&](std::int32_t a, std::int32_t b) {
    if (!allowed(a, b)) return false;
    const bool one_body = body_of(a) == body_of(b);
    if (one_body && b < segments && surface.segments()[b].rigid) return false;
    if (b >= segments) return settings.self || !one_body;
    return (settings.self || !one_body) && bounds_.around(a).may_face(bounds_.around(b));
  });
}

template <class S>
void FeatureLists<S>::find_features(const SegmentSurface<S>& surface, const EdgeTable<S>& edges) {
  const std::int32_t segments = surface.segments().size();
  parallel_for("features", RangePolicy<>{0, fixed_pieces}, [&](std::int64_t piece) {
    nodes_.found()[piece].pairs = 0;
    edges_.found()[piece].pairs = 0;
    found_sphere_segments_[piece].clear();
    found_spheres_[piece].clear();
    const auto firsts = pairs_.firsts(piece), seconds = pairs_.seconds(piece);
    for (std::size_t pair = 0; pair < firsts.size(); ++pair) {
      const std::int32_t a = firsts[pair], b = seconds[pair];
      if (b < segments) {
        if (segments_may_touch(surface, a, b)) find_in_pair(surface, edges, a, b, Take::own, piece);
      } else if (a < segments) {
        found_sphere_segments_[piece].push_back({b - segments, a});
      } else {
        found_spheres_[piece].push_back({a - segments, b - segments});
      }
    }
  });
  nodes_.sort(surface.slaves().size(), native_width<S>, surface.changed());
  fill_node_pairs(surface);
  edges_.sort(edges.edges().size(), native_width<S>, surface.changed());
  fill_edge_pairs(edges);
  join_sphere_pairs();
  was_active_.resize(surface.segments().size());
  parallel_for("active segments", RangePolicy<>{0, segments},
               [&](std::int64_t s) { was_active_[s] = surface.active_segment(s) ? 1 : 0; });
}

template <class S>
void FeatureLists<S>::mark_changed(const SegmentSurface<S>& surface) {
  changed_slave_.resize(surface.slaves().size());
  near_change_.resize(surface.segments().size());
  for (const std::int32_t changed : surface.just_changed()) {
    for (const std::int32_t slave : surface.slaves_of(changed)) {
      if (std::exchange(changed_slave_[slave], std::uint8_t(1)) != 0) continue;
      for (const std::int32_t s : surface.around(slave)) near_change_[s] = 1;
    }
  }
}

template <class S>
void FeatureLists<S>::unmark_changed(const SegmentSurface<S>& surface) {
  for (const std::int32_t changed : surface.just_changed()) {
    for (const std::int32_t slave : surface.slaves_of(changed)) {
      if (std::exchange(changed_slave_[slave], std::uint8_t(0)) == 0) continue;
      for (const std::int32_t s : surface.around(slave)) near_change_[s] = 0;
    }
    was_active_[changed] = surface.active_segment(changed) ? 1 : 0;
  }
}

/// What meets a segment that is new, and whatever a node or an edge of a changed one meets: it may have belonged to one
/// that has ended, or the mesh may have kept it apart.
template <class S>
bool FeatureLists<S>::follow_erosion(const SegmentSurface<S>& surface, const EdgeTable<S>& edges) {
  if (!valid_) return false;
  mark_changed(surface);
  find_more(surface, edges);
  unmark_changed(surface);
  const auto is_empty = [](const PairColumns& found) { return found.pairs == 0; };
  if (std::ranges::all_of(more_nodes_.found(), is_empty) && std::ranges::all_of(more_edges_.found(), is_empty))
    return false;
  more_nodes_.sort(surface.slaves().size(), 1);
  more_edges_.sort(edges.edges().size(), 1);
  take_in_more(surface, edges);
  return true;
}

/// Of the pairs of boxes those of segments around a change are looked at. To find these by an index of both boxes, made
/// once a list, takes as long as to look through all: most lists see a few erosions.
template <class S>
void FeatureLists<S>::find_more(const SegmentSurface<S>& surface, const EdgeTable<S>& edges) {
  const std::int32_t segments = surface.segments().size();
  parallel_for("features after erosion", RangePolicy<>{0, fixed_pieces}, [&](std::int64_t piece) {
    more_nodes_.found()[piece].pairs = 0;
    more_edges_.found()[piece].pairs = 0;
    const auto firsts = pairs_.firsts(piece), seconds = pairs_.seconds(piece);
    for (std::size_t pair = 0; pair < firsts.size(); ++pair) {
      const std::int32_t a = firsts[pair], b = seconds[pair];
      if (b >= segments || (near_change_[a] | near_change_[b]) == 0) continue;
      if (segments_may_touch(surface, a, b)) find_in_pair(surface, edges, a, b, Take::changed, piece);
    }
  });
}

/// Where a list has no room it is made anew, with some.
template <class S>
void FeatureLists<S>::take_in_more(const SegmentSurface<S>& surface, const EdgeTable<S>& edges) {
  const auto make_anew = [](SortedPairs& list, const SortedPairs& more, std::size_t firsts) {
    for (PairColumns& some : list.found()) some.pairs = 0;
    const auto add = [&list](std::int32_t a, std::int32_t b) { list.found()[0].add(a, b); };
    list.for_each(add);
    more.for_each(add);
    list.sort(firsts, native_width<S>, true);
  };
  if (const auto room = nodes_.insert(more_nodes_)) {
    room->make_in(nodes_.node.data());
    room->make_in(nodes_.size.data());
    room->make_in(nodes_.radius.data());
    room->for_each_place([&](std::int64_t place) { fill_node_pair(surface, place); });
  } else {
    make_anew(nodes_, more_nodes_, surface.slaves().size());
    fill_node_pairs(surface);
  }
  if (const auto room = edges_.insert(more_edges_)) {
    for (auto& node : edges_.node) room->make_in(node.data());
    room->make_in(edges_.size.data());
    room->for_each_place([&](std::int64_t place) { fill_edge_pair(edges, place); });
  } else {
    make_anew(edges_, more_edges_, edges.edges().size());
    fill_edge_pairs(edges);
  }
}

/// What the one segment has against the other, and the other way round.
template <class S>
void FeatureLists<S>::find_in_pair(const SegmentSurface<S>& surface, const EdgeTable<S>& edges, std::int32_t a,
                                   std::int32_t b, Take take, std::int64_t piece) {
  const MovingBox<S> box_a = bounds_.boxes().box(a), box_b = bounds_.boxes().box(b);
  find_nodes_in_pair(surface, a, b, box_b, take, piece);
  find_nodes_in_pair(surface, b, a, box_a, take, piece);
  const auto near_edges = [&](std::int32_t own, std::int32_t other, const MovingBox<S>& box) {
    std::array<std::int32_t, 4> near{};
    std::size_t count = 0;
    for (const std::int32_t e : edges.edges_of(own)) {
      if (e < 0 || (take == Take::own && allowed_ == nullptr && owner_of(surface, edges, e) != own)) continue;
      if (bounds_.edge_facing(e).may_face(bounds_.around(other)) && meet(bounds_.edge_box(e), box)) near[count++] = e;
    }
    return std::pair(near, count);
  };
  const auto has_changed = [&](std::int32_t e) {
    const auto& slave = edges.edges()[e].slave;
    return (changed_slave_[slave[0]] & changed_slave_[slave[1]]) != 0;
  };
  const auto [of_a, count_a] = near_edges(a, b, box_b);
  if (count_a == 0) return;
  const auto [of_b, count_b] = near_edges(b, a, box_a);
  for (std::size_t i = 0; i < count_a; ++i) {
    for (std::size_t j = 0; j < count_b; ++j) {
      const std::int32_t e = of_a[i], f = of_b[j];
      if (take == Take::changed && !has_changed(e) && !has_changed(f)) continue;
      if (!bounds_.edge_facing(e).may_face(bounds_.edge_facing(f)) || edges.share_node(e, f)) continue;
      const std::int32_t *const nodes = edges.edges()[e].node, *const others = edges.edges()[f].node;
      if (allowed_ != nullptr && !allowed_->edges(nodes[0], nodes[1], others[0], others[1]).may) continue;
      if (!meet(bounds_.edge_box(e), bounds_.edge_box(f))) continue;
      const std::int32_t low = std::min(e, f), high = std::max(e, f);
      if (take == Take::changed && edges_.has(low, high)) continue;
      (take == Take::own ? edges_.found() : more_edges_.found())[piece].add(low, high);
    }
  }
}

template <class S>
void FeatureLists<S>::find_nodes_in_pair(const SegmentSurface<S>& surface, std::int32_t own, std::int32_t other,
                                         const MovingBox<S>& box, Take take, std::int64_t piece) {
  const std::array<std::int32_t, 4>& slaves = surface.slaves_of(own);
  const std::array<std::int32_t, 8>& corners = surface.segments()[other].corners;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::int32_t slave = slaves[k];
    // Where only some may touch, a node need not be where its owner is: it is taken from all of its segments.
    const bool taken = take == Take::own ? allowed_ != nullptr || surface.slaves()[slave].owner == own
                                         : changed_slave_[slave] != 0 || was_active_[other] == 0;
    if (!taken) continue;
    const auto& segment = surface.segments()[other];
    if (allowed_ != nullptr &&
        !allowed_->node_and_face(surface.slaves()[slave].node, segment.slot, segment.face, segment.node).may) {
      continue;
    }
    if (!meet(bounds_.node_box(slave), box)) continue;
    if (!bounds_.node_facing(slave).may_face(bounds_.facing(other))) continue;
    if (std::find(slaves.begin(), slaves.begin() + k, slave) != slaves.begin() + k) continue;  // of a triangle
    if (std::find(corners.begin(), corners.end(), surface.slaves()[slave].node) != corners.end()) continue;
    if (take == Take::changed && nodes_.has(slave, other)) continue;
    (take == Take::own ? nodes_.found() : more_nodes_.found())[piece].add(slave, other);
  }
}

template <class S>
void FeatureLists<S>::fill_node_pairs(const SegmentSurface<S>& surface) {
  nodes_.node.renew(nodes_.first.size());
  nodes_.size.renew(nodes_.first.size());
  nodes_.radius.renew(nodes_.first.size());
  parallel_for("listed nodes", RangePolicy<>{0, nodes_.pieces.places},
               [&](std::int64_t place) { fill_node_pair(surface, place); });
}

template <class S>
void FeatureLists<S>::fill_node_pair(const SegmentSurface<S>& surface, std::int64_t place) {
  const auto& segment = surface.segments()[nodes_.second[place]];
  nodes_.node[place] = surface.slaves()[nodes_.first[place]].node;
  nodes_.size[place] = segment.size;
  nodes_.radius[place] = segment.radius;
}

template <class S>
void FeatureLists<S>::fill_edge_pairs(const EdgeTable<S>& edges) {
  for (auto& node : edges_.node) node.renew(edges_.first.size());
  edges_.size.renew(edges_.first.size());
  parallel_for("listed edges", RangePolicy<>{0, edges_.pieces.places},
               [&](std::int64_t place) { fill_edge_pair(edges, place); });
}

template <class S>
void FeatureLists<S>::fill_edge_pair(const EdgeTable<S>& edges, std::int64_t place) {
  const std::int32_t e = edges_.first[place], f = edges_.second[place];
  for (std::size_t end = 0; end < 2; ++end) {
    edges_.node[end][place] = edges.edges()[e].node[end];
    edges_.node[2 + end][place] = edges.edges()[f].node[end];
  }
  edges_.size[place] = bounds_.edge_size(e) + bounds_.edge_size(f);
}

template <class S>
void FeatureLists<S>::join_sphere_pairs() {
  for (auto* list : {&spheres_.with_segments, &spheres_.with_spheres}) list->clear();
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
  archive(valid_, watched_, scope_.last_step, scope_.horizon, scope_.depth, was_active_, spheres_.with_segments,
          spheres_.with_spheres);
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
  find_pairs(nodes, surface, edges, spheres, settings);
  fill_node_pairs(surface);
  fill_edge_pairs(edges);
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
                    nodes_.node.bytes() + nodes_.size.bytes() + nodes_.radius.bytes() + edges_.bytes() +
                    4 * edges_.node[0].bytes() + edges_.size.bytes() + of(spheres_.with_segments) +
                    of(spheres_.with_spheres) + of(was_active_) + of(changed_slave_) + of(near_change_) +
                    more_nodes_.bytes() + more_edges_.bytes();
  for (const auto* found : {&found_sphere_segments_, &found_spheres_}) {
    for (const std::vector<Pair>& pairs : *found) sum += of(pairs);
  }
  return sum;
}

template class FeatureLists<double>;
template class FeatureLists<float>;

}  // namespace pinball
