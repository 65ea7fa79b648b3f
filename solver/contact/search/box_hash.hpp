#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <kernels/exec.hpp>
#include <kernels/spatial_hash.hpp>

#include "moving_boxes.hpp"

namespace pinball {

/// Hash of moving boxes (kernels/spatial_hash.hpp), built anew for each set in the same memory. It holds what each box
/// sweeps over from the beginning to the end, seen by somebody who moves with the middle one of them.
///
/// Built by counting, scanning and filling: the order of the result never depends on timing.
template <class S>
class BoxHash {
 public:
  void build(const MovingBoxes<S>& boxes);
  const SpatialHashView& view() const { return view_; }
  /// Where the boxes of a cell begin in the view, for the one of them with the lowest number; else -1. So that cells
  /// can be taken in the order of numbers: near ones are then near in time, and still in the caches.
  std::int32_t cell_begin(std::int32_t number) const { return cell_begin_[number]; }
  std::int32_t size() const { return piece_start_.back(); }  ///< boxes in the view
  bool moves() const { return moves_; }
  const MovingBox<S>& box(std::int32_t number) const { return bounds_[number]; }
  std::size_t bytes() const;

 private:
  std::size_t buckets_of_piece() const { return (std::size_t(1) << view_.bits) / fixed_pieces; }
  void choose_grid(const MovingBoxes<S>& boxes);
  /// Box in units.
  HashBox hash_box(const MovingBox<S>& box, std::int32_t number) const;
  void make_boxes(const MovingBoxes<S>& boxes);
  void sort_into_pieces(std::int32_t count);
  void sort_piece(std::int64_t piece);

  SpatialHashView view_{};
  std::array<S, 3> way_{};  ///< of who looks on [length]
  bool moves_ = false;      ///< some box is not the same at the beginning and at the end
  std::vector<std::int32_t> bucket_start_, cell_begin_;
  Array<HashBox> box_;
  Array<MovingBox<S>> bounds_;  ///< per number: side by side
  /// In pieces of numbers, of each for each piece of buckets: how many boxes, then where the next one goes.
  std::array<std::array<std::int32_t, fixed_pieces>, fixed_pieces> place_{};
  std::array<std::int32_t, fixed_pieces + 1> piece_start_{};
  struct Member {
    std::int32_t number;
    std::uint32_t bucket;
  };
  Array<HashBox> made_;                ///< per number
  std::vector<std::uint32_t> bucket_;  ///< per number; no_bucket for what is in none
  Array<Member> member_;               ///< by piece of buckets
};

}  // namespace pinball
