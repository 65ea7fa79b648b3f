#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "box_hash.hpp"

namespace pinball {

/// What meets the boxes of a cell of a hash. Its memory serves many cells, one after the other.
template <class S>
class NearCells {
 public:
  /// Takes the boxes of the cell that begins at `first` in the hash, and what may meet them: boxes of the cells of
  /// their level that follow theirs, so that each pair is found from one side, and of all coarser ones.
  void enter(const BoxHash<S>& hash, std::int32_t first);
  std::int32_t size() const { return size_; }  ///< boxes of the cell
  std::int32_t number(std::int32_t i) const { return near_[i].number(); }
  /// Boxes that meet box i of the cell, and those of the cell behind it; in any order. Valid until the next call.
  std::span<const std::int32_t> find(const BoxHash<S>& hash, std::int32_t i);
  std::size_t bytes() const { return near_.capacity() * sizeof(HashBox) + found_.capacity() * sizeof(found_[0]); }

 private:
  void add(const SpatialHashView& hash, const HashCell& cell);
  void add_level(const SpatialHashView& hash, const HashCell& own);
  void add_coarser(const SpatialHashView& hash, std::int32_t level);
  /// Of the numbers found those that meet a box; returns how many.
  template <bool moves>
  std::size_t leave_out(const BoxHash<S>& hash, const MovingBox<S>& own, std::size_t found);

  HashBoxLimits limits_{};  ///< of all boxes of the cell together
  std::size_t size_ = 0, near_end_ = 0;
  std::vector<HashBox> near_;  ///< those of the cell come first; with room for more
  std::vector<std::int32_t> found_;
};

}  // namespace pinball
