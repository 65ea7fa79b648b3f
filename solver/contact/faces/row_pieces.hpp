#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <kernels/exec.hpp>
#include <solver/base/lists_in_order.hpp>

#include "feature_row.hpp"

namespace pinball {

/// The rows of the pairs of a list, found in parallel in the pieces of the list, and given in the order of the list.
class RowPieces {
 public:
  struct Piece {
    std::vector<std::int32_t> near;  ///< places of pairs that are near each other; with room for more
    std::vector<FeatureRow> rows;
  };

  /// Calls find(piece number, piece) for pieces without rows.
  template <class Find>
  void find(const char* name, std::int64_t pieces, const Find& find) {
    count_ = pieces;
    parallel_for(name, RangePolicy<>{0, pieces}, [&](std::int64_t number) {
      pieces_[number].rows.clear();
      find(number, pieces_[number]);
    });
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
  template <class S>
  void give_to(ImpulseSolver<S>& impulses) const {
    for_each([&](const FeatureRow& row) { row.give_to(impulses); });
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
