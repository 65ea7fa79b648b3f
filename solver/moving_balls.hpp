#pragma once

#include <array>
#include <cstdint>
#include <pinball/kernels/ball_tree.hpp>
#include <pinball/solver/aligned_array.hpp>
#include <vector>

namespace pinball {

/// Balls in straight motion, as BallTreeView wants them.
template <class S>
class MovingBalls {
 public:
  MovingBalls() = default;
  explicit MovingBalls(std::int32_t count) { reset(count); }
  /// As a new set of so many balls, in the same memory.
  void reset(std::int32_t count);
  /// Two balls may touch while their distance is less than the sum of their radii. way: what the ball makes in the time
  /// considered, in a straight line; all [length].
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

/// What may come near each ball of a group. Its memory serves many groups, one after the other.
template <class S>
class NearBalls {
 public:
  struct Group {
    std::int32_t number;
    unsigned balls;  ///< of it, that come near; one bit each
  };
  /// own: a group of balls, as they lie in MovingBalls; from: the group of the tree to begin with.
  void find(const BallTreeView<S>& tree, const S* own, std::int32_t from);
  /// In rising order; some have no balls.
  const std::vector<Group>& of(int ball) const { return near_[static_cast<std::size_t>(ball)]; }

 private:
  std::array<std::vector<Group>, ball_group<S>> near_;
};

}  // namespace pinball
