#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <solver/base/point.hpp>

namespace pinball {

/// A direction in which a node is held, of unit length.
struct HeldDirection {
  std::int32_t node;
  Point normal;
};

/// The directions in which constraints and prescribed velocities leave each node no mobility; orthonormal per node:
/// whoever gives them sees to that.
class HeldDirections {
 public:
  HeldDirections() = default;  ///< of no nodes: may not be asked for any
  HeldDirections(std::int32_t node_count, std::span<const HeldDirection> held);

  std::span<const Point> of(std::int32_t node) const {
    return {directions_.data() + first_[node], directions_.data() + first_[node + 1]};
  }
  std::size_t bytes() const { return directions_.capacity() * sizeof(Point) + first_.capacity() * sizeof(first_[0]); }

 private:
  std::vector<Point> directions_;
  std::vector<std::int32_t> first_;  ///< per node and one more
};

}  // namespace pinball
