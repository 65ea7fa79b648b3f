#include "listed_pairs.hpp"

#include <algorithm>
#include <cmath>

#include <kernels/exec.hpp>
#include <kernels/simd.hpp>

#include "feature_bounds.hpp"

namespace pinball {

namespace {

/// Makes a list that has no room for more anew, with some.
void make_anew(SortedPairs& list, const SortedPairs& more, std::size_t firsts, std::int64_t width) {
  for (PairColumns& some : list.found()) some.pairs = 0;
  const auto add = [&list](std::int32_t a, std::int32_t b) { list.found()[0].add(a, b); };
  list.for_each(add);
  more.for_each(add);
  list.sort(firsts, width, true);
}

/// What an edge does not do while its faces look within bounds: those of its first two active segments make an angle
/// with less than these cosines.
template <class S>
std::uint8_t flatness_of(const SegmentSurface<S>& surface, const EdgeTable<S>& edges, const FeatureBounds<S>& bounds,
                         std::int32_t edge) {
  constexpr double largest_at_end = 0.451, largest_along = 1.047;
  static_assert(sharp_at_end == 0.9 && sharp_along == 0.5, "their arcus cosines");
  std::int32_t before = -1;
  for (const std::int32_t s : edges.segments_of(edge)) {
    if (!surface.active_segment(s)) continue;
    if (before >= 0) {
      const Facing<S>&one = bounds.facing(before), &other = bounds.facing(s);
      if (!(one.angle < 1 && other.angle < 1)) return 0;  // any direction
      const Vec3<S> d = one.normal - other.normal;
      // An arc is no more than 1.12 of a chord of up to a right angle.
      const double angle =
          1.12 * std::sqrt(static_cast<double>(dot(d, d))) + bounds.angle_on_way(before) + bounds.angle_on_way(s);
      const int bits = (angle < largest_at_end ? ListedEdges<S>::flat_at_end : 0) |
                       (angle < largest_along ? ListedEdges<S>::flat_along : 0);
      return static_cast<std::uint8_t>(bits);
    }
    before = s;
  }
  return 0;
}

}  // namespace

template <class S>
void ListedNodes<S>::fill(const SegmentSurface<S>& surface) {
  node.renew(first.size());
  size.renew(first.size());
  radius.renew(first.size());
  apart.renew(first.size());
  parallel_for("listed nodes", RangePolicy<>{0, pieces.places},
               [&](std::int64_t place) { fill_place(place, surface); });
}

template <class S>
void ListedNodes<S>::fill_place(std::int64_t place, const SegmentSurface<S>& surface) {
  const auto& segment = surface.segments()[second[place]];
  node[place] = surface.slaves()[first[place]].node;
  size[place] = segment.size;
  radius[place] = segment.radius;
  const auto around = surface.around(first[place]);
  apart[place] =
      std::none_of(around.begin(), around.end(), [&](std::int32_t s) { return surface.beside(s, second[place]); });
}

template <class S>
void ListedNodes<S>::take_in(const SortedPairs& more, const SegmentSurface<S>& surface) {
  if (more.pieces.entries == 0) return;
  if (const auto room = insert(more)) {
    room->make_in(node.data());
    room->make_in(size.data());
    room->make_in(radius.data());
    room->make_in(apart.data());
    room->for_each_place([&](std::int64_t place) { fill_place(place, surface); });
  } else {
    make_anew(*this, more, surface.slaves().size(), native_width<S>);
    fill(surface);
  }
}

template <class S>
void ListedEdges<S>::fill(const SegmentSurface<S>& surface, const EdgeTable<S>& edges) {
  for (auto& of : node) of.renew(first.size());
  size.renew(first.size());
  flat.renew(first.size());
  any_flat_ = false;
  parallel_for("listed edges", RangePolicy<>{0, pieces.places},
               [&](std::int64_t place) { fill_place(place, surface, edges); });
}

template <class S>
void ListedEdges<S>::fill_place(std::int64_t place, const SegmentSurface<S>& surface, const EdgeTable<S>& edges) {
  const std::int32_t e = first[place], f = second[place];
  for (std::size_t end = 0; end < 2; ++end) {
    node[end][place] = edges.edges()[e].node[end];
    node[2 + end][place] = edges.edges()[f].node[end];
  }
  size[place] = size_at_edge(surface, edges, e) + size_at_edge(surface, edges, f);
  flat[place] = 0;
}

template <class S>
void ListedEdges<S>::find_flat(const SegmentSurface<S>& surface, const EdgeTable<S>& edges,
                               const FeatureBounds<S>& bounds) {
  any_flat_ = true;
  parallel_for("edges that stay flat", RangePolicy<>{0, pieces.count}, [&](std::int64_t piece) {
    std::int32_t edge = -1;
    std::uint8_t flatness = 0;
    for (std::int64_t place = pieces.begin[piece]; place < pieces.end[piece]; ++place) {
      if (first[place] != edge) flatness = flatness_of(surface, edges, bounds, edge = first[place]);
      flat[place] = flatness | flatness_of(surface, edges, bounds, second[place]);
    }
  });
}

template <class S>
void ListedEdges<S>::forget_flat() {
  if (!any_flat_) return;
  any_flat_ = false;
  parallel_for("edges that were to stay flat", RangePolicy<>{0, pieces.count}, [&](std::int64_t piece) {
    std::fill(flat.data() + pieces.begin[piece], flat.data() + pieces.end[piece], std::uint8_t(0));
  });
}

template <class S>
void ListedEdges<S>::take_in(const SortedPairs& more, const SegmentSurface<S>& surface, const EdgeTable<S>& edges) {
  if (more.pieces.entries == 0) return;
  if (const auto room = insert(more)) {
    for (auto& of : node) room->make_in(of.data());
    room->make_in(size.data());
    room->make_in(flat.data());
    room->for_each_place([&](std::int64_t place) { fill_place(place, surface, edges); });
  } else {
    make_anew(*this, more, edges.edges().size(), native_width<S>);
    fill(surface, edges);
  }
}

template struct ListedNodes<double>;
template struct ListedNodes<float>;
template struct ListedEdges<double>;
template struct ListedEdges<float>;

}  // namespace pinball
