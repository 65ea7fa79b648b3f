#include "feature_lists.hpp"

#include <algorithm>
#include <limits>
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
void FeatureLists<S>::build(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, const EdgeTable<S>& edges,
                            const SphereSurface<S>& spheres, const ContactSettings& settings,
                            const std::vector<float>& depth, S dt, bool last) {
  const S horizon = last ? horizon_steps * clock_.last_step() : S(0);
  if (watched_) motion_.adapt(source.position, clock_.elapsed(), horizon);
  if (!valid_) watch_nodes(source, surface, spheres);
  watched_ = true;
  motion_.start(source.position, source.velocity, last ? static_cast<S>(settings.skin) : S(0));
  const S last_step = std::max(dt, clock_.last_step());
  clock_.restart(horizon);
  valid_ = true;
  bounds_.update(source, surface, edges, spheres, motion_, depth, last_step, horizon);
  find(surface, edges, spheres, settings);
}

template <class S>
void FeatureLists<S>::find(const SegmentSurface<S>& surface, const EdgeTable<S>& edges, const SphereSurface<S>& spheres,
                           const ContactSettings& settings) {
  const auto segments = static_cast<std::int32_t>(surface.segments().size());
  const auto body_of = [&](std::int32_t i) {
    return i < segments ? surface.segments()[i].body : spheres.spheres()[i - segments].body;
  };
  pairs_.find(bounds_.boxes(), settings.search, [&](std::int32_t a, std::int32_t b) {
    const bool one_body = body_of(a) == body_of(b);
    if (b >= segments) return settings.self || !one_body;
    return (settings.self || !one_body) && bounds_.around(a).may_face(bounds_.around(b));
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

/// What belongs to the one segment against the other, and the other way round.
template <class S>
void FeatureLists<S>::find_in_pair(const SegmentSurface<S>& surface, const EdgeTable<S>& edges, std::int32_t a,
                                   std::int32_t b, Found& found) const {
  const MovingBox<S> box_a = bounds_.boxes().box(a), box_b = bounds_.boxes().box(b);
  find_nodes_in_pair(surface, a, b, box_b, found);
  find_nodes_in_pair(surface, b, a, box_a, found);
  const auto near_edges = [&](std::int32_t own, std::int32_t other, const MovingBox<S>& box) {
    std::array<std::int32_t, 4> near{};
    std::size_t count = 0;
    for (const std::int32_t e : edges.owned_by(own)) {
      const bool may =
          e >= 0 && bounds_.edge_facing(e).may_face(bounds_.around(other)) && meet(bounds_.edge_box(e), box);
      if (may) near[count++] = e;
    }
    return std::pair(near, count);
  };
  const auto [of_a, count_a] = near_edges(a, b, box_b);
  if (count_a == 0) return;
  const auto [of_b, count_b] = near_edges(b, a, box_a);
  for (std::size_t i = 0; i < count_a; ++i) {
    for (std::size_t j = 0; j < count_b; ++j) {
      const std::int32_t e = of_a[i], f = of_b[j];
      if (!bounds_.edge_facing(e).may_face(bounds_.edge_facing(f)) || edges.share_node(e, f)) continue;
      if (meet(bounds_.edge_box(e), bounds_.edge_box(f))) found.edges.push_back({std::min(e, f), std::max(e, f)});
    }
  }
}

template <class S>
void FeatureLists<S>::find_nodes_in_pair(const SegmentSurface<S>& surface, std::int32_t own, std::int32_t other,
                                         const MovingBox<S>& box, Found& found) const {
  const std::array<std::int32_t, 4>& slaves = surface.slaves_of(own);
  const std::array<std::int32_t, 8>& corners = surface.segments()[other].corners;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::int32_t slave = slaves[k];
    if (surface.slaves()[slave].owner != own || !meet(bounds_.node_box(slave), box)) continue;
    if (!bounds_.node_facing(slave).may_face(bounds_.facing(other))) continue;
    if (std::find(slaves.begin(), slaves.begin() + k, slave) != slaves.begin() + k) continue;  // of a triangle
    if (std::find(corners.begin(), corners.end(), surface.slaves()[slave].node) != corners.end()) continue;
    found.nodes.push_back({slave, other});
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
  std::size_t sum = motion_.bytes() + bounds_.bytes() + pairs_.bytes() + of(nodes_.slave) + of(nodes_.segment) +
                    nodes_.node.bytes() + nodes_.size.bytes() + nodes_.radius.bytes() + of(edges_.first) +
                    of(edges_.second) + 4 * edges_.node[0].bytes() + edges_.size.bytes() + of(spheres_.with_segments) +
                    of(spheres_.with_spheres) + of(end_of_first_);
  for (const Found& found : found_) {
    sum += of(found.nodes) + of(found.edges) + of(found.sphere_segments) + of(found.spheres);
  }
  return sum;
}

template class FeatureLists<double>;
template class FeatureLists<float>;

}  // namespace pinball
