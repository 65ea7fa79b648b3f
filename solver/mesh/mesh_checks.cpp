#include "mesh_checks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <kernels/exec.hpp>
#include <solver/base/point.hpp>

#include "element_table.hpp"

namespace pinball {

namespace {

using Hexahedron = std::array<std::int32_t, 8>;

/// The three neighbours of each corner, in an order that makes the triple product of a box positive.
constexpr int neighbours[8][3] = {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7},
                                  {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}};
/// Edges along each parent direction, in one order around it: (-,-), (+,-), (+,+), (-,+) of the two that follow.
constexpr int edges_along[3][4][2] = {
    {{0, 1}, {3, 2}, {7, 6}, {4, 5}}, {{0, 3}, {4, 7}, {5, 6}, {1, 2}}, {{0, 4}, {1, 5}, {2, 6}, {3, 7}}};

double triple(const Point& a, const Point& b, const Point& c) { return dot(a, cross(b, c)); }

/// The Jacobian is the triple product of three tangents, each a mean of the four edges along its direction. With
/// weights (1 +- s)(1 +- t)/4 it is that of a point: s and t are 0 at the centre and 1/sqrt(3) at a Gauss point.
struct Tangents {
  Point edge[3][4];

  Point at(int direction, double s, double t) const {
    const double weight[4] = {(1 - s) * (1 - t) / 4, (1 + s) * (1 - t) / 4, (1 + s) * (1 + t) / 4,
                              (1 - s) * (1 + t) / 4};
    Point sum{};
    for (int i = 0; i < 4; ++i) {
      for (int k = 0; k < 3; ++k) sum[k] += weight[i] * edge[direction][i][k];
    }
    return sum;
  }
  double jacobian(double x, double y, double z) const { return triple(at(0, y, z), at(1, z, x), at(2, x, y)); }
};

struct Shape {
  double centre, worst, square_of_shortest;
};

/// Whether the Jacobian is positive everywhere, as far as a bound tells: tangents anywhere lie between the four edges
/// of their direction, no farther than `off` from the mean, so that the Jacobian differs from that of the means by no
/// more than the product of the lengths grows.
bool is_surely_positive(const Tangents& tangents, double centre) {
  double with = 1, without = 1;
  for (int direction = 0; direction < 3; ++direction) {
    const Point mean = tangents.at(direction, 0, 0);
    double off = 0;
    for (const Point& edge : tangents.edge[direction]) {
      const Point d = minus(edge, mean);
      off = std::max(off, dot(d, d));
    }
    const double length = std::sqrt(dot(mean, mean));
    without *= length;
    with *= length + std::sqrt(off);
  }
  return centre > 1.000001 * (with - without);
}

Shape shape_of(const std::array<Point, 8>& x, const Hexahedron& nodes) {
  Tangents tangents;
  double longest = 0, shortest = std::numeric_limits<double>::infinity();
  for (int direction = 0; direction < 3; ++direction) {
    for (int i = 0; i < 4; ++i) {
      const auto& ends = edges_along[direction][i];
      const Point edge = minus(x[ends[1]], x[ends[0]]);
      tangents.edge[direction][i] = edge;
      const double square = dot(edge, edge);
      longest = std::max(longest, square);
      if (nodes[ends[0]] != nodes[ends[1]]) shortest = std::min(shortest, square);
    }
  }
  const double centre = tangents.jacobian(0, 0, 0);
  if (is_surely_positive(tangents, centre)) return {centre, 0.0, shortest};
  double worst = std::numeric_limits<double>::infinity();
  for (int corner = 0; corner < 8; ++corner) {
    const auto& n = neighbours[corner];
    worst = std::min(worst, triple(minus(x[n[0]], x[corner]), minus(x[n[1]], x[corner]), minus(x[n[2]], x[corner])));
  }
  const double g = 1 / std::sqrt(3.0);
  for (int point = 0; point < 8; ++point) {
    worst = std::min(worst, tangents.jacobian(point & 1 ? g : -g, point & 2 ? g : -g, point & 4 ? g : -g));
  }
  // A collapsed corner has a Jacobian of round-off.
  const double round_off = 1e-12 * longest * std::sqrt(longest);
  return {centre, worst < -round_off ? worst : 0.0, shortest};
}

/// Where a node lies in a grid of cells that are small beside elements and large beside the tolerance.
struct Cell {
  /// Along each axis: its number, and 1 or -1 where what is near may lie in the next cell or the one before.
  std::array<std::int64_t, 3> place{};
  std::array<int, 3> next{};

  static constexpr double tolerances = 1024;  ///< edge of a cell

  Cell(const Point& x, double tolerance) {
    for (std::size_t k = 0; k < 3; ++k) {
      // Borders are at no round numbers, at which nodes are.
      const double at = x[k] / (tolerances * tolerance) + 0.3819660112501051, floor = std::floor(at);
      // Beyond this a coordinate has no room for its fraction.
      place[k] = static_cast<std::int64_t>(std::clamp(floor, -9e18, 9e18));
      next[k] = at - floor < 1.1 / tolerances ? -1 : at - floor > 1 - 1.1 / tolerances ? 1 : 0;
    }
  }
  /// Of the cell itself (0), or of one beside it: bit k says whether it is the next one along axis k.
  std::uint64_t key(int beside) const {
    std::uint64_t key = 0;
    for (std::size_t k = 0; k < 3; ++k)
      key = mixed_bits(key + static_cast<std::uint64_t>(place[k]) +
                       static_cast<std::uint64_t>(beside >> k & 1 ? next[k] : 0));
    return key;
  }
  bool has(int beside) const {
    for (int k = 0; k < 3; ++k) {
      if ((beside >> k & 1) != 0 && next[k] == 0) return false;
    }
    return true;
  }
};

/// Which keys there may be: a bit for each, which others may share. It fits a cache, as a table of places does not: all
/// but the few that it takes for repeated are done with.
class KeyFilter {
 public:
  explicit KeyFilter(std::size_t keys)
      : bits_(std::max<std::size_t>(std::bit_ceil(keys), 64) / 4), mask_(64 * bits_.size() - 1) {}

  bool has(std::uint64_t key) const { return (bits_[(key & mask_) / 64] >> (key & 63) & 1) != 0; }
  /// Whether it was there before.
  bool add(std::uint64_t key) {
    std::uint64_t& word = bits_[(key & mask_) / 64];
    const std::uint64_t bit = std::uint64_t{1} << (key & 63), before = word;
    word |= bit;
    return (before & bit) != 0;
  }

 private:
  std::vector<std::uint64_t> bits_;
  std::uint64_t mask_;
};

bool near(const Point& a, const Point& b, double tolerance) {
  const Point d = minus(a, b);
  return dot(d, d) <= tolerance * tolerance;
}

/// Nodes that have, or may have, another one in their cell or in one beside it that is near; ascending.
std::vector<std::int32_t> nodes_with_neighbours(const std::vector<Point>& nodes, const std::vector<bool>& used,
                                                double tolerance) {
  std::vector<std::uint64_t> keys(nodes.size());
  std::vector<std::uint8_t> at_border(nodes.size());
  parallel_for("keys_of_nodes", RangePolicy<>{0, std::ssize(nodes)}, [&](std::int64_t n) {
    const Cell cell(nodes[n], tolerance);
    keys[n] = cell.key(0);
    at_border[n] = cell.next != std::array<int, 3>{};
  });
  KeyFilter cells(nodes.size()), repeated(nodes.size());
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    if (!used[n]) continue;
    if (cells.add(keys[n])) repeated.add(keys[n]);
  }
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    if (!used[n] || at_border[n] == 0) continue;
    const Cell cell(nodes[n], tolerance);
    for (int beside = 1; beside < 8; ++beside) {
      if (!cell.has(beside) || !cells.has(cell.key(beside))) continue;
      repeated.add(cell.key(beside));
      repeated.add(keys[n]);
    }
  }
  std::vector<std::int32_t> found;
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    if (used[n] && repeated.has(keys[n])) found.push_back(n);
  }
  return found;
}

/// Elements that have, or may have, the same nodes as another one; ascending.
std::vector<std::int32_t> elements_with_equals(const std::vector<Hexahedron>& hexahedra) {
  std::vector<std::uint64_t> keys(hexahedra.size());
  parallel_for("keys_of_elements", RangePolicy<>{0, std::ssize(hexahedra)},
               [&](std::int64_t e) { keys[e] = key_of_nodes(hexahedra[e]); });
  KeyFilter all(hexahedra.size()), repeated(hexahedra.size());
  for (const std::uint64_t key : keys) {
    if (all.add(key)) repeated.add(key);
  }
  std::vector<std::int32_t> found;
  for (std::size_t e = 0; e < keys.size(); ++e) {
    if (repeated.has(keys[e])) found.push_back(e);
  }
  return found;
}

}  // namespace

ShapeFindings check_shapes(const std::vector<Point>& nodes, const std::vector<Hexahedron>& hexahedra) {
  struct Found {
    std::vector<std::int32_t> at_centre, somewhere;
    double shortest = std::numeric_limits<double>::infinity();
  };
  Found found;
  parallel_reduce(
      "check_shapes", RangePolicy<>{0, std::ssize(hexahedra)}, found,
      [&](std::int64_t begin, std::int64_t end, Found& part) {
        for (std::int64_t e = begin; e < end; ++e) {
          std::array<Point, 8> x;
          for (std::size_t i = 0; i < 8; ++i) x[i] = nodes[hexahedra[e][i]];
          const Shape shape = shape_of(x, hexahedra[e]);
          part.shortest = std::min(part.shortest, shape.square_of_shortest);
          if (!(shape.centre > 0)) {
            part.at_centre.push_back(e);
          } else if (shape.worst < 0) {
            part.somewhere.push_back(e);
          }
        }
      },
      [](Found& all, const Found& part) {
        all.at_centre.insert(all.at_centre.end(), part.at_centre.begin(), part.at_centre.end());
        all.somewhere.insert(all.somewhere.end(), part.somewhere.begin(), part.somewhere.end());
        all.shortest = std::min(all.shortest, part.shortest);
      });
  return {std::move(found.at_centre), std::move(found.somewhere), std::sqrt(found.shortest)};
}

std::vector<std::pair<std::int32_t, std::int32_t>> coincident_nodes(const std::vector<Point>& nodes,
                                                                    const std::vector<bool>& used, double tolerance) {
  std::vector<std::pair<std::int32_t, std::int32_t>> pairs;
  if (!(tolerance > 0) || !std::isfinite(tolerance)) return pairs;
  const std::vector<std::int32_t> candidates = nodes_with_neighbours(nodes, used, tolerance);
  PlaceTable table(candidates.size());
  for (const std::int32_t node : candidates) {
    const auto is_near = [&](std::int32_t other) { return near(nodes[other], nodes[node], tolerance); };
    const Cell cell(nodes[node], tolerance);
    std::int32_t other = table.find_or_add(cell.key(0), node, is_near);
    for (int beside = 1; beside < 8 && other == node; ++beside) {
      if (!cell.has(beside)) continue;
      const std::int32_t found = table.find(cell.key(beside), is_near);
      if (found >= 0) other = found;
    }
    if (other != node) pairs.emplace_back(other, node);
  }
  return pairs;
}

std::vector<std::pair<std::int32_t, std::int32_t>> repeated_elements(const std::vector<Hexahedron>& hexahedra) {
  std::vector<std::pair<std::int32_t, std::int32_t>> pairs;
  const std::vector<std::int32_t> candidates = elements_with_equals(hexahedra);
  PlaceTable table(candidates.size());
  for (const std::int32_t e : candidates) {
    const std::int32_t other = table.find_or_add(key_of_nodes(hexahedra[e]), e, [&](std::int32_t before) {
      return std::is_permutation(hexahedra[e].begin(), hexahedra[e].end(), hexahedra[before].begin());
    });
    if (other != e) pairs.emplace_back(other, e);
  }
  return pairs;
}

}  // namespace pinball
