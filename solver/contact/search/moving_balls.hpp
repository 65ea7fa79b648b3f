#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <kernels/ball_tree.hpp>
#include <kernels/exec/array.hpp>

#include "moving_boxes.hpp"

namespace pinball {

/// Balls in straight motion, as BallTreeView wants them.
template <class S>
class MovingBalls {
 public:
  MovingBalls() = default;
  explicit MovingBalls(std::int32_t count) { reset(count); }
  /// As a new set of so many balls, in the same memory; each is to be set.
  void reset(std::int32_t count);
  /// Two balls may touch while their distance is less than the sum of their radii. way: what the ball makes in the time
  /// considered, in a straight line; all [length].
  void set(std::int32_t i, const std::array<S, 3>& centre, const std::array<S, 3>& way, S radius);
  std::int32_t count() const { return count_; }
  const S* data() const { return record_.data(); }
  std::size_t bytes() const { return record_.bytes(); }

 private:
  std::int32_t count_ = 0;
  Array<S> record_;
};

/// Box of the balls of a group, finite: however far these reach, nothing meets the box that nothing is in.
template <class S>
MovingBox<S> finite_box_of_balls(const S* ball) {
  constexpr S largest = std::numeric_limits<S>::max();
  MovingBox<S> box = box_of_balls<Pack<S, native_width<S>>>(ball);
  for (int c = 0; c < 12; ++c) {
    S& bound = box.bound[c];
    bound = c % 6 < 3 ? std::max(bound, -largest) : std::min(bound, largest);
  }
  return box;
}

/// Boxes over moving balls (kernels/ball_tree.hpp), built anew for each set of balls in the same memory.
template <class S>
class BallTree {
 public:
  /// balls: have to stay where they are while the tree is used.
  void build(const MovingBalls<S>& balls);
  const BallTreeView<S>& view() const { return view_; }
  std::size_t bytes() const { return lowest_.bytes() + levels_.bytes(); }

 private:
  BallTreeView<S> view_{};
  Array<S> lowest_;  ///< a box per group of balls
  BoxLevels<S> levels_;
};

/// What may come near the balls of a group. Its memory serves many groups, one after the other.
template <class S>
class NearBalls {
 public:
  static constexpr int G = ball_group<S>;
  struct Group {
    std::int32_t number;
    BallBits<G> balls;  ///< of it, that come near each ball of ours
    BallBits<G> same;   ///< of it, that belong to the body of each ball of ours; for who looks for pairs
  };
  /// Takes the part of the tree, from this group of balls on, that a box may meet: that of some groups of balls.
  void enter(const BallTreeView<S>& tree, const MovingBox<S>& box, std::int32_t from);
  /// Groups of that part, from this one on, of which balls may come near those of a group whose box is in the box
  /// taken. own: the group of balls, as they lie in MovingBalls. In rising order; none without a ball that may come
  /// near.
  std::span<Group> find(const BallTreeView<S>& tree, const S* own, std::int32_t from);
  /// Leaves out what was found and does not come near: fast balls that pass each other. May leave groups without balls.
  static void leave_out_passing(const BallTreeView<S>& tree, const S* own, std::span<Group> found);
  std::size_t bytes() const {
    return part_box_.bytes() + (part_.capacity() + near_part_.capacity() + candidate_.capacity()) * sizeof(part_[0]) +
           near_.capacity() * sizeof(Group);
  }

 private:
  /// Writes what it finds into near_, and returns how many.
  template <bool moves>
  std::size_t find_near(const BallTreeView<S>& tree, const S* own, std::int32_t from);

  std::vector<std::int32_t> part_;  ///< groups of the boxes of groups of balls
  Array<S> part_box_;               ///< and their boxes, in groups
  // Room for what is found, and for a group of numbers more.
  std::vector<std::int32_t> near_part_;  ///< numbers in part_
  std::vector<std::int32_t> candidate_;  ///< groups of balls
  std::vector<Group> near_;
};

}  // namespace pinball
