#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include <kernels/ball_tree.hpp>
#include <kernels/exec/array.hpp>

namespace pinball {

/// Makes a box as large as another asks for.
template <class S>
void include_box(MovingBox<S>& box, const MovingBox<S>& other) {
  for (int c = 0; c < 12; ++c) {
    box.bound[c] = c % 6 < 3 ? minimum(box.bound[c], other.bound[c]) : maximum(box.bound[c], other.bound[c]);
  }
}

/// Boxes with bounds at the beginning and at the end of a time considered, in groups as BoxTreeView wants them.
template <class S>
class MovingBoxes {
 public:
  MovingBoxes() { reset(0); }
  explicit MovingBoxes(std::int32_t count) { reset(count); }
  /// As a new set of so many boxes, in the same memory; each is to be set.
  void reset(std::int32_t count);
  /// box: its bounds [length], which may be infinite. One with a lower bound above the upper, or with a bound that is
  /// not a number, becomes the box that nothing is in. May be called for different boxes at the same time.
  void set(std::int32_t i, const MovingBox<S>& box);
  /// The same of a pack of boxes; first: number of the first, a multiple of the width of the pack. Those beyond the
  /// last box of the set have to be ones that nothing is in.
  template <class T>
  void set_pack(std::int64_t first, const T (&bound)[12]);
  MovingBox<S> box(std::int32_t i) const { return get_box(bound_.data(), i); }
  std::int32_t count() const { return count_; }
  std::int64_t groups() const { return groups_; }  ///< at least one
  const S* data() const { return bound_.data(); }
  std::size_t bytes() const { return bound_.bytes(); }

 private:
  std::int32_t count_ = 0;
  std::int64_t groups_ = 0;
  Array<S> bound_;
};

template <class S>
template <class T>
void MovingBoxes<S>::set_pack(std::int64_t first, const T (&bound)[12]) {
  constexpr int G = ball_group<S>;
  constexpr S largest = std::numeric_limits<S>::max();
  auto proper = bound[0] <= bound[3];
  for (int c = 1; c < 9; ++c) {
    if (c % 6 < 3) proper = proper && bound[c] <= bound[c + 3];
  }
  S* const to = bound_.data() + first / G * 12 * G + first % G;
  for (int c = 0; c < 12; ++c) {
    const T kept = minimum(T(largest), maximum(T(-largest), bound[c]));
    store(select(proper, kept, number<T>(c % 6 < 3 ? HUGE_VAL : -HUGE_VAL)), to + c * G);
  }
}

/// Levels of boxes over boxes, built anew for each set in the same memory.
template <class S>
class BoxLevels {
 public:
  /// Builds the levels above the lowest, which has to stay where it is while they are used. lowest: groups of G boxes,
  /// 12 components; view: whose levels are set, from the lowest on.
  void build(const S* lowest, std::int64_t groups, BoxTreeView<S>& view);
  /// Makes the boxes above box i of the lowest level as large as it asks for.
  void include(const MovingBox<S>& box, std::int64_t i, int levels);
  std::size_t bytes() const;

 private:
  std::array<Array<S>, ball_tree_levels> level_;
};

}  // namespace pinball
