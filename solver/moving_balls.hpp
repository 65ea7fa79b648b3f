#pragma once

#include <array>
#include <cstdint>
#include <pinball/kernels/ball_tree.hpp>
#include <pinball/solver/aligned_array.hpp>

namespace pinball {

/// Balls in straight motion, as BallTreeView wants them.
template <class S>
class MovingBalls {
 public:
  explicit MovingBalls(std::int32_t count = 0);
  /// Two balls may touch while their distance is less than the sum of their radii.
  void set(std::int32_t i, const std::array<S, 3>& centre, const std::array<S, 3>& way, S radius);
  std::int32_t count() const { return count_; }
  const S* data() const { return record_.data(); }
  std::size_t bytes() const { return record_.bytes(); }

 private:
  std::int32_t count_ = 0;
  AlignedArray<S> record_;
};

/// Boxes over moving balls (kernels/ball_tree.hpp), built anew for each set of balls in the same memory.
template <class S>
class BallTree {
 public:
  /// balls: have to stay where they are while the tree is used.
  void build(const MovingBalls<S>& balls);
  const BallTreeView<S>& view() const { return view_; }
  std::size_t bytes() const;

 private:
  BallTreeView<S> view_{};
  std::array<AlignedArray<S>, ball_tree_levels> box_;
};

}  // namespace pinball
