#include "edge_rows.hpp"

#include <algorithm>
#include <cmath>

#include <kernels/exec.hpp>
#include <kernels/gather.hpp>

namespace pinball {

namespace {

/// How far beyond its ends the nearest point of an edge may lie, over its length [-]: what is beyond is met by nodes.
constexpr double end_margin = 1e-3;
/// Edges whose angle has a smaller sine count as parallel: their nodes meet the faces [-].
constexpr double least_sine = 0.02;
/// Sine of the angle by which the faces of an edge may look away from the other body: edges of flat surfaces take part,
/// those at the bottom of a valley do not [-].
constexpr double slack = 0.2;

/// What the faces of an edge are like.
struct EdgeSides {
  Vec3<double> normal{0, 0, 0};                         ///< sum of their unit normals
  std::array<Vec3<double>, 2> middle{}, unit_normal{};  ///< of the faces
  int faces = 0;                                        ///< that are active, of the first two
  double radius = 0, size = 0;                          ///< least of the segments [length]
};

template <class S>
EdgeSides sides_of(const SegmentSurface<S>& surface, const typename EdgeTable<S>::Edge& edge) {
  EdgeSides sides;
  sides.radius = sides.size = INFINITY;
  for (const std::int32_t s : EdgeTable<S>::segments_of(edge)) {
    if (sides.faces == 2) break;
    if (!surface.active_segment(s)) continue;
    const auto f = static_cast<std::size_t>(sides.faces++);
    sides.unit_normal[f] = double_vector_of(record(surface.plane().data(), s));
    sides.middle[f] = double_vector_of(record(surface.sphere().data(), s));
    sides.normal = sides.normal + sides.unit_normal[f];
    sides.radius = std::min(sides.radius, static_cast<double>(surface.segments()[s].radius));
    sides.size = std::min(sides.size, static_cast<double>(surface.segments()[s].size));
  }
  return sides;
}

/// Whether the first two active faces of an edge make an angle: its nodes need not look at what they touch. On a flat
/// surface nodes at crossings meet faces.
template <class S>
bool is_sharp(const SegmentSurface<S>& surface, const typename EdgeTable<S>::Edge& edge) {
  const S* before = nullptr;
  for (const std::int32_t s : EdgeTable<S>::segments_of(edge)) {
    if (!surface.active_segment(s)) continue;
    const S* const plane = record(surface.plane().data(), s);
    if (before != nullptr) return dot(double_vector_of(before), double_vector_of(plane)) < 0.9;
    before = plane;
  }
  return true;
}

/// Whether the faces of an edge go away from the other body: point: on the edge; away: unit vector.
bool goes_away(const EdgeSides& sides, const Vec3<double>& point, const Vec3<double>& away) {
  for (int f = 0; f < sides.faces; ++f) {
    const Vec3<double> to = sides.middle[static_cast<std::size_t>(f)] - point;
    if (dot(to, away) < -slack * std::sqrt(dot(to, to))) return false;
  }
  return dot(sides.normal, away) < 0;
}

/// The deepest that a node of either edge was in a row of the step before.
template <class Edge>
double depth_before(const StepReach& step, const Edge& first, const Edge& second) {
  return static_cast<double>(std::max(
      {step.depth[first.node[0]], step.depth[first.node[1]], step.depth[second.node[0]], step.depth[second.node[1]]}));
}

bool face_each_other(const EdgeSides& first, const EdgeSides& second) {
  double least = 1;
  for (int f = 0; f < first.faces; ++f) {
    for (int g = 0; g < second.faces; ++g) {
      least = std::min(
          least, dot(first.unit_normal[static_cast<std::size_t>(f)], second.unit_normal[static_cast<std::size_t>(g)]));
    }
  }
  return least < most_facing;
}

}  // namespace

/// Pairs whose lines come near each other between their ends.
template <class S>
void EdgeRows<S>::find_near(const SurfaceSource<S>& source, const EdgeTable<S>& edges, const EdgePairs& pairs,
                            std::int64_t piece, const StepReach& step, std::vector<std::int32_t>& near_pairs) {
  using T = Pack<S, native_width<S>>;
  constexpr int W = width_of<T>;
  const std::int64_t begin = pairs.pieces.begin[piece], end = pairs.pieces.end[piece];
  near_pairs.clear();
  const S margin = sizeof(S) == 8 ? S(0.01) : S(0.05);
  for (std::int64_t place = begin; place < end; place += W) {
    const auto ends = [&](std::size_t n) { return gather_vectors<T>(source.position, pairs.node[n].data() + place); };
    const Vec3<T> a = ends(0), b = ends(1), c = ends(2), d = ends(3);
    // What has passed each other is as near again.
    T near = number<T>(near_gap) * load<T>(pairs.size.data() + place) + number<T>(step.approach);
    if (step.some_deep) {
      alignas(64) S deep[W];
      for (int i = 0; i < W; ++i) {
        deep[i] = static_cast<S>(
            depth_before(step, edges.edges()[pairs.first[place + i]], edges.edges()[pairs.second[place + i]]));
      }
      near = near + load<T>(deep);
    }
    const EdgePair<T> pair = nearest_points(a, b, c, d);
    const T low = T(S(0) - margin), high = T(S(1) + margin);
    unsigned bits = lane_bits<T>(pair.s > low && pair.s < high && pair.t > low && pair.t < high &&
                                 pair.sine2 > number<T>(0.25 * least_sine * least_sine) &&
                                 dot(pair.between, pair.between) < near * near);
    for (; bits != 0; bits &= bits - 1) {
      const std::int64_t at = place + __builtin_ctz(bits);
      if (at < end) near_pairs.push_back(static_cast<std::int32_t>(at));
    }
  }
}

template <class S>
void EdgeRows<S>::add_row(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, const Edge& first,
                          const Edge& second, const StepReach& step, std::vector<FeatureRow>& rows) {
  const auto x = [&](const Edge& edge, int end) { return double_vector_of(source.x(edge.node[end])); };
  const Vec3<double> a = x(first, 0), b = x(first, 1), c = x(second, 0), d = x(second, 1);
  const EdgePair<double> pair = nearest_points(a, b, c, d);
  const auto within = [](double s) { return s > -end_margin && s < 1 + end_margin; };
  if (!within(pair.s) || !within(pair.t) || !(pair.sine2 > least_sine * least_sine)) return;
  const auto at_end = [](double s) { return s < end_margin || s > 1 - end_margin; };
  if ((at_end(pair.s) || at_end(pair.t)) && !(is_sharp(surface, first) && is_sharp(surface, second))) return;
  const EdgeSides sides1 = sides_of(surface, first), sides2 = sides_of(surface, second);
  if (sides1.faces == 0 || sides2.faces == 0 || !face_each_other(sides1, sides2)) return;
  const Vec3<double> across = cross(b - a, d - c);
  const double size = std::sqrt(dot(across, across));
  const double outward = dot(sides2.normal - sides1.normal, across) < 0 ? -1.0 : 1.0;
  const Vec3<double> direction = (outward / size) * across;
  const double gap = dot(pair.between, direction);
  if (!goes_away(sides1, a + pair.s * (b - a), direction) ||
      !goes_away(sides2, c + pair.t * (d - c), (-1.0) * direction)) {
    return;
  }
  if (surface.beside(EdgeTable<S>::segments_of(first), EdgeTable<S>::segments_of(second))) return;
  FeatureRow row;
  row.first = ~EdgeTable<S>::name_of(first);
  row.second = EdgeTable<S>::name_of(second);
  row.direction = direction;
  row.depth = 0 - gap;
  row.size = sides1.radius + sides2.radius;
  row.reach = std::min(sides1.size, sides2.size);
  if (step.pairs != nullptr) row.pair = step.pairs->edges(first.node[0], first.node[1], second.node[0], second.node[1]);
  row.add_side(first.node, {1 - pair.s, pair.s}, -1);
  row.add_side(second.node, {1 - pair.t, pair.t}, 1);
  double closing = 0;
  for (int k = 0; k < row.nodes; ++k)
    closing += row.weight[k] * dot(double_vector_of(source.v(row.node[k])), direction);
  closing *= step.dt;
  if (gap < -deepest_edges * row.reach - std::max(0.0, closing) - depth_before(step, first, second)) return;
  if (may_close(gap, closing, row.reach)) rows.push_back(row);
}

template <class S>
void EdgeRows<S>::find(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, const EdgeTable<S>& edges,
                       const EdgePairs& pairs, const StepReach& step) {
  rows_.find("edge rows", pairs.pieces.count, [&](std::int64_t number, RowPieces::Piece& piece) {
    find_near(source, edges, pairs, number, step, piece.near);
    for (const std::int32_t place : piece.near) {
      add_row(source, surface, edges.edges()[pairs.first[place]], edges.edges()[pairs.second[place]], step, piece.rows);
    }
  });
}

template class EdgeRows<double>;
template class EdgeRows<float>;

}  // namespace pinball
