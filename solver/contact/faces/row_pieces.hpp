#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <kernels/exec.hpp>
#include <solver/base/lists_in_order.hpp>
#include <solver/base/piece_share.hpp>

#include "feature_row.hpp"
#include "sorted_pairs.hpp"

namespace pinball {

/// Consecutive places of a list: all pairs of their first numbers.
struct ListPart {
  std::int64_t begin, end;
  std::int64_t pairs() const { return end - begin; }
};

/// A list as it is worked: in parts, of which a process may leave some to others.
class ListShare {
 public:
  /// In its pieces, or, where these have more pairs than `most`, in parts of them; at most fixed_pieces in all.
  explicit ListShare(const SortedPairs& list, std::int64_t most = std::numeric_limits<std::int64_t>::max());

  const std::vector<ListPart>& parts() const { return parts_; }
  /// share: of the parts of several lists; it has to stay. first: number of the first part of this list among them.
  void leave_to_others(const PieceShare& share, std::int64_t first) {
    share_ = &share;
    first_ = first;
  }
  bool is_own(std::int64_t part) const { return share_ == nullptr || share_->is_own(first_ + part); }

 private:
  std::vector<ListPart> parts_;
  const PieceShare* share_ = nullptr;
  std::int64_t first_ = 0;
};

/// The rows of the pairs of a list, found in parallel in the parts of the list, and given in the order of the list.
class RowPieces {
 public:
  struct Piece {
    std::vector<std::int32_t> near;  ///< places of pairs that are near each other; with room for more
    std::vector<FeatureRow> rows;
  };

  /// Calls find(number, part, its piece) for this process' parts, whose pieces have no rows; nor have those of others.
  template <class Find>
  void find(const char* name, const ListShare& share, const Find& find) {
    count_ = std::ssize(share.parts());
    parallel_for(name, RangePolicy<>{0, count_}, [&](std::int64_t number) {
      pieces_[number].rows.clear();
      if (share.is_own(number)) find(number, share.parts()[number], pieces_[number]);
    });
  }
  /// Puts the rows that were found into a message for other processes; takes theirs, of pieces that are not this one's.
  void put_into(std::vector<std::byte>& message) const {
    for (std::int64_t number = 0; number < count_; ++number) put_list(message, pieces_[number].rows);
  }
  void take_from(std::span<const std::byte>& message, const ListShare& share) {
    std::vector<FeatureRow> rows_of_own;
    for (std::int64_t number = 0; number < count_; ++number) {
      add_list(message, share.is_own(number) ? rows_of_own : pieces_[number].rows);
    }
  }
  /// Calls visit(row) for each row in turn.
  template <class Visit>
  void for_each(const Visit& visit) {
    for (std::int64_t number = 0; number < count_; ++number) {
      for (FeatureRow& row : pieces_[number].rows) visit(row);
    }
  }
  template <class Visit>
  void for_each(const Visit& visit) const {
    for (std::int64_t number = 0; number < count_; ++number) {
      for (const FeatureRow& row : pieces_[number].rows) visit(row);
    }
  }
  /// The same for the rows of a piece, and other pieces at the same time.
  template <class Visit>
  void for_each_by_pieces(const char* name, const Visit& visit) {
    for_all_of(name, count_, numbers(), [&](std::int64_t number) {
      for (FeatureRow& row : pieces_[number].rows) visit(row);
    });
  }
  /// Takes rows out that another row makes needless.
  void erase_dropped() {
    for_all_of("rows that are kept", count_, numbers(), [&](std::int64_t number) {
      std::erase_if(pieces_[number].rows, [](const FeatureRow& row) { return row.dropped; });
    });
  }
  /// Adds the rows to lists of all, a piece after the other.
  void add_to(std::vector<std::span<const FeatureRow>>& lists) const {
    for (std::int64_t number = 0; number < count_; ++number) lists.emplace_back(pieces_[number].rows);
  }
  std::size_t bytes() const {
    std::size_t sum = 0;
    for (const Piece& piece : pieces_) {
      sum += piece.near.capacity() * sizeof(piece.near[0]) + piece.rows.capacity() * sizeof(piece.rows[0]);
    }
    return sum;
  }

 private:
  /// Of all rows.
  std::int64_t numbers() const {
    std::int64_t rows = 0;
    for (std::int64_t number = 0; number < count_; ++number) rows += std::ssize(pieces_[number].rows);
    return rows * static_cast<std::int64_t>(sizeof(FeatureRow) / sizeof(double));
  }

  std::int64_t count_ = 0;
  std::array<Piece, fixed_pieces> pieces_;
};

}  // namespace pinball
