#pragma once

#include <algorithm>
#include <cstdint>

#include <kernels/exec.hpp>

namespace pinball {

/// Rows from which on threads gain more by sharing a loop than they lose by waiting for each other.
inline constexpr std::int32_t rows_to_share = 1024;

/// Loops over rows and nodes, of an island or of all: of one thread, or shared by all, with the same bits, because sums
/// are cut into pieces by their length alone, and because the machine code is the same (RangeOf).
class IslandLoops {
 public:
  explicit IslandLoops(bool shared) : shared_(shared) {}

  template <class Body>
  void for_each(std::int32_t begin, std::int32_t end, const Body& body) const {
    const RangeOf<Body> work{body};
    if (shared_) {
      work_in_parts(begin, end, &RangeOf<Body>::work, &work);
    } else {
      RangeOf<Body>::work(&work, begin, end);
    }
  }
  /// body(i, partial) for all i; partial results begin as Sum{} and are joined in order by join(const Sum&).
  template <class Sum, class Body>
  Sum reduce(std::int32_t begin, std::int32_t end, const Body& body) const {
    const std::int32_t pieces = std::clamp((end - begin) / rows_of_a_piece, 1, most_pieces);
    if (pieces == 1) {
      Sum sum;
      for_pieces(Pieces<Sum, Body>{begin, end, 1, &sum, body});
      return sum;
    }
    Sum partial[most_pieces];
    for_pieces(Pieces<Sum, Body>{begin, end, pieces, partial, body});
    for (std::int32_t p = 1; p < pieces; ++p) partial[0].join(partial[p]);
    return partial[0];
  }

 private:
  static constexpr std::int32_t rows_of_a_piece = 256, most_pieces = 64;

  template <class Sum, class Body>
  struct Pieces {
    std::int32_t begin, end, pieces;
    Sum* partial;
    const Body& body;
    void operator()(std::int64_t p) const {
      const std::int64_t count = end - begin;
      Sum sum;
      for (std::int64_t i = begin + count * p / pieces; i < begin + count * (p + 1) / pieces; ++i) body(i, sum);
      partial[p] = sum;
    }
  };
  template <class Sum, class Body>
  void for_pieces(const Pieces<Sum, Body>& pieces) const {
    for_each(0, pieces.pieces, pieces);
  }

  bool shared_;
};

}  // namespace pinball
