#pragma once

#include <fmt/format.h>

#include <array>
#include <string>
#include <vector>

#include <solver/base/point.hpp>

/// Two tetrahedra of ten nodes on the face 2, 3, 4: of the corners 1, 2, 3, 4 and 2, 3, 4, 5, with volumes of 1/6 and
/// 1/3. The node on the edge from i to j has the number ij.
namespace pinball::test {

inline const std::vector<std::pair<int, Point>> ten_nodes_nodes = [] {
  std::vector<std::pair<int, Point>> nodes{
      {1, {0, 0, 0}}, {2, {1, 0, 0}}, {3, {0, 1, 0}}, {4, {0, 0, 1}}, {5, {1, 1, 1}}};
  for (const auto& [i, j] : {std::pair(1, 2), {2, 3}, {1, 3}, {1, 4}, {2, 4}, {3, 4}, {2, 5}, {3, 5}, {4, 5}}) {
    const Point &a = nodes[i - 1].second, &b = nodes[j - 1].second;
    nodes.push_back({10 * i + j, {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2}});
  }
  return nodes;
}();

/// In the order of most formats: 12, 23, 13, 14, 24, 34 follow the corners 1, 2, 3, 4.
inline constexpr std::array<std::array<int, 10>, 2> ten_nodes_elements{
    {{1, 2, 3, 4, 12, 23, 13, 14, 24, 34}, {2, 3, 4, 5, 23, 34, 24, 25, 35, 45}}};

/// In that of LS-DYNA: 12, 23, 13, 24, 34, 14.
inline constexpr std::array<std::array<int, 10>, 2> keyword_ten_nodes{
    {{1, 2, 3, 4, 12, 23, 13, 24, 34, 14}, {2, 3, 4, 5, 23, 34, 24, 35, 45, 25}}};

/// "1, 0, 0, 0\n" for each node, or with another separator.
inline std::string ten_nodes_lines(const std::string& separator = ", ") {
  std::string lines;
  for (const auto& [number, x] : ten_nodes_nodes)
    lines += fmt::format("{}{}{}{}{}{}{}\n", number, separator, x[0], separator, x[1], separator, x[2]);
  return lines;
}

inline std::string joined(const std::array<int, 10>& numbers, const std::string& separator = ", ") {
  return fmt::format("{}", fmt::join(numbers, separator));
}

}  // namespace pinball::test
