#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <kernels/exec.hpp>
#include <solver/base/piece_share.hpp>

namespace pinball {

/// Pairs of numbers one after the other, with room for more.
struct PairColumns {
  std::vector<std::int32_t> first, second;
  std::size_t pairs = 0;

  void add(std::int32_t a, std::int32_t b) {
    make_room(1);
    first[pairs] = a;
    second[pairs] = b;
    ++pairs;
  }
  std::span<const std::int32_t> firsts() const { return {first.data(), pairs}; }
  std::span<const std::int32_t> seconds() const { return {second.data(), pairs}; }
  void make_room(std::size_t more) {
    if (pairs + more <= second.size()) return;
    first.resize(std::max(pairs + more, 2 * second.size()));
    second.resize(first.size());
  }
  /// For what other processes find (PieceShare): puts these into a message, adds those of one.
  void put_into(std::vector<std::byte>& message) const {
    put_count(message, pairs);
    put(message, firsts());
    put(message, seconds());
  }
  void add_from(std::span<const std::byte>& message) {
    const std::size_t more = get_count(message);
    make_room(more);
    get(message, std::span(first).subspan(pairs, more));
    get(message, std::span(second).subspan(pairs, more));
    pairs += more;
  }
  std::size_t bytes() const { return (first.capacity() + second.capacity()) * sizeof(first[0]); }
};

/// Brings pairs that were found in any order, in fixed_pieces, into the order of their first and second numbers.
class PairOrder {
 public:
  using Pieces = std::array<PairColumns, fixed_pieces>;
  using Begins = std::array<std::int32_t, fixed_pieces + 1>;
  struct Pair {
    std::int32_t first, second;
  };
  /// Pairs as they are found: to be filled, its piece by each piece of the work.
  Pieces& found() { return found_; }
  /// Sorts what was found into pieces by the first number. begins: first number of each piece, and where the last ends.
  void sort(const Begins& begins, Pieces& sorted);
  /// Shares out what was found among `count` pieces, in each of which they have any order: pairs_of().
  void share_out(const Begins& begins, std::int64_t count);
  std::span<const Pair> pairs_of(std::int64_t piece) const {
    const auto p = static_cast<std::size_t>(piece);
    return {pair_.data() + piece_start_[p], piece_start_[p + 1] - piece_start_[p]};
  }
  std::size_t bytes() const;

 private:
  void sort_piece(std::int64_t piece, std::int32_t begin, std::int32_t end, PairColumns& sorted);

  Pieces found_;
  /// In pieces of what was found, of each for each piece of the result: how many pairs, then where the next one goes.
  std::array<std::array<std::size_t, fixed_pieces>, fixed_pieces> place_{};
  std::array<std::size_t, fixed_pieces + 1> piece_start_{};
  Array<Pair> pair_;                                           ///< in the order of the pieces of the result
  std::array<std::vector<std::int32_t>, fixed_pieces> start_;  ///< per first number of a piece
};

}  // namespace pinball
