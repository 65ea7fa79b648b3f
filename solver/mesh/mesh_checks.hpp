#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include <solver/mesh.hpp>

namespace pinball {

/// What is wrong with the shape of elements. Corners where edges are collapsed do not count.
struct ShapeFindings {
  std::vector<std::int32_t> inverted_at_centre;  ///< the Jacobian of the element's centre is not positive
  std::vector<std::int32_t> inverted_somewhere;  ///< that of a corner or of a Gauss point (2 x 2 x 2) is negative
  double shortest_edge = 0.0;                    ///< of all elements; edges that are collapsed do not count [length]
};
ShapeFindings check_shapes(const std::vector<Point>& nodes, const std::vector<std::array<std::int32_t, 8>>& hexahedra);

/// Pairs of nodes, of those that elements use, that are no farther apart than the tolerance. Of several at one place
/// each has a pair with one before it.
std::vector<std::pair<std::int32_t, std::int32_t>> coincident_nodes(const std::vector<Point>& nodes,
                                                                    const std::vector<bool>& used, double tolerance);

/// Pairs of elements that have the same nodes.
std::vector<std::pair<std::int32_t, std::int32_t>> repeated_elements(
    const std::vector<std::array<std::int32_t, 8>>& hexahedra);

}  // namespace pinball
