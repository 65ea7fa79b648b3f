#include "edge_table.hpp"

#include <algorithm>
#include <iterator>

#include <solver/base/lists_in_order.hpp>

namespace pinball {

namespace {

/// An edge at a node, as a side of a segment there. other, slave: node and slave at its other end.
struct End {
  std::int32_t other, segment, side, slave;
};

/// Adds the edges from the node of a slave to nodes of higher numbers, by these and by the segments. Returns how many
/// edges these are.
template <class S>
std::int64_t add_ends(const SegmentSurface<S>& surface, std::int64_t slave, std::vector<End>& ends) {
  const std::int32_t node = surface.slaves()[slave].node;
  const std::ptrdiff_t before = std::ssize(ends);
  for (const std::int32_t s : surface.around(slave)) {
    const auto& segment = surface.segments()[s];
    for (std::int32_t k = 0; k < 4; ++k) {
      const std::int32_t a = segment.node[k], b = segment.node[(k + 1) % 4];
      const std::size_t next = (k + 1) % 4;
      const std::array<std::int32_t, 4>& slaves = surface.slaves_of(s);
      if (a == node && b > node) ends.push_back({b, s, k, slaves[next]});
      if (b == node && a > node) ends.push_back({a, s, k, slaves[k]});
    }
  }
  std::sort(ends.begin() + before, ends.end(),
            [](const End& a, const End& b) { return a.other != b.other ? a.other < b.other : a.segment < b.segment; });
  std::int64_t edges = 0;
  for (auto e = ends.begin() + before; e != ends.end(); ++e) {
    edges += e == ends.begin() + before || e->other != std::prev(e)->other ? 1 : 0;
  }
  return edges;
}

}  // namespace

template <class S>
void EdgeTable<S>::collect(const SegmentSurface<S>& surface) {
  edges_of_.renew(surface.segments().size());
  parallel_for("edges of segments", RangePolicy<>{0, std::ssize(surface.segments())}, [&](std::int64_t s) {
    edges_of_[s] = {-1, -1, -1, -1};
  });
  const std::int64_t slaves = std::ssize(surface.slaves());
  first_.resize(slaves);
  ends_up_to_.resize(slaves);
  std::array<std::vector<End>, fixed_pieces> found;
  parallel_for("edges of slaves", RangePolicy<>{0, fixed_pieces}, [&](std::int64_t piece) {
    const std::int64_t end = slaves * (piece + 1) / fixed_pieces;
    for (std::int64_t i = slaves * piece / fixed_pieces; i < end; ++i) {
      first_[i] = add_ends(surface, i, found[piece]);
      ends_up_to_[i] = std::ssize(found[piece]);
    }
  });
  edges_.renew(make_offsets(first_));
  parallel_for("edges", RangePolicy<>{0, fixed_pieces}, [&](std::int64_t piece) {
    const std::vector<End>& ends = found[piece];
    std::size_t e = 0;
    const std::int64_t end = slaves * (piece + 1) / fixed_pieces;
    for (std::int64_t i = slaves * piece / fixed_pieces; i < end; ++i) {
      const auto up_to = static_cast<std::size_t>(ends_up_to_[i]);
      for (std::int64_t number = first_[i]; e < up_to; ++number) {
        const End& one = ends[e];
        Edge edge{{surface.slaves()[i].node, one.other}, {static_cast<std::int32_t>(i), one.slave}, {}};
        edge.segment.fill(-1);
        std::size_t count = 0;
        for (; e < up_to && ends[e].other == one.other; ++e) {
          edges_of_[ends[e].segment][ends[e].side] = static_cast<std::int32_t>(number);
          const bool again =
              count > 0 && edge.segment[count - 1] == ends[e].segment;  // around a node that it has twice
          if (!again && count < most_segments) edge.segment[count++] = ends[e].segment;
        }
        edges_[number] = edge;
      }
    }
  });
}

template class EdgeTable<double>;
template class EdgeTable<float>;

}  // namespace pinball
