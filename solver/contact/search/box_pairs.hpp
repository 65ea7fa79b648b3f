#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <kernels/exec.hpp>
#include <solver/contact/contact_settings.hpp>

#include "box_tree.hpp"
#include "moving_boxes.hpp"

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
  /// a pair is wanted; asked only for pairs that meet, in parallel.
  template <class Keep>
  void find(const MovingBoxes<S>& boxes, ContactSearch how, const Keep& keep);

  /// First boxes of the pairs of a piece, and as many second ones. Valid until the next find().
  std::span<const std::int32_t> firsts(std::int64_t piece) const { return found_[piece].firsts(); }
  std::span<const std::int32_t> seconds(std::int64_t piece) const { return found_[piece].seconds(); }
  /// First box of a piece; that of piece `fixed_pieces` is the number of boxes.
  std::int32_t piece_begin(std::int64_t piece) const;
  std::int64_t pairs() const;
  std::size_t bytes() const;

 private:
  /// Pairs one after the other, with room for more.
  struct Found {
    std::vector<std::int32_t> first, second;
    std::size_t pairs = 0;

    std::span<const std::int32_t> firsts() const { return {first.data(), pairs}; }
    std::span<const std::int32_t> seconds() const { return {second.data(), pairs}; }
    void make_room(std::size_t more);
    /// Appends the pairs of a box with others that are kept.
    template <class Keep>
    void append(std::int32_t own, std::span<const std::int32_t> others, const Keep& keep);
  };
  template <class Keep>
  void find_by_tree(const Keep& keep);

  std::int32_t count_ = 0;
  std::int64_t groups_ = 0;
  std::array<Found, fixed_pieces> found_;
  // What follows is kept for its memory alone.
  BoxTree<S> tree_;
  std::array<NearBoxes<S>, fixed_pieces> near_;
};

template <class S>
template <class Keep>
void BoxPairs<S>::find(const MovingBoxes<S>& boxes, ContactSearch /*how*/, const Keep& keep) {
  count_ = boxes.count();
  groups_ = boxes.groups();
  tree_.build(boxes);
  find_by_tree(keep);
}

template <class S>
template <class Keep>
void BoxPairs<S>::find_by_tree(const Keep& keep) {
  constexpr int G = ball_group<S>;
  parallel_for("pairs of boxes", RangePolicy<>{0, fixed_pieces}, [&](std::int64_t piece) {
    Found& found = found_[piece];
    NearBoxes<S>& near = near_[piece];
    found.pairs = 0;
    const std::int32_t begin = piece_begin(piece), end = piece_begin(piece + 1);
    for (std::int32_t own = begin; own < end; ++own) {
      if (own % G == 0) near.enter(tree_.view(), own / G, own == begin);
      found.append(own, near.find(tree_.view(), own % G), keep);
    }
  });
}

/// No branch depends on what is kept.
template <class S>
template <class Keep>
void BoxPairs<S>::Found::append(std::int32_t own, std::span<const std::int32_t> others, const Keep& keep) {
  make_room(others.size());
  std::int32_t* const begin = second.data() + pairs;
  std::int32_t* end = begin;
  for (const std::int32_t other : others) {
    *end = other;
    end += keep(own, other) ? 1 : 0;
  }
  std::fill(first.data() + pairs, first.data() + pairs + (end - begin), own);
  pairs += static_cast<std::size_t>(end - begin);
}

}  // namespace pinball
