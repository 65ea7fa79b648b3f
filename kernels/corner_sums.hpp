#pragma once

#include <cstdint>

#include "element_data.hpp"

/// Sums of corner forces by the nodes: what a device does in the place of adding them to records element after element.
/// No two threads write to one place, and each sum has one order: that in which the lists name the corners.
namespace pinball {

/// Corners of elements by their nodes. Corner i of element e is number 8 e + i.
struct CornersOfNodes {
  const std::uint32_t* first;   ///< [nodes + 1]: where the corners of a node begin
  const std::uint32_t* corner;  ///< node after node
};

/// Adds the forces of its corners to those of a node. corner_force: of KeptAtCorners, in rows of L [force]; force: x,
/// y, z of the node [force].
template <int L, class S>
PINBALL_FUNCTION void add_corner_forces(const CornersOfNodes& corners, const S* corner_force, std::int64_t node,
                                        S* force) {
  S sum[3] = {force[0], force[1], force[2]};
  for (std::uint32_t c = corners.first[node]; c < corners.first[node + 1]; ++c) {
    const std::uint32_t corner = corners.corner[c];
    const S* const value = corner_force + place_in_rows<L>(corner / 8, 24) + 3 * static_cast<int>(corner % 8) * L;
    for (int k = 0; k < 3; ++k) sum[k] += value[k * L];
  }
  for (int k = 0; k < 3; ++k) force[k] = sum[k];
}

}  // namespace pinball
