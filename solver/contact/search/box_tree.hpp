#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <kernels/ball_tree.hpp>
#include <solver/contact/contact_settings.hpp>

#include "moving_boxes.hpp"

namespace pinball {

/// Levels of boxes over moving boxes, which are the lowest level themselves.
template <class S>
class BoxTree {
 public:
  /// boxes: have to stay where they are while the tree is used.
  void build(const MovingBoxes<S>& boxes);
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

/// What meets the boxes of a group. Its memory serves many groups, one after the other.
template <class S>
class NearBoxes {
 public:
  static constexpr int G = ball_group<S>;
  /// Takes the groups, from this one on, whose boxes may meet those of this group. Groups are to be entered in rising
  /// order; after a jump with `anew`.
  void enter(const BoxTreeView<S>& tree, std::int32_t group, bool anew);
  /// Boxes behind box i of the group entered that meet it, in rising order. Valid until the next call.
  std::span<const std::int32_t> find(const BoxTreeView<S>& tree, int i);
  std::size_t bytes() const {
    return (part_.capacity() + near_part_.capacity() + candidate_.capacity() + found_.capacity()) * sizeof(part_[0]);
  }

 private:
  template <bool moves>
  std::size_t find_moving(const BoxTreeView<S>& tree, int i);

  std::int32_t group_ = 0;
  std::vector<std::int32_t> part_;       ///< groups of boxes of groups, near the groups around
  std::vector<std::int32_t> near_part_;  ///< those of them near the group entered
  // Room for what is found, and for a group of numbers more.
  std::vector<std::int32_t> candidate_;  ///< groups of boxes
  std::vector<std::int32_t> found_;      ///< boxes
};

}  // namespace pinball
