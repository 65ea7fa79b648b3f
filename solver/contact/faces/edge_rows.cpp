#include "edge_rows.hpp"

#include <algorithm>
#include <cmath>

#include <kernels/compress.hpp>
#include <kernels/exec.hpp>
#include <kernels/gather.hpp>

namespace pinball {

namespace {

/// How far beyond its ends the nearest point of an edge may lie, over its length [-]: what is beyond is met by nodes.
constexpr double end_margin = 1e-3;
/// Sine of the angle between edges below which the way across both is hardly one, for it turns with the least of their
/// motions: of what lies flat on each other the nodes meet the faces there, knives meet along the normals of their
/// faces
/// [-].
constexpr double small_sine = 0.02;
/// Below this edges are parallel: their ends meet the faces [-].
constexpr double least_sine = 1e-6;
/// Sine of the angle by which the faces of an edge may go towards the other body: edges of flat surfaces take part,
/// those at the bottom of a valley do not. Those of edges that are nearly parallel go away by as much: they are knives
/// [-].
constexpr double slack = 0.2;

/// Whether points of two edges lie on them, but for a margin, and whether on an end of either.
bool is_within(const EdgePair<double>& at) {
  const auto within = [](double s) { return s > -end_margin && s < 1 + end_margin; };
  return within(at.s) && within(at.t);
}
bool is_at_end(const EdgePair<double>& at) {
  const auto at_end = [](double s) { return s < end_margin || s > 1 - end_margin; };
  return at_end(at.s) || at_end(at.t);
}

/// Largest cosine between faces that look at each other within 60 degrees.
constexpr double looks_back = -0.5;

/// Depth of edges over the size of the smaller segment from which on it is asked whether they have come in there [-].
constexpr double doubtful = 2e-3;

/// How far two edges with a row may be from each other, over the size of the segments of both together, but for what
/// closes in a step, and the depth of the step before: no row is deeper than deepest_edges of the smaller one. A fifth
/// more, for rounding [-].
constexpr double near_edges = 0.6 * std::max(deepest_edges, open_gap);
static_assert(near_edges <= near_gap);

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
    const std::size_t f = sides.faces++;
    sides.unit_normal[f] = double_vector_of(record(surface.plane().data(), s));
    sides.middle[f] = double_vector_of(record(surface.sphere().data(), s));
    sides.normal = sides.normal + sides.unit_normal[f];
    sides.radius = std::min(sides.radius, static_cast<double>(surface.segments()[s].radius));
    sides.size = std::min(sides.size, static_cast<double>(surface.segments()[s].size));
  }
  return sides;
}

/// Whether the first two active faces of an edge make an angle with at most this cosine.
template <class S>
bool is_sharp(const SegmentSurface<S>& surface, const typename EdgeTable<S>::Edge& edge, double cosine) {
  const S* before = nullptr;
  for (const std::int32_t s : edge.segment) {
    if (s < 0) break;
    if (!surface.active_segment(s)) continue;
    const S* const plane = record(surface.plane().data(), s);
    if (before != nullptr) return dot(double_vector_of(before), double_vector_of(plane)) < cosine;
    before = plane;
  }
  return true;
}

/// Whether the faces of an edge go away from the other body. point: on the edge; away: unit vector; least: sine of the
/// angle by which they do.
bool goes_away(const EdgeSides& sides, const Vec3<double>& point, const Vec3<double>& away, double least) {
  for (int f = 0; f < sides.faces; ++f) {
    const Vec3<double> to = sides.middle[f] - point;
    if (dot(to, away) < least * std::sqrt(dot(to, to))) return false;
  }
  return dot(sides.normal, away) < 0;
}

/// The deepest that a node of either edge was in a row of the step before.
template <class Edge>
double depth_before(const StepReach& step, const Edge& first, const Edge& second) {
  return std::max(
      {step.depth[first.node[0]], step.depth[first.node[1]], step.depth[second.node[0]], step.depth[second.node[1]]});
}

/// Against the faces of edge 1 and away from those of edge 2, across the edges: so far as its share goes, along the way
/// across both edges. across: of unit length, either way.
Vec3<double> between_faces(const EdgeSides& first, const EdgeSides& second, const Vec3<double>& along,
                           const Vec3<double>& across, double share) {
  const Vec3<double> opposed = second.normal - first.normal;
  const Vec3<double> away = opposed - (dot(opposed, along) / dot(along, along)) * along;
  const Vec3<double> sum = (1 - share) * away + (share * dot(away, across)) * across;
  return (1 / std::sqrt(dot(sum, sum))) * sum;
}

/// Whether a point behind the faces of an edge is nearer to another face at its end, or in front of that, which the
/// faces of the edge are behind, and which looks at the other edge: it has not come in here. s: where it is on the
/// edge; depth: of the point [length].
template <class S>
bool is_beside(const SurfaceSource<S>& source, const SegmentSurface<S>& surface,
               const typename EdgeTable<S>::Edge& edge, double s, const EdgeSides& sides, const EdgeSides& others,
               const Vec3<double>& point, double depth) {
  const auto around = surface.around(edge.slave[s < 0.5 ? 0 : 1]);
  const auto own = EdgeTable<S>::segments_of(edge);
  return std::any_of(around.begin(), around.end(), [&](std::int32_t number) {
    if (!surface.active_segment(number) || std::find(own.begin(), own.end(), number) != own.end()) return false;
    Vec3<double> x[4];
    for (int k = 0; k < 4; ++k) x[k] = double_vector_of(source.x(surface.segments()[number].node[k]));
    const Vec3<double> area = cross(x[2] - x[0], x[3] - x[1]), middle = 0.25 * ((x[0] + x[1]) + (x[2] + x[3]));
    const Vec3<double> normal = (1 / std::sqrt(dot(area, area))) * area;
    const auto any_of_sides = [](const EdgeSides& of, const auto& holds) {
      for (int f = 0; f < of.faces; ++f) {
        if (holds(of.unit_normal[f], of.middle[f])) return true;
      }
      return false;
    };
    const auto looks = [&](const Vec3<double>& of, const Vec3<double>&) { return dot(of, normal) < looks_back; };
    const auto rises = [&](const Vec3<double>&, const Vec3<double>& of) {
      return dot(of - middle, normal) > 1e-3 * sides.size;
    };
    return dot(point - middle, normal) > -0.9 * depth && any_of_sides(others, looks) && !any_of_sides(sides, rises);
  });
}

bool face_each_other(const EdgeSides& first, const EdgeSides& second) {
  double least = 1;
  for (int f = 0; f < first.faces; ++f) {
    for (int g = 0; g < second.faces; ++g) {
      least = std::min(least, dot(first.unit_normal[f], second.unit_normal[g]));
    }
  }
  return least < most_facing;
}

}  // namespace

/// Pairs whose lines come near each other between their ends.
template <class S>
void EdgeRows<S>::find_near(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, const EdgeTable<S>& edges,
                            const EdgePairs& pairs, const ListPart& part, const StepReach& step,
                            std::vector<std::int32_t>& near_pairs) {
  using T = Pack<S, native_width<S>>;
  constexpr int W = width_of<T>;
  near_pairs.clear();
  const S margin = sizeof(S) == 8 ? S(0.01) : S(0.05);
  for (std::int64_t place = part.begin / W * W; place < part.end; place += W) {
    const auto ends = [&](std::size_t n) { return gather_vectors<T>(source.position, pairs.node[n].data() + place); };
    const Vec3<T> a = ends(0), b = ends(1), c = ends(2), d = ends(3);
    // What has passed each other is as near again.
    T near = number<T>(near_edges) * load<T>(pairs.size.data() + place) + number<T>(step.approach);
    if (step.some_deep) {
      alignas(64) S deep[W];
      for (int i = 0; i < W; ++i) {
        const auto depth = [&](std::size_t end) { return step.depth[pairs.node[end][place + i]]; };
        deep[i] = static_cast<S>(std::max({depth(0), depth(1), depth(2), depth(3)}));
      }
      near = near + load<T>(deep);
    }
    const EdgePair<T> pair = nearest_points(a, b, c, d);
    const T low = T(S(0) - margin), high = T(S(1) + margin);
    const auto cross_here = pair.s > low && pair.s < high && pair.t > low && pair.t < high &&
                            pair.sine2 > number<T>(small_sine * small_sine) &&
                            dot(pair.between, pair.between) < near * near;
    // Of nearly parallel edges the middle of one is near the line of the other, but for the angle.
    const Vec3<T> u = b - a, to = number<T>(0.5) * ((c - a) + (d - a)), v = d - c;
    const Vec3<T> beside = to - (dot(to, u) / dot(u, u)) * u;
    const T reach = near + number<T>(small_sine) * square_root(dot(v, v));
    const auto lie_along = pair.sine2 < number<T>(1.1 * small_sine * small_sine) && dot(beside, beside) < reach * reach;
    unsigned bits = lane_bits<T>(cross_here || lie_along);
    if (bits == 0) continue;
    // What only sharp edges do, for sure: to meet at an end, to lie along each other.
    const auto is_end = [](const T& s) {
      return s < number<T>(0.9 * end_margin) || s > number<T>(1 - 0.9 * end_margin);
    };
    const unsigned at_end =
        lane_bits<T>(pair.sine2 > number<T>(1.1 * small_sine * small_sine) && (is_end(pair.s) || is_end(pair.t)));
    const unsigned along = lane_bits<T>(pair.sine2 < number<T>(0.9 * small_sine * small_sine));
    bits &= ~((at_end & pairs.template flat_bits<W>(place, EdgePairs::flat_at_end)) |
              (along & pairs.template flat_bits<W>(place, EdgePairs::flat_along)));
    for (; bits != 0; bits &= bits - 1) {
      const int i = lowest_bit(bits);
      const std::int64_t at = place + i;
      if (at < part.begin || at >= part.end) continue;
      const auto are_sharp = [&](double cosine) {
        return is_sharp(surface, edges.edges()[pairs.first[at]], cosine) &&
               is_sharp(surface, edges.edges()[pairs.second[at]], cosine);
      };
      if (((at_end >> i & 1U) != 0 && !are_sharp(sharp_at_end)) ||
          ((along >> i & 1U) != 0 && !are_sharp(sharp_along))) {
        continue;
      }
      near_pairs.push_back(static_cast<std::int32_t>(at));
    }
  }
}

template <class S>
void EdgeRows<S>::add_row(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, const Edge& first,
                          const Edge& second, const StepReach& step, const ImpulseSolver<S>* impulses,
                          std::vector<FeatureRow>& rows) {
  const auto x = [&](const Edge& edge, int end) { return double_vector_of(source.x(edge.node[end])); };
  const Vec3<double> a = x(first, 0), b = x(first, 1), c = x(second, 0), d = x(second, 1);
  EdgePair<double> pair = nearest_points(a, b, c, d);
  if (!(pair.sine2 > least_sine * least_sine)) return;
  const bool lie_along = pair.sine2 < small_sine * small_sine;
  if (!lie_along && !is_within(pair)) return;
  const auto are_sharp = [&](double cosine) {
    return is_sharp(surface, first, cosine) && is_sharp(surface, second, cosine);
  };
  if (lie_along ? !are_sharp(sharp_along) : is_at_end(pair) && !are_sharp(sharp_at_end)) return;
  const EdgeSides sides1 = sides_of(surface, first), sides2 = sides_of(surface, second);
  if (sides1.faces == 0 || sides2.faces == 0 || !face_each_other(sides1, sides2)) return;
  const Vec3<double> across = cross(b - a, d - c);
  const double size = std::sqrt(dot(across, across));
  const double outward = dot(sides2.normal - sides1.normal, across) < 0 ? -1.0 : 1.0;
  Vec3<double> direction = (outward / size) * across;
  if (lie_along) {
    direction = between_faces(sides1, sides2, b - a, direction, pair.sine2 / (small_sine * small_sine));
    pair = facing_points(a, b, c, d, direction);
    if (!is_within(pair) || is_at_end(pair)) return;
  }
  const double gap = dot(pair.between, direction);
  const double least = lie_along ? slack : -slack;
  if (!goes_away(sides1, a + pair.s * (b - a), direction, least) ||
      !goes_away(sides2, c + pair.t * (d - c), (-1.0) * direction, least)) {
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
  const double explained = std::max(0.0, closing) + depth_before(step, first, second);
  if (gap < -deepest_edges * row.reach - explained) return;
  // What touched in the step before has come in here.
  const bool is_new = impulses == nullptr || !impulses->has_touched(row.first, row.second);
  if (is_new && gap < -doubtful * row.reach - explained &&
      (is_beside(source, surface, first, pair.s, sides1, sides2, c + pair.t * (d - c), 0 - gap) ||
       is_beside(source, surface, second, pair.t, sides2, sides1, a + pair.s * (b - a), 0 - gap))) {
    return;
  }
  if (may_close(gap, closing, step.leap, row.reach)) rows.push_back(row);
}

template <class S>
void EdgeRows<S>::find(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, const EdgeTable<S>& edges,
                       const EdgePairs& pairs, const StepReach& step, const ImpulseSolver<S>* impulses,
                       const ListShare& share) {
  rows_.find("edge rows", share, [&](std::int64_t, const ListPart& part, RowPieces::Piece& piece) {
    find_near(source, surface, edges, pairs, part, step, piece.near);
    for (const std::int32_t place : piece.near) {
      add_row(source, surface, edges.edges()[pairs.first[place]], edges.edges()[pairs.second[place]], step, impulses,
              piece.rows);
    }
  });
}

template class EdgeRows<double>;
template class EdgeRows<float>;

}  // namespace pinball
