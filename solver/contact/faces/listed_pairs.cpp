#include "listed_pairs.hpp"

#include <algorithm>

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
}

template <class S>
void ListedEdges<S>::take_in(const SortedPairs& more, const SegmentSurface<S>& surface, const EdgeTable<S>& edges) {
  if (more.pieces.entries == 0) return;
  if (const auto room = insert(more)) {
    for (auto& of : node) room->make_in(of.data());
    room->make_in(size.data());
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
