#include "outward.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pinball {

namespace {

Vec3<double> unit(const Vec3<double>& v) {
  const double size = std::sqrt(dot(v, v));
  return (size > 0 ? 1 / size : 0.0) * v;
}

template <class S>
Vec3<double> place(const NodeRecords<S>& nodes, std::int32_t node) {
  return double_vector_of(nodes.x(node));
}

template <class S>
Vec3<double> face_normal(const NodeRecords<S>& nodes, const std::int32_t (&node)[4]) {
  return unit(cross(place(nodes, node[2]) - place(nodes, node[0]), place(nodes, node[3]) - place(nodes, node[1])));
}

template <class S>
Outward at_edge(const NodeRecords<S>& nodes, const SegmentSurface<S>& surface, std::int32_t slave, std::int32_t a,
                std::int32_t b) {
  Vec3<double> sum{0, 0, 0};
  int faces = 0;
  for (const std::int32_t s : surface.around(slave)) {
    const auto& node = surface.segments()[s].node;
    const auto has = [&node](std::int32_t n) { return std::find(node, node + 4, n) != node + 4; };
    if (!surface.active_segment(s) || !has(a) || !has(b)) continue;
    sum = sum + face_normal(nodes, node);
    ++faces;
  }
  return {unit(sum), faces > 1};
}

template <class S>
Outward at_node(const NodeRecords<S>& nodes, const SegmentSurface<S>& surface, std::int32_t slave, std::int32_t own) {
  Vec3<double> sum{0, 0, 0};
  std::vector<std::int32_t> ends;  // of the edges here: each belongs to two faces
  for (const std::int32_t s : surface.around(slave)) {
    if (!surface.active_segment(s)) continue;
    const auto& node = surface.segments()[s].node;
    const auto at = std::find(node, node + 4, own) - node;
    std::int32_t next = own, before = own;  // a collapsed face has the node twice
    for (int k = 3; k > 0; --k) {
      if (node[(at + k) % 4] != own) next = node[(at + k) % 4];
      if (node[(at + 4 - k) % 4] != own) before = node[(at + 4 - k) % 4];
    }
    const Vec3<double> e1 = unit(place(nodes, next) - place(nodes, own));
    const Vec3<double> e2 = unit(place(nodes, before) - place(nodes, own));
    const Vec3<double> area = cross(e1, e2);
    sum = sum + std::atan2(std::sqrt(dot(area, area)), dot(e1, e2)) * face_normal(nodes, node);
    ends.push_back(next);
    ends.push_back(before);
  }
  std::sort(ends.begin(), ends.end());
  bool closed = true;
  for (std::size_t i = 0; i < ends.size(); i += 2) closed = closed && i + 1 < ends.size() && ends[i] == ends[i + 1];
  return {unit(sum), closed};
}

}  // namespace

template <class S>
Outward outward_at(const NodeRecords<S>& nodes, const SegmentSurface<S>& surface, std::int32_t segment,
                   const int (&rim)[2]) {
  const auto& node = surface.segments()[segment].node;
  if (rim[0] < 0) return {face_normal(nodes, node), true};
  const std::int32_t a = node[rim[0]], b = node[rim[1]], slave = surface.slaves_of(segment)[rim[0]];
  return a == b ? at_node(nodes, surface, slave, a) : at_edge(nodes, surface, slave, a, b);
}

template Outward outward_at(const NodeRecords<double>&, const SegmentSurface<double>&, std::int32_t, const int (&)[2]);
template Outward outward_at(const NodeRecords<float>&, const SegmentSurface<float>&, std::int32_t, const int (&)[2]);

}  // namespace pinball
