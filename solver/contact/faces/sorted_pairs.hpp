#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <kernels/exec.hpp>
#include <solver/base/state_archive.hpp>
#include <solver/contact/search/pair_order.hpp>

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

/// Room that was made in a list for more pairs. The last ones of each piece have moved up.
class ListRoom {
 public:
  /// at: places, ascending, before whose pairs the new ones come, of list piece after list piece; new_ones: how many
  /// there are up to the end of each piece.
  ListRoom(const ListPieces& pieces, std::vector<std::int64_t> at,
           const std::array<std::int64_t, fixed_pieces>& new_ones)
      : pieces_(pieces), at_(std::move(at)), new_ones_(new_ones) {}

  /// Makes the room in an array along the list.
  template <class T>
  void make_in(T* values) const {
    parallel_for("room in a list", RangePolicy<>{0, pieces_.count}, [&](std::int64_t piece) {
      std::int64_t end = pieces_.end[piece];
      for (std::int64_t j = new_ones_[piece]; j-- > first_of(piece);) {
        std::copy_backward(values + at_[j], values + end, values + end + j + 1 - first_of(piece));
        end = at_[j];
      }
    });
  }
  /// Calls work(place) for each new pair, in their order.
  template <class Work>
  void for_each_place(const Work& work) const {
    for (std::int64_t piece = 0; piece < pieces_.count; ++piece) {
      for (std::int64_t j = first_of(piece); j < new_ones_[piece]; ++j) work(at_[j] + j - first_of(piece));
    }
  }

 private:
  std::int64_t first_of(std::int64_t piece) const { return piece == 0 ? 0 : new_ones_[piece - 1]; }

  ListPieces pieces_;
  std::vector<std::int64_t> at_;
  std::array<std::int64_t, fixed_pieces> new_ones_;
};

/// Pairs of numbers, each once, sorted by their first and then by their second: what is made of them comes in an order
/// that does not depend on what else is listed, nor on when and how the list was made.
class SortedPairs {
 public:
  ListPieces pieces;  ///< of consecutive firsts
  std::vector<std::int32_t> first, second;

  /// Pairs as they are found, in parallel and in any order, some several times: to be filled before sort(), its piece
  /// by each piece of the work.
  PairOrder::Pieces& found() { return order_.found(); }
  /// Makes the list of what was found. firsts: numbers that a first may have; width: of a pack; grows: each piece is to
  /// have room for more.
  void sort(std::int64_t firsts, std::int64_t width, bool grows = false);
  /// The same of a few pairs, in one piece without room.
  void sort_few();
  bool has(std::int32_t a, std::int32_t b) const;
  /// Takes in pairs that the list does not have; arrays along it are to get the same room by make_in(). Nothing: where
  /// there is no room for them, and then nothing has changed.
  std::optional<ListRoom> insert(const SortedPairs& more);
  /// Calls work(first, second) for each pair, in their order.
  template <class Work>
  void for_each(const Work& work) const {
    for (std::int64_t piece = 0; piece < pieces.count; ++piece) {
      for (std::int64_t at = pieces.begin[piece]; at < pieces.end[piece]; ++at) work(first[at], second[at]);
    }
  }
  void persist(StateArchive& archive);
  /// Of a list that was read, and holds: that it is one of as many firsts and seconds.
  void check(const StateArchive& archive, std::size_t firsts, std::size_t seconds, std::int64_t width) const;
  std::size_t bytes() const;

 private:
  void sort_piece(std::int64_t piece, std::int32_t begin, std::int32_t end);
  /// Where the room of a piece ends.
  std::int64_t room_end(std::int64_t piece) const {
    return piece + 1 < pieces.count ? pieces.begin[piece + 1] : pieces.places;
  }
  /// That has, or is to have, all pairs of this first number.
  std::int64_t piece_of(std::int32_t a) const;
  /// Place of the first pair of a piece that does not come before this one.
  std::int64_t place_in(std::int64_t piece, std::int32_t a, std::int32_t b) const;

  PairOrder order_;
  /// Per first: where its next pair goes, and in the end where its pairs ended when the list was made; empty: not
  /// known.
  std::vector<std::int64_t> next_;
  std::array<std::int64_t, fixed_pieces> came_{};  ///< pairs that each piece has taken in since
};

}  // namespace pinball
