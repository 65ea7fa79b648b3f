#pragma once

#include <array>
#include <vector>

#include <solver/base/point.hpp>

namespace pinball {

/// Inertia of nodes that may be on one line, or in one point: nothing that acts on them turns them about it, and
/// turning about it moves none of them, but a tensor that is singular has no inverse. The moment about the line is made
/// the largest one, that across. With it the angular momentum, which is at right angles to the line and stays so, turns
/// them as without, and they have no spin about the line.
struct SlenderInertia {
  std::array<Point, 3> inertia{};  ///< of which there is an inverse [mass length^2]
  std::vector<Point> idle;         ///< axes about which the nodes have none; none, the line, or all three of a point

  /// A spin without what moves no node.
  Point moving(Point spin) const;
};

/// inertia: of the nodes about their centre [mass length^2]; mass: of them; far: how far from the origin they are, of
/// which their places have the round-off [length].
SlenderInertia slender_inertia(const std::array<Point, 3>& inertia, double mass, double far);

}  // namespace pinball
