#include "feature_lists.hpp"

#include <algorithm>
#include <limits>
#include <span>

#include <kernels/simd.hpp>

#include "feature_row.hpp"

namespace pinball {

namespace {

static_assert(near_gap > open_gap && 2 * near_gap >= deepest_edges);

template <class S>
bool meet(const MovingBox<S>& a, const MovingBox<S>& b) {
  bool all = true;
  for (int k = 0; k < 3; ++k) {
    all = all & ((a.bound[k] <= b.bound[3 + k]) | (a.bound[6 + k] <= b.bound[9 + k])) &
          ((a.bound[3 + k] >= b.bound[k]) | (a.bound[9 + k] >= b.bound[6 + k]));
  }
  return all;
}

template <class S>
void take(MovingBox<S>& box, const MovingBox<S>& other) {
  for (int k = 0; k < 12; ++k) {
    box.bound[k] = k % 6 < 3 ? minimum(box.bound[k], other.bound[k]) : maximum(box.bound[k], other.bound[k]);
  }
}

template <class S>
void widen(MovingBox<S>& box, S by) {
  for (int k = 0; k < 12; ++k) box.bound[k] += k % 6 < 3 ? -by : by;
}

}  // namespace

template <class S>
void FeatureLists<S>::watch_nodes(const SurfaceSource<S>& source, const SegmentSurface<S>& surface,
                                  const SphereSurface<S>& spheres) {
  motion_.clear(source.node_count);
  for (const auto& slave : surface.slaves()) {
    S least = std::numeric_limits<S>::max();
    for (const std::int32_t s : surface.around(static_cast<std::size_t>(&slave - surface.slaves().data()))) {
      least = std::min(least, surface.segments()[s].size);
    }
    motion_.watch(slave.node, least);
  }
  for (const auto& sphere : spheres.spheres()) motion_.watch(sphere.node, sphere.radius);
}

template <class S>
MovingBox<S> FeatureLists<S>::box_of(const SurfaceSource<S>& source, std::int32_t node) const {
  const S* x = source.x(node);
  const S* v = source.v(node);
  const S stray = motion_.allowance(std::array{node});
  MovingBox<S> box;
  for (int k = 0; k < 3; ++k) {
    const S begin = x[k] - last_step_ * v[k], end = x[k] + box_horizon_ * v[k];
    box.bound[k] = begin - stray;
    box.bound[3 + k] = begin + stray;
    box.bound[6 + k] = end - stray;
    box.bound[9 + k] = end + stray;
  }
  return box;
}

template <class S>
void FeatureLists<S>::box_features(const SurfaceSource<S>& source, const SegmentSurface<S>& surface,
                                   const EdgeTable<S>& edges, const SphereSurface<S>& spheres,
                                   const std::vector<float>& depth) {
  const auto segments = static_cast<std::int32_t>(surface.segments().size());
  node_box_.resize(surface.slaves().size());
  edge_box_.resize(edges.edges().size());
  facing_.resize(surface.segments().size());
  boxes_.reset(segments + spheres.count());
  const auto range = [](std::size_t count) { return RangePolicy<>{0, static_cast<std::int64_t>(count)}; };
  parallel_for("boxes of nodes", range(node_box_.size()), [&](std::int64_t i) {
    const std::int32_t node = surface.slaves()[i].node;
    node_box_[i] = box_of(source, node);
    widen(node_box_[i], static_cast<S>(depth[node]));
  });
  parallel_for("boxes of segments", range(surface.segments().size()), [&](std::int64_t i) {
    const auto& segment = surface.segments()[i];
    MovingBox<S> box = empty_box<S>();
    for (const std::int32_t slave : surface.slaves_of(static_cast<std::int32_t>(i))) take(box, node_box_[slave]);
    facing_[i] = facing_of(source, segment.node);
    widen(box, static_cast<S>(near_gap) * segment.size);
    boxes_.set(static_cast<std::int32_t>(i), box);
  });
  parallel_for("boxes of edges", range(edge_box_.size()), [&](std::int64_t e) {
    const auto& edge = edges.edges()[e];
    MovingBox<S> box = node_box_[edge.slave[0]];
    take(box, node_box_[edge.slave[1]]);
    S size = 0;
    for (const std::int32_t s : edges.segments_of(static_cast<std::int32_t>(e))) {
      size = std::max(size, surface.segments()[s].size);
    }
    widen(box, static_cast<S>(near_gap) * size);
    edge_box_[e] = box;
  });
  parallel_for("boxes of spheres", range(spheres.spheres().size()), [&](std::int64_t i) {
    const auto& sphere = spheres.spheres()[i];
    MovingBox<S> box = box_of(source, sphere.node);
    widen(box, S(1.01) * sphere.radius);
    boxes_.set(segments + static_cast<std::int32_t>(i), box);
  });
}

template <class S>
void FeatureLists<S>::build(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, const EdgeTable<S>& edges,
                            const SphereSurface<S>& spheres, const ContactSettings& settings,
                            const std::vector<float>& depth, S dt, bool last) {
  const S horizon = last ? horizon_steps * clock_.last_step() : S(0);
  if (watched_) motion_.adapt(source.position, clock_.elapsed(), horizon);
  if (!valid_) watch_nodes(source, surface, spheres);
  watched_ = true;
  motion_.start(source.position, source.velocity, last ? static_cast<S>(settings.skin) : S(0));
  // What has closed within the step just made is found, and what closes within the step after the horizon.
  last_step_ = std::max(dt, clock_.last_step());
  box_horizon_ = horizon + 2 * last_step_;
  clock_.restart(horizon);
  valid_ = true;
  box_features(source, surface, edges, spheres, depth);
  find(surface, edges, spheres, settings);
}

template <class S>
void FeatureLists<S>::find(const SegmentSurface<S>& surface, const EdgeTable<S>& edges, const SphereSurface<S>& spheres,
                           const ContactSettings& settings) {
  const auto segments = static_cast<std::int32_t>(surface.segments().size());
  const auto body_of = [&](std::int32_t i) {
    return i < segments ? surface.segments()[i].body : spheres.spheres()[i - segments].body;
  };
  find_facings(surface, edges);
  pairs_.find(boxes_, settings.search, [&](std::int32_t a, std::int32_t b) {
    const bool one_body = body_of(a) == body_of(b);
    if (b >= segments) return settings.self || !one_body;
    return (settings.self || !one_body) && may_face(around_[a], around_[b]);
  });
  parallel_for("features", RangePolicy<>{0, fixed_pieces}, [&](std::int64_t piece) {
    Found& found = found_[piece];
    for (auto* list : {&found.nodes, &found.edges, &found.sphere_segments, &found.spheres}) list->clear();
    const auto firsts = pairs_.firsts(piece), seconds = pairs_.seconds(piece);
    for (std::size_t pair = 0; pair < firsts.size(); ++pair) {
      const std::int32_t a = firsts[pair], b = seconds[pair];
      if (b < segments) {
        find_in_pair(surface, edges, a, b, found);
      } else if (a < segments) {
        found.sphere_segments.push_back({b - segments, a});
      } else {
        found.spheres.push_back({a - segments, b - segments});
      }
    }
  });
  sort_pairs(&Found::nodes, static_cast<std::int64_t>(surface.slaves().size()), nodes_.pieces, nodes_.slave,
             nodes_.segment);
  fill_node_pairs(surface);
  sort_pairs(&Found::edges, static_cast<std::int64_t>(edges.edges().size()), edges_.pieces, edges_.first,
             edges_.second);
  fill_edge_pairs(surface, edges);
  join_sphere_pairs();
}

/// The diagonals span the face; each of their ends may go the way that it makes more than their mean, and stray.
template <class S>
typename FeatureLists<S>::Facing FeatureLists<S>::facing_of(const SurfaceSource<S>& source,
                                                            const std::int32_t (&node)[4]) const {
  Vec3<S> diagonal[2];
  S turned = 0;
  for (int d = 0; d < 2; ++d) {
    const std::int32_t a = node[d], b = node[d + 2];
    diagonal[d] = vector_of(source.x(b)) - vector_of(source.x(a));
    const Vec3<S> v = vector_of(source.v(b)) - vector_of(source.v(a));
    const S way =
        box_horizon_ * square_root(dot(v, v)) + motion_.allowance(std::array{a}) + motion_.allowance(std::array{b});
    turned += way / square_root(dot(diagonal[d], diagonal[d]));
  }
  const Vec3<S> area = cross(diagonal[0], diagonal[1]);
  const S size = square_root(dot(area, area));
  const S lengths = square_root(dot(diagonal[0], diagonal[0]) * dot(diagonal[1], diagonal[1]));
  Facing facing{(1 / size) * area, S(1.2) * turned * lengths / size};  // the arcus sine of up to 0.8
  if (!(facing.angle < S(0.96))) facing = {{S(0), S(0), S(0)}, S(2)};  // any direction; also where there is no area
  return facing;
}

template <class S>
typename FeatureLists<S>::Facing FeatureLists<S>::facing_of_all(std::span<const std::int32_t> segments) const {
  Vec3<S> sum{S(0), S(0), S(0)};
  for (const std::int32_t s : segments) sum = sum + facing_[s].normal;
  const S length = square_root(dot(sum, sum));
  Facing all{(length > S(0) ? 1 / length : S(0)) * sum, S(0)};
  for (const std::int32_t s : segments) {
    const Vec3<S> d = facing_[s].normal - all.normal;
    const S chord2 = dot(d, d);
    if (!(length > S(0)) || !(chord2 < S(2))) return {{S(0), S(0), S(0)}, S(2)};
    all.angle = maximum(all.angle, S(1.12) * square_root(chord2) + facing_[s].angle);  // up to a right angle
  }
  return all;
}

template <class S>
void FeatureLists<S>::find_facings(const SegmentSurface<S>& surface, const EdgeTable<S>& edges) {
  const auto range = [](const auto& of) { return RangePolicy<>{0, static_cast<std::int64_t>(of.size())}; };
  node_facing_.resize(surface.slaves().size());
  edge_facing_.resize(edges.edges().size());
  around_.resize(facing_.size());
  parallel_for("facing of nodes", range(node_facing_),
               [&](std::int64_t i) { node_facing_[i] = facing_of_all(surface.around(static_cast<std::size_t>(i))); });
  parallel_for("facing of edges", range(edge_facing_), [&](std::int64_t e) {
    edge_facing_[e] = facing_of_all(edges.segments_of(static_cast<std::int32_t>(e)));
  });
  parallel_for("facing around segments", range(around_), [&](std::int64_t i) {
    around_[i] = facing_[i];
    for (const std::int32_t slave : surface.slaves_of(static_cast<std::int32_t>(i))) {
      const Vec3<S> d = node_facing_[slave].normal - facing_[i].normal;
      around_[i].angle = maximum(around_[i].angle, S(1.12) * square_root(dot(d, d)) + node_facing_[slave].angle);
    }
  });
}

/// What belongs to the one segment against the other, and the other way round.
template <class S>
void FeatureLists<S>::find_in_pair(const SegmentSurface<S>& surface, const EdgeTable<S>& edges, std::int32_t a,
                                   std::int32_t b, Found& found) const {
  const auto nodes_of = [&](std::int32_t own, std::int32_t other) {
    const MovingBox<S> box = boxes_.box(other);
    const std::array<std::int32_t, 4>& slaves = surface.slaves_of(own);
    const std::array<std::int32_t, 8>& corners = surface.segments()[other].corners;
    for (std::size_t k = 0; k < 4; ++k) {
      const std::int32_t slave = slaves[k];
      if (surface.slaves()[slave].owner != own || !may_face(node_facing_[slave], facing_[other])) continue;
      if (!meet(node_box_[slave], box)) continue;
      if (std::find(slaves.begin(), slaves.begin() + k, slave) != slaves.begin() + k) continue;  // of a triangle
      if (std::find(corners.begin(), corners.end(), surface.slaves()[slave].node) != corners.end()) continue;
      found.nodes.push_back({slave, other});
    }
  };
  nodes_of(a, b);
  nodes_of(b, a);
  for (const std::int32_t e : edges.owned_by(a)) {
    if (e < 0) continue;
    for (const std::int32_t f : edges.owned_by(b)) {
      if (f < 0 || !may_face(edge_facing_[e], edge_facing_[f]) || !meet(edge_box_[e], edge_box_[f])) continue;
      if (!edges.share_node(e, f)) found.edges.push_back({std::min(e, f), std::max(e, f)});
    }
  }
}

/// Pairs sorted by their first and then by their second: rows come in an order that does not depend on what else is
/// listed, nor on when the lists were built. pieces: of consecutive firsts, each beginning at a whole pack.
/// firsts: numbers that a first may have.
template <class S>
void FeatureLists<S>::sort_pairs(std::vector<Pair> Found::*some, std::int64_t firsts, ListPieces& pieces,
                                 std::vector<std::int32_t>& first, std::vector<std::int32_t>& second) {
  constexpr std::int64_t W = native_width<S>;
  end_of_first_.assign(static_cast<std::size_t>(firsts), 0);
  pieces.entries = 0;
  for (const Found& found : found_) {
    for (const Pair& pair : found.*some) ++end_of_first_[pair[0]];
    pieces.entries += static_cast<std::int64_t>((found.*some).size());
  }
  pieces.count = ListPieces::count_for(pieces.entries);
  std::int64_t place = 0;
  for (std::int64_t piece = 0; piece < pieces.count; ++piece) {
    pieces.begin[piece] = place = (place + W - 1) / W * W;
    for (std::int64_t f = firsts * piece / pieces.count; f < firsts * (piece + 1) / pieces.count; ++f) {
      const std::int64_t count = end_of_first_[f];
      end_of_first_[f] = place;
      place += count;
    }
    pieces.end[piece] = place;
  }
  pieces.places = (place + W - 1) / W * W;
  first.assign(static_cast<std::size_t>(pieces.places), 0);
  second.assign(static_cast<std::size_t>(pieces.places), 0);
  for (const Found& found : found_) {
    for (const Pair& pair : found.*some) {
      const std::int64_t at = end_of_first_[pair[0]]++;
      first[at] = pair[0];
      second[at] = pair[1];
    }
  }
  for (std::int64_t piece = 0; piece < pieces.count; ++piece) {
    for (std::int64_t at = pieces.begin[piece]; at < pieces.end[piece];) {
      const std::int64_t end = end_of_first_[first[at]];
      std::sort(second.begin() + at, second.begin() + end);
      at = end;
    }
  }
}

template <class S>
void FeatureLists<S>::fill_node_pairs(const SegmentSurface<S>& surface) {
  nodes_.node.renew(nodes_.slave.size());
  nodes_.size.renew(nodes_.slave.size());
  nodes_.radius.renew(nodes_.slave.size());
  for (std::size_t i = 0; i < nodes_.slave.size(); ++i) {
    nodes_.node[i] = surface.slaves()[nodes_.slave[i]].node;
    nodes_.size[i] = surface.segments()[nodes_.segment[i]].size;
    nodes_.radius[i] = surface.segments()[nodes_.segment[i]].radius;
  }
}

template <class S>
void FeatureLists<S>::fill_edge_pairs(const SegmentSurface<S>& surface, const EdgeTable<S>& edges) {
  for (auto& node : edges_.node) node.renew(edges_.first.size());
  edges_.size.renew(edges_.first.size());
  for (std::size_t i = 0; i < edges_.first.size(); ++i) {
    const auto &first = edges.edges()[edges_.first[i]], &second = edges.edges()[edges_.second[i]];
    for (std::size_t end = 0; end < 2; ++end) {
      edges_.node[end][i] = first.node[end];
      edges_.node[2 + end][i] = second.node[end];
    }
    edges_.size[i] = surface.segments()[first.owner].size + surface.segments()[second.owner].size;
  }
}

template <class S>
void FeatureLists<S>::join_sphere_pairs() {
  for (auto* list : {&spheres_.with_segments, &spheres_.with_spheres}) list->clear();
  for (const Found& found : found_) {
    spheres_.with_segments.insert(spheres_.with_segments.end(), found.sphere_segments.begin(),
                                  found.sphere_segments.end());
    spheres_.with_spheres.insert(spheres_.with_spheres.end(), found.spheres.begin(), found.spheres.end());
  }
  for (auto* list : {&spheres_.with_segments, &spheres_.with_spheres}) std::sort(list->begin(), list->end());
}

template <class S>
void FeatureLists<S>::persist(StateArchive& archive, const SegmentSurface<S>& surface, const EdgeTable<S>& edges) {
  archive(valid_, watched_, nodes_.pieces, nodes_.slave, nodes_.segment, edges_.pieces, edges_.first, edges_.second,
          spheres_.with_segments, spheres_.with_spheres);
  clock_.persist(archive);
  motion_.persist(archive);
  if (!archive.reads()) return;
  fill_node_pairs(surface);
  fill_edge_pairs(surface, edges);
}

template <class S>
std::size_t FeatureLists<S>::bytes() const {
  const auto of = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
  std::size_t sum = motion_.bytes() + boxes_.bytes() + pairs_.bytes() + of(nodes_.slave) + of(nodes_.segment) +
                    nodes_.node.bytes() + of(edges_.first) + of(edges_.second) + of(spheres_.with_segments) +
                    of(spheres_.with_spheres) + of(end_of_first_) + of(node_box_) + of(edge_box_) + of(facing_) +
                    of(around_) + of(node_facing_) + of(edge_facing_) + nodes_.size.bytes() + nodes_.radius.bytes() +
                    edges_.size.bytes();
  for (const Found& found : found_) {
    sum += of(found.nodes) + of(found.edges) + of(found.sphere_segments) + of(found.spheres);
  }
  return sum;
}

template class FeatureLists<double>;
template class FeatureLists<float>;

}  // namespace pinball
