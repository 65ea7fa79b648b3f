#include "sorted_pairs.hpp"

namespace pinball {

void SortedPairs::sort(const Found& found, std::size_t firsts, std::int64_t width) {
  const auto to_pack = [width](std::int64_t place) { return (place + width - 1) / width * width; };
  end_.assign(firsts, 0);
  pieces.entries = 0;
  for (const std::vector<Pair>& some : found) {
    for (const Pair& pair : some) ++end_[pair[0]];
    pieces.entries += static_cast<std::int64_t>(some.size());
  }
  pieces.count = ListPieces::count_for(pieces.entries);
  const auto first_of_piece = [&](std::int64_t piece) {
    return static_cast<std::int64_t>(firsts) * piece / pieces.count;
  };
  begin_.resize(firsts);
  std::int64_t place = 0;
  for (std::int64_t piece = 0; piece < pieces.count; ++piece) {
    pieces.begin[piece] = place = to_pack(place);
    for (std::int64_t f = first_of_piece(piece); f < first_of_piece(piece + 1); ++f) {
      const std::int64_t count = end_[f];
      begin_[f] = end_[f] = place;
      place += count;
    }
    pieces.end[piece] = place;
  }
  pieces.places = to_pack(place);
  first.assign(static_cast<std::size_t>(pieces.places), 0);
  second.assign(static_cast<std::size_t>(pieces.places), 0);
  for (const std::vector<Pair>& some : found) {
    for (const Pair& pair : some) {
      const std::int64_t at = end_[pair[0]]++;
      first[at] = pair[0];
      second[at] = pair[1];
    }
  }
  for (std::int64_t piece = 0; piece < pieces.count; ++piece) {
    std::int64_t to = pieces.begin[piece];
    for (std::int64_t at = to, next = to; at < pieces.end[piece]; at = next) {
      const std::int32_t number = first[at];
      next = end_[number];
      std::sort(second.begin() + at, second.begin() + next);
      const std::int64_t count = std::unique(second.begin() + at, second.begin() + next) - (second.begin() + at);
      std::copy_n(second.begin() + at, count, second.begin() + to);
      std::fill_n(first.begin() + to, count, number);
      begin_[number] = to;
      end_[number] = to += count;
    }
    pieces.entries -= pieces.end[piece] - to;
    pieces.end[piece] = to;
  }
}

bool SortedPairs::has(const Pair& pair) const {
  return std::binary_search(second.begin() + begin_[pair[0]], second.begin() + end_[pair[0]], pair[1]);
}

void SortedPairs::give_back(Found& found) const {
  for (std::vector<Pair>& some : found) some.clear();
  for (std::int64_t piece = 0; piece < pieces.count; ++piece) {
    for (std::int64_t at = pieces.begin[piece]; at < pieces.end[piece]; ++at)
      found[0].push_back({first[at], second[at]});
  }
}

void SortedPairs::check(const StateArchive& archive, std::size_t firsts, std::size_t seconds,
                        std::int64_t width) const {
  const std::int64_t places = pieces.places;
  archive.require(pieces.count >= 1 && pieces.count <= fixed_pieces && places >= 0 && places % width == 0);
  archive.require(first.size() == static_cast<std::size_t>(places) && second.size() == first.size());
  archive.require(begin_.size() == firsts && end_.size() == firsts);
  archive.require_all(first, 0, static_cast<std::int64_t>(firsts));
  archive.require_all(second, 0, static_cast<std::int64_t>(seconds));
  archive.require_all(begin_, 0, places + 1);
  archive.require_all(end_, 0, places + 1);
  for (std::size_t f = 0; f < firsts; ++f) archive.require(begin_[f] <= end_[f]);
  std::int64_t before = 0, entries = 0;
  for (std::int64_t piece = 0; piece < pieces.count; ++piece) {
    const std::int64_t begin = pieces.begin[piece], end = pieces.end[piece];
    archive.require(begin >= before && begin % width == 0 && end >= begin && end <= places);
    before = end;
    entries += end - begin;
  }
  archive.require(entries == pieces.entries);
}

std::size_t SortedPairs::bytes() const {
  return (first.capacity() + second.capacity()) * sizeof(first[0]) +
         (begin_.capacity() + end_.capacity()) * sizeof(begin_[0]);
}

}  // namespace pinball
