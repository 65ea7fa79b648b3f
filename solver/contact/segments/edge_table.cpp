#include "edge_table.hpp"

#include <algorithm>

namespace pinball {

template <class S>
void EdgeTable<S>::collect(const SegmentSurface<S>& surface) {
  struct End {
    std::int32_t other, segment, side, slave;
  };
  edges_.clear();
  edges_of_.assign(surface.segments().size(), {-1, -1, -1, -1});
  std::vector<End> ends;  // of the edges from a node to nodes of higher numbers
  for (std::size_t i = 0; i < surface.slaves().size(); ++i) {
    const std::int32_t node = surface.slaves()[i].node;
    ends.clear();
    for (const std::int32_t s : surface.around(i)) {
      const auto& segment = surface.segments()[s];
      for (std::int32_t k = 0; k < 4; ++k) {
        const std::int32_t a = segment.node[k], b = segment.node[(k + 1) % 4];
        const std::size_t next = (k + 1) % 4;
        const std::array<std::int32_t, 4>& slaves = surface.slaves_of(s);
        if (a == node && b > node) ends.push_back({b, s, k, slaves[next]});
        if (b == node && a > node) ends.push_back({a, s, k, slaves[k]});
      }
    }
    std::sort(ends.begin(), ends.end(), [](const End& a, const End& b) {
      return a.other != b.other ? a.other < b.other : a.segment < b.segment;
    });
    for (std::size_t e = 0; e < ends.size();) {
      const End& first = ends[e];
      Edge edge{{node, first.other}, {static_cast<std::int32_t>(i), first.slave}, {}};
      edge.segment.fill(-1);
      std::size_t count = 0;
      for (; e < ends.size() && ends[e].other == first.other; ++e) {
        edges_of_[ends[e].segment][ends[e].side] = edges_.size();
        const bool again = count > 0 && edge.segment[count - 1] == ends[e].segment;  // around a node that it has twice
        if (!again && count < most_segments) edge.segment[count++] = ends[e].segment;
      }
      edges_.push_back(edge);
    }
  }
}

template class EdgeTable<double>;
template class EdgeTable<float>;

}  // namespace pinball
