#include "row_pieces.hpp"

#include <algorithm>

namespace pinball {

/// The pairs of a number are all in one part.
ListShare::ListShare(const SortedPairs& list, std::int64_t most) {
  const std::int64_t most_of_piece = fixed_pieces / std::max<std::int64_t>(1, list.pieces.count);
  for (std::int64_t piece = 0; piece < list.pieces.count; ++piece) {
    const std::int64_t begin = list.pieces.begin[piece], end = list.pieces.end[piece];
    const std::int64_t count = std::clamp<std::int64_t>((end - begin) / most, 1, most_of_piece);
    std::int64_t from = begin;
    for (std::int64_t part = 1; part < count; ++part) {
      std::int64_t to = std::max(from + 1, begin + (end - begin) * part / count);
      while (to < end && list.first[to] == list.first[to - 1]) ++to;
      if (to >= end) break;
      parts_.push_back({from, to});
      from = to;
    }
    parts_.push_back({from, end});
  }
}

}  // namespace pinball
