#include "near_cells.hpp"

#include <algorithm>

namespace pinball {

namespace {

/// Whether boxes meet, as meeting_boxes has it (kernels/ball_tree.hpp).
template <class S, bool moves>
bool boxes_meet(const MovingBox<S>& a, const MovingBox<S>& b) {
  bool meet = true;
  for (int k = 0; k < 3; ++k) {
    if constexpr (moves) {
      meet &= (a.bound[k] <= b.bound[3 + k]) | (a.bound[6 + k] <= b.bound[9 + k]);
      meet &= (a.bound[3 + k] >= b.bound[k]) | (a.bound[9 + k] >= b.bound[6 + k]);
    } else {
      meet &= (a.bound[k] <= b.bound[3 + k]) & (a.bound[3 + k] >= b.bound[k]);
    }
  }
  return meet;
}

}  // namespace

template <class S>
void NearCells<S>::enter(const BoxHash<S>& hash, std::int32_t first) {
  const SpatialHashView& view = hash.view();
  const HashCell cell = cell_of(view.box[first]);
  std::int32_t next = first + 1;
  while (next < hash.size() && is_in_cell(view.box[next], cell)) ++next;
  size_ = near_end_ = next - first;
  if (near_.size() < size_ + 1) near_.resize(2 * size_ + 64);
  std::copy(view.box + first, view.box + next, near_.begin());
  limits_ = limits_of(near_[0]);
  for (std::size_t i = 1; i < size_; ++i) {
    const HashBoxLimits other = limits_of(near_[i]);
    for (int c = 0; c < 8; ++c) limits_.value[c] = std::max(limits_.value[c], other.value[c]);
  }
  add_level(view, cell);
  for (std::uint32_t coarser = view.levels >> cell.level >> 1 << cell.level << 1; coarser != 0;
       coarser &= coarser - 1) {
    add_coarser(view, __builtin_ctz(coarser));
  }
  if (found_.size() < near_end_ + 1) found_.resize(2 * near_end_);
}

template <class S>
void NearCells<S>::add(const SpatialHashView& hash, const HashCell& cell) {
  const std::uint32_t bucket = bucket_of(cell, hash.bits);
  const std::size_t most = hash.bucket_start[bucket + 1] - hash.bucket_start[bucket];
  if (near_.size() < near_end_ + most + 1) near_.resize(2 * (near_end_ + most) + 64);
  const HashBox* const end = copy_cell(hash, bucket, cell, limits_, near_.data() + near_end_);
  near_end_ = end - near_.data();
}

/// Cells of the same level that follow by their third, second and first coordinate. Boxes reach into the next cell at
/// most.
template <class S>
void NearCells<S>::add_level(const SpatialHashView& hash, const HashCell& own) {
  std::int32_t last[3];
  for (int k = 0; k < 3; ++k) last[k] = in_cells(limits_.value[k], own.level);
  const std::int32_t x = own.at[0], y = own.at[1], z = own.at[2];
  for (std::int32_t k = z; k <= last[2]; ++k) {
    for (std::int32_t j = k == z ? y : std::max(0, y - 1); j <= last[1]; ++j) {
      for (std::int32_t i = k == z && j == y ? x + 1 : std::max(0, x - 1); i <= last[0]; ++i) {
        add(hash, {own.level, {i, j, k}});
      }
    }
  }
}

template <class S>
void NearCells<S>::add_coarser(const SpatialHashView& hash, std::int32_t level) {
  std::int32_t first[3], last[3];
  for (int k = 0; k < 3; ++k) {
    first[k] = std::max(0, in_cells(-limits_.value[3 + k], level) - 1);
    last[k] = in_cells(limits_.value[k], level);
  }
  for (std::int32_t k = first[2]; k <= last[2]; ++k) {
    for (std::int32_t j = first[1]; j <= last[1]; ++j) {
      for (std::int32_t i = first[0]; i <= last[0]; ++i) add(hash, {level, {i, j, k}});
    }
  }
}

template <class S>
template <bool moves>
std::size_t NearCells<S>::leave_out(const BoxHash<S>& hash, const MovingBox<S>& own, std::size_t found) {
  std::size_t kept = 0;
  for (std::size_t f = 0; f < found; ++f) {
    const std::int32_t other = found_[f];
    found_[kept] = other;
    kept += boxes_meet<S, moves>(own, hash.box(other)) ? 1 : 0;
  }
  return kept;
}

/// No loop has a branch that depends on what is found.
template <class S>
std::span<const std::int32_t> NearCells<S>::find(const BoxHash<S>& hash, std::int32_t i) {
  const HashBox& own = near_[i];
  const HashBoxLimits limits = limits_of(own);
  std::int32_t* end = found_.data();
  for (std::size_t n = i + 1; n < near_end_; ++n) {
    *end = near_[n].number();
    end += meets(near_[n], limits) ? 1 : 0;
  }
  const std::size_t found = end - found_.data();
  const MovingBox<S>& box = hash.box(own.number());
  return {found_.data(), hash.moves() ? leave_out<true>(hash, box, found) : leave_out<false>(hash, box, found)};
}

template class NearCells<double>;
template class NearCells<float>;

}  // namespace pinball
