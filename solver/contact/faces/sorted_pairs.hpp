#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <kernels/exec.hpp>
#include <solver/base/state_archive.hpp>

namespace pinball {

/// Places of a list in pieces, each of which begins at a whole pack: between the end of a piece and the beginning of
/// the next there are places that name valid things and do not count. A short list has few pieces, so that packs are
/// full.
struct ListPieces {
  static std::int64_t count_for(std::int64_t entries) {
    return std::clamp<std::int64_t>(entries / 2048, 1, fixed_pieces);
  }
  std::int64_t count = 0;  ///< of pieces
  std::array<std::int64_t, fixed_pieces> begin{}, end{};
  std::int64_t places = 0;   ///< with those between
  std::int64_t entries = 0;  ///< without
};

/// Pairs of numbers, each once, sorted by their first and then by their second: what is made of them comes in an order
/// that does not depend on what else is listed, nor on when and how the list was made.
struct SortedPairs {
  using Pair = std::array<std::int32_t, 2>;
  using Found = std::array<std::vector<Pair>, fixed_pieces>;  ///< as found in parallel, in any order

  ListPieces pieces;  ///< of consecutive firsts
  std::vector<std::int32_t> first, second;

  /// found: may have a pair several times; firsts: numbers that a first may have; width: of a pack.
  void sort(const Found& found, std::size_t firsts, std::int64_t width);
  bool has(const Pair& pair) const;
  /// The pairs as if they had been found so.
  void give_back(Found& found) const;
  void persist(StateArchive& archive) { archive(pieces, first, second, begin_, end_); }
  /// Of a list that was read, and holds: that it is one of as many firsts and seconds.
  void check(const StateArchive& archive, std::size_t firsts, std::size_t seconds, std::int64_t width) const;
  std::size_t bytes() const;

 private:
  std::vector<std::int64_t> begin_, end_;  // places of each first
};

}  // namespace pinball
