#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <kernels/ball_tree.hpp>
#include <kernels/exec/array.hpp>
#include <kernels/tensor.hpp>
#include <solver/contact/contact_settings.hpp>

#include "moving_boxes.hpp"

namespace pinball {

/// Levels of boxes over moving boxes, which are the lowest level themselves.
template <class S>
class BoxTree {
 public:
  /// boxes: have to stay where they are while the tree is used.
  void build(const MovingBoxes<S>& boxes);
  /// Box i of those that the tree was built of has become another.
  void include(const MovingBox<S>& box, std::int32_t i) {
    view_.moves = true;
    levels_.include(box, i, view_.levels);
  }
  const BoxTreeView<S>& view() const { return view_; }
  std::size_t bytes() const { return levels_.bytes(); }

 private:
  BoxTreeView<S> view_{};
  BoxLevels<S> levels_;
};

/// The search that suits, where none is asked for: the tree, but the hash where the box of a group meets more than
/// most_met others in the mean of some. The tree's time grows with them, as where boxes that are near each other do not
/// have near numbers.
///
/// level, boxes: of the tree, that are boxes of groups, and how many there are.
template <class S>
ContactSearch suitable_search(ContactSearch asked, const BoxTreeView<S>& tree, int level, std::int64_t boxes,
                              std::int64_t most_met);

/// Where the boxes of groups look: those of two groups have nothing with each other, whether they meet or not, unless
///
///     n_1 . n_2 < r_1 + r_2 .
template <class S>
class GroupDirections {
 public:
  /// As new ones of so many groups; each is to be set.
  void reset(std::int64_t groups);
  /// normal: n, of unit length or zero; reach: r. May be called for different groups at the same time.
  void set(std::int64_t group, const Vec3<S>& normal, S reach);
  /// Of a group of groups those that may have something with this group, one bit each.
  unsigned with(std::int64_t group, std::int64_t part) const;
  std::size_t bytes() const { return value_.bytes(); }

 private:
  static constexpr int G = ball_group<S>;
  Array<S> value_;  ///< in groups of groups, 4 components: n, r
};

/// What meets the boxes of a group. Its memory serves many groups, one after the other.
template <class S>
class NearBoxes {
 public:
  static constexpr int G = ball_group<S>;
  /// Takes the groups, from this one on, whose boxes may meet those of this group. Groups are to be entered in rising
  /// order; after a jump with `anew`. directions: of the groups; null: all may have something with all.
  void enter(const BoxTreeView<S>& tree, std::int32_t group, bool anew, const GroupDirections<S>* directions = nullptr);
  /// Whether there are no such groups.
  bool is_alone() const { return near_part_.empty() && !one_level_; }
  /// Boxes behind box i of the group entered that meet it, in rising order. Valid until the next call.
  std::span<const std::int32_t> find(const BoxTreeView<S>& tree, int i);
  std::size_t bytes() const {
    return (part_.capacity() + 2 * near_part_.capacity() + candidate_.capacity() + found_.capacity()) *
           sizeof(part_[0]);
  }

 private:
  template <bool moves>
  std::size_t find_moving(const BoxTreeView<S>& tree, int i);

  std::int32_t group_ = 0;
  std::vector<std::int32_t> part_;       ///< groups of boxes of groups, near the groups around
  std::vector<std::int32_t> near_part_;  ///< those of them near the group entered
  std::vector<unsigned> of_part_;        ///< the groups of each that count, one bit each
  bool one_level_ = false;
  // Room for what is found, and for a group of numbers more.
  std::vector<std::int32_t> candidate_;  ///< groups of boxes
  std::vector<std::int32_t> found_;      ///< boxes
};

}  // namespace pinball
