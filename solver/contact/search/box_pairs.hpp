#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <kernels/exec.hpp>
#include <solver/base/piece_share.hpp>
#include <solver/contact/contact_settings.hpp>

#include "box_hash.hpp"
#include "box_tree.hpp"
#include "moving_boxes.hpp"
#include "near_cells.hpp"
#include "pair_order.hpp"

namespace pinball {

/// The pairs of moving boxes that meet: that overlap at the beginning or at the end, or along each axis are not on the
/// same side of each other at both. Each pair once, its lower number first, sorted by the first and then by the second.
///
/// For work in parallel the list comes in fixed_pieces: consecutive boxes, and the pairs of which they are the first.
/// Boxes that are near each other should have near numbers, as in the tiles of a mesh.
template <class S>
class BoxPairs {
 public:
  /// Builds the list from nothing; the same from every search and every number of threads. keep(first, second): whether
  /// a pair is wanted; asked only for pairs that meet, in parallel. directions: of the groups of boxes, or null; pairs
  /// of those that have nothing with each other may be left out, too. share: of fixed_pieces of the boxes: pairs that
  /// are found in another process' pieces are not in the list.
  template <class Keep>
  void find(const MovingBoxes<S>& boxes, ContactSearch how, const Keep& keep,
            const GroupDirections<S>* directions = nullptr, const PieceShare& share = PieceShare());

  /// First boxes of the pairs of a piece, and as many second ones. Valid until the next find().
  std::span<const std::int32_t> firsts(std::int64_t piece) const { return sorted_[piece].firsts(); }
  std::span<const std::int32_t> seconds(std::int64_t piece) const { return sorted_[piece].seconds(); }
  /// First box of a piece; that of piece `fixed_pieces` is the number of boxes.
  std::int32_t piece_begin(std::int64_t piece) const { return begins_[piece]; }
  std::int64_t pairs() const;
  /// Has for_each_meeting() look in these boxes, which are those of the last find() and stay where they are.
  void prepare_to_look_up(const MovingBoxes<S>& boxes);
  /// Box i of these boxes has become another.
  void include(const MovingBox<S>& box, std::int32_t i) {
    if (has_tree_) tree_.include(box, i);
  }
  /// The groups of boxes among which all are that meet some of these, in rising order.
  void find_groups(std::span<const MovingBox<S>> boxes, std::vector<std::int32_t>& groups) const;
  /// Calls visit(number) for the boxes of a group that meet this one, in rising order.
  template <class Visit>
  void for_each_meeting(std::int32_t group, const MovingBox<S>& box, const Visit& visit) const {
    unsigned bits = meeting_boxes<Pack<S, native_width<S>>>(tree_.view().boxes(0, group), box);
    for (; bits != 0; bits &= bits - 1) visit(group * ball_group<S> + lowest_bit(bits));
  }
  std::size_t bytes() const;

 private:
  void cut_into_pieces(const MovingBoxes<S>& boxes);
  /// The search to be used; has built the tree if it is that.
  ContactSearch choose(const MovingBoxes<S>& boxes, ContactSearch how);
  template <class Keep>
  void find_by_tree(const Keep& keep, const GroupDirections<S>* directions, const PieceShare& share);
  template <class Keep>
  void find_by_hash(const Keep& keep, const PieceShare& share);

  std::array<std::int32_t, fixed_pieces + 1> begins_{};
  PairOrder::Pieces sorted_;
  BoxTree<S> tree_;
  bool has_tree_ = false;  ///< it is of the boxes of the last find()
  // What follows is kept for its memory alone.
  std::array<NearBoxes<S>, fixed_pieces> near_;
  BoxHash<S> hash_;
  std::array<NearCells<S>, fixed_pieces> cells_;
  PairOrder order_;
};

template <class S>
template <class Keep>
void BoxPairs<S>::find(const MovingBoxes<S>& boxes, ContactSearch how, const Keep& keep,
                       const GroupDirections<S>* directions, const PieceShare& share) {
  cut_into_pieces(boxes);
  if (choose(boxes, how) == ContactSearch::hash) {
    hash_.build(boxes);
    find_by_hash(keep, share);
    order_.sort(begins_, sorted_);
  } else {
    find_by_tree(keep, directions, share);
  }
}

/// No branch depends on what is kept. Most groups of surfaces that nothing comes near have no others.
template <class S>
template <class Keep>
void BoxPairs<S>::find_by_tree(const Keep& keep, const GroupDirections<S>* directions, const PieceShare& share) {
  constexpr int G = ball_group<S>;
  parallel_for("pairs by a tree", RangePolicy<>{0, fixed_pieces}, [&](std::int64_t piece) {
    PairColumns& found = sorted_[piece];
    NearBoxes<S>& near = near_[piece];
    found.pairs = 0;
    if (!share.is_own(piece)) return;
    const std::int32_t begin = piece_begin(piece), end = piece_begin(piece + 1);
    for (std::int32_t own = begin; own < end; ++own) {
      if (own % G == 0) near.enter(tree_.view(), own / G, own == begin, directions);
      if (near.is_alone()) continue;
      const auto others = near.find(tree_.view(), own % G);
      found.make_room(others.size());
      const std::size_t before = found.pairs;
      for (const std::int32_t other : others) {
        found.second[found.pairs] = other;
        found.pairs += keep(own, other) ? 1 : 0;
      }
      std::fill(found.first.data() + before, found.first.data() + found.pairs, own);
    }
  });
}

/// The same here; a box may be the second of its pairs, too.
template <class S>
template <class Keep>
void BoxPairs<S>::find_by_hash(const Keep& keep, const PieceShare& share) {
  parallel_for("pairs by a hash", RangePolicy<>{0, fixed_pieces}, [&](std::int64_t piece) {
    PairColumns& found = order_.found()[piece];
    NearCells<S>& cells = cells_[piece];
    found.pairs = 0;
    if (!share.is_own(piece)) return;
    for (std::int32_t number = piece_begin(piece); number < piece_begin(piece + 1); ++number) {
      if (hash_.cell_begin(number) < 0) continue;
      cells.enter(hash_, hash_.cell_begin(number));
      for (std::int32_t i = 0; i < cells.size(); ++i) {
        const std::int32_t own = cells.number(i);
        const auto others = cells.find(hash_, i);
        found.make_room(others.size());
        for (const std::int32_t other : others) {
          const std::int32_t first = std::min(own, other), second = std::max(own, other);
          found.first[found.pairs] = first;
          found.second[found.pairs] = second;
          found.pairs += keep(first, second) ? 1 : 0;
        }
      }
    }
  });
}

}  // namespace pinball
