#pragma once

#include <cstdint>
#include <pinball/solver/model.hpp>
#include <span>
#include <vector>

namespace pinball {

/// The directions in which constraints and prescribed velocities leave each node no mobility; orthonormal per node
/// (model_constraints.cpp sees to that).
class HeldDirections {
 public:
  template <class S>
  explicit HeldDirections(const Model<S>& model);

  /// node: of the node store.
  std::span<const Point> of(std::int32_t node) const {
    const auto n = static_cast<std::size_t>(node);
    return {directions_.data() + first_[n], directions_.data() + first_[n + 1]};
  }
  std::size_t bytes() const { return directions_.capacity() * sizeof(Point) + first_.capacity() * sizeof(first_[0]); }

 private:
  std::vector<Point> directions_;
  std::vector<std::int32_t> first_;  ///< per node and one more
};

}  // namespace pinball
