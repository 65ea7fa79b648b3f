#include "section.hpp"

#include <cmath>
#include <numbers>

namespace pinball {
namespace {

using Point2 = std::array<double, 2>;

/// Points of the whole disc by their place in the grid: i, j in the core, m layers outward from its boundary.
class Disc {
 public:
  Disc(const std::array<int, 2>& counts, int ring)
      : counts_(counts),
        ring_(ring),
        corner_(0.5 * std::numbers::pi * counts[1] / (counts[0] + counts[1])),
        core_scale_(1.0 / (1.0 + core_edge * std::numbers::pi / (counts[0] + counts[1]) * ring)) {}

  Point2 core_point(int i, int j) const {
    if (on_boundary(i, j)) return core_boundary(i, j);
    // Transfinite interpolation between the four sides.
    const int p = counts_[0], q = counts_[1];
    const double u = static_cast<double>(i) / p, v = static_cast<double>(j) / q;
    Point2 point;
    for (int axis = 0; axis < 2; ++axis) {
      const auto side = [&](int bi, int bj) { return core_boundary(bi, bj)[axis]; };
      point[axis] = (1 - u) * side(0, j) + u * side(p, j) + (1 - v) * side(i, 0) + v * side(i, q) -
                    (1 - u) * ((1 - v) * side(0, 0) + v * side(0, q)) - u * ((1 - v) * side(p, 0) + v * side(p, q));
    }
    return on_middle(i, j, point);
  }

  Point2 ring_point(int i, int j, int m) const {
    const Point2 outer = direction(i, j);
    if (m == ring_) return outer;
    const Point2 inner = core_boundary(i, j);
    const double w = static_cast<double>(m) / ring_;
    return {(1 - w) * inner[0] + w * outer[0], (1 - w) * inner[1] + w * outer[1]};
  }

  bool on_boundary(int i, int j) const { return i == 0 || i == counts_[0] || j == 0 || j == counts_[1]; }

 private:
  double parameter(int axis, int i) const {
    return 2.0 * i / counts_[axis] - 1.0;
  }  // -1 ... 1, exactly 0 in the middle

  Point2 on_middle(int i, int j, Point2 point) const {
    if (2 * i == counts_[0]) point[0] = 0.0;
    if (2 * j == counts_[1]) point[1] = 0.0;
    return point;
  }

  /// Unit vector of the column at a point of the core's boundary.
  Point2 direction(int i, int j) const {
    const double u = parameter(0, i), v = parameter(1, j);
    if (std::abs(u) == 1.0) return on_middle(i, j, {u * std::cos(corner_ * v), std::sin(corner_ * v)});
    const double angle = (0.5 * std::numbers::pi - corner_) * u;
    return on_middle(i, j, {std::sin(angle), v * std::cos(angle)});
  }

  Point2 core_boundary(int i, int j) const {
    const Point2 d = direction(i, j);
    const bool x_side = i == 0 || i == counts_[0];
    const double flat = x_side ? std::cos(corner_) / std::abs(d[0]) : std::sin(corner_) / std::abs(d[1]);
    const double r = core_scale_ * ((1.0 - core_bulge) * flat + core_bulge);
    return {r * d[0], r * d[1]};
  }

  std::array<int, 2> counts_;
  int ring_;
  double corner_;      // angle of the core's corner from the first axis [rad]
  double core_scale_;  // distance of the corner from the centre
};

}  // namespace

SectionMesh disc_section(const std::array<int, 2>& counts, int ring, const std::array<bool, 2>& cut) {
  const Disc disc(counts, ring);
  const int p = counts[0], q = counts[1], i0 = cut[0] ? p / 2 : 0, j0 = cut[1] ? q / 2 : 0;
  SectionMesh mesh;
  // Numbers of the first core node of each row, and of the nodes of the columns by their point of the core's boundary.
  const auto core = [&](int i, int j) { return (j - j0) * (p - i0 + 1) + i - i0; };
  std::vector<std::int32_t> column(core(p, q) + 1, -1);
  for (int j = j0; j <= q; ++j)
    for (int i = i0; i <= p; ++i) mesh.nodes.push_back(disc.core_point(i, j));
  for (int j = j0; j <= q; ++j)
    for (int i = i0; i <= p; ++i) {
      if (!disc.on_boundary(i, j)) continue;
      column[core(i, j)] = mesh.nodes.size();
      for (int m = 1; m <= ring; ++m) mesh.nodes.push_back(disc.ring_point(i, j, m));
    }
  const auto node = [&](int i, int j, int m) { return m == 0 ? core(i, j) : column[core(i, j)] + m - 1; };

  for (int j = j0; j < q; ++j)
    for (int i = i0; i < p; ++i)
      mesh.quadrilaterals.push_back({core(i, j), core(i + 1, j), core(i + 1, j + 1), core(i, j + 1)});
  // From a to b counterclockwise around the core.
  const auto add_column = [&](int ia, int ja, int ib, int jb) {
    for (int m = 0; m < ring; ++m)
      mesh.quadrilaterals.push_back({node(ia, ja, m), node(ia, ja, m + 1), node(ib, jb, m + 1), node(ib, jb, m)});
  };
  for (int j = j0; j < q; ++j) {
    add_column(p, j, p, j + 1);
    if (!cut[0]) add_column(0, j + 1, 0, j);
  }
  for (int i = i0; i < p; ++i) {
    add_column(i + 1, q, i, q);
    if (!cut[1]) add_column(i, 0, i + 1, 0);
  }
  return mesh;
}

Mesh turn_section(const SectionMesh& section, double angle) {
  const double radians = angle * std::numbers::pi / 180.0, cosine = std::cos(radians), sine = std::sin(radians);
  Mesh mesh;
  std::vector<std::int32_t> turned;  // number of each node at the end of the angle; on the axis it is the same
  for (const auto& [r, z] : section.nodes) mesh.nodes.push_back({r, 0.0, z});
  for (std::size_t n = 0; n < section.nodes.size(); ++n) {
    const auto [r, z] = section.nodes[n];
    turned.push_back(static_cast<std::int32_t>(r == 0.0 ? n : mesh.nodes.size()));
    if (r != 0.0) mesh.nodes.push_back({r * cosine, r * sine, z});
  }
  // Seen from y < 0 the section's z is to the left of its x: counterclockwise, with the turned side behind.
  for (const auto& q : section.quadrilaterals)
    mesh.hexahedra.push_back({turned[q[0]], turned[q[1]], turned[q[2]], turned[q[3]], q[0], q[1], q[2], q[3]});
  return mesh;
}

Mesh extrude_section(const SectionMesh& section, double length, int layers) {
  Mesh mesh;
  const std::int32_t count = section.nodes.size();
  for (int k = 0; k <= layers; ++k)
    for (const auto& [x, y] : section.nodes) mesh.nodes.push_back({x, y, length * (static_cast<double>(k) / layers)});
  for (int k = 0; k < layers; ++k)
    for (const auto& q : section.quadrilaterals) {
      const std::int32_t low = k * count, high = low + count;
      mesh.hexahedra.push_back(
          {low + q[0], low + q[1], low + q[2], low + q[3], high + q[0], high + q[1], high + q[2], high + q[3]});
    }
  return mesh;
}

}  // namespace pinball
