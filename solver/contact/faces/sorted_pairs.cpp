#include "sorted_pairs.hpp"

namespace pinball {

namespace {

std::int64_t to_pack(std::int64_t place, std::int64_t width) { return (place + width - 1) / width * width; }

}  // namespace

void SortedPairs::sort(std::int64_t firsts, std::int64_t width, bool grows) {
  std::int64_t all = 0;
  for (const PairColumns& some : found()) all += some.pairs;
  pieces.count = ListPieces::count_for(all);
  PairOrder::Begins begins{};
  for (std::int64_t p = 0; p <= pieces.count; ++p) begins[p] = firsts * p / pieces.count;
  order_.share_out(begins, pieces.count);
  const bool has_room = grows && firsts > 0;  // else there are no valid numbers to fill it with
  std::int64_t place = 0;
  for (std::int64_t p = 0; p < pieces.count; ++p) {
    const std::int64_t size = order_.pairs_of(p).size();
    pieces.begin[p] = place;
    pieces.end[p] = place + size;
    place = to_pack(place + size + (has_room ? std::max(size / 8, 2 * width) : 0), width);
  }
  pieces.places = place;
  first.resize(place);
  second.resize(place);
  next_.resize(firsts);
  parallel_for("sorted pairs", RangePolicy<>{0, pieces.count},
               [&](std::int64_t p) { sort_piece(p, begins[p], begins[p + 1]); });
  pieces.entries = 0;
  for (std::int64_t p = 0; p < pieces.count; ++p) pieces.entries += pieces.end[p] - pieces.begin[p];
}

void SortedPairs::sort_few() {
  std::vector<std::array<std::int32_t, 2>> all;
  for (const PairColumns& some : found()) {
    for (std::size_t i = 0; i < some.pairs; ++i) all.push_back({some.first[i], some.second[i]});
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  next_.clear();
  pieces = {};
  pieces.count = 1;
  pieces.end[0] = pieces.places = pieces.entries = std::ssize(all);
  first.clear();
  second.clear();
  for (const auto& [a, b] : all) {
    first.push_back(a);
    second.push_back(b);
  }
}

/// Counts, scans and fills by the first number; then few seconds are to be sorted each time.
void SortedPairs::sort_piece(std::int64_t piece, std::int32_t begin, std::int32_t end) {
  std::fill(next_.begin() + begin, next_.begin() + end, 0);
  const auto pairs = order_.pairs_of(piece);
  for (const PairOrder::Pair& pair : pairs) ++next_[pair.first];
  std::int64_t place = pieces.begin[piece];
  for (std::int32_t f = begin; f < end; ++f) place += std::exchange(next_[f], place);
  for (const PairOrder::Pair& pair : pairs) {
    const std::int64_t at = next_[pair.first]++;
    first[at] = pair.first;
    second[at] = pair.second;
  }
  std::int64_t to = pieces.begin[piece], at = to;
  for (std::int32_t f = begin; f < end; ++f) {
    const std::int64_t next = std::exchange(next_[f], to);
    if (next == at) continue;
    std::sort(second.begin() + at, second.begin() + next);
    const std::int64_t count = std::unique(second.begin() + at, second.begin() + next) - (second.begin() + at);
    std::copy_n(second.begin() + at, count, second.begin() + to);
    std::fill_n(first.begin() + to, count, f);
    to += count;
    at = next;
    next_[f] = to;
  }
  pieces.end[piece] = to;
  came_[piece] = 0;
  std::fill(first.begin() + to, first.begin() + room_end(piece), 0);
  std::fill(second.begin() + to, second.begin() + room_end(piece), 0);
}

std::int64_t SortedPairs::place_in(std::int64_t piece, std::int32_t a, std::int32_t b) const {
  std::int64_t low = pieces.begin[piece], high = pieces.end[piece];
  if (a < std::ssize(next_)) {
    // Where the number before has its last one in this piece, and not in one behind it.
    if (a > 0 && next_[a - 1] > low && next_[a - 1] < high) low = next_[a - 1];
    high = std::min(high, next_[a] + came_[piece]);
  }
  while (low < high) {
    const std::int64_t middle = (low + high) / 2;
    const bool before = std::pair(first[middle], second[middle]) < std::pair(a, b);
    (before ? low : high) = before ? middle + 1 : middle;
  }
  return low;
}

std::int64_t SortedPairs::piece_of(std::int32_t a) const {
  std::int64_t found = 0;
  for (std::int64_t piece = 1; piece < pieces.count; ++piece) {
    const std::int64_t begin = pieces.begin[piece];
    if (begin == pieces.end[piece]) continue;
    if (first[begin] > a) break;
    found = piece;
  }
  return found;
}

bool SortedPairs::has(std::int32_t a, std::int32_t b) const {
  if (pieces.count == 0) return false;
  const std::int64_t piece = piece_of(a), place = place_in(piece, a, b);
  return place < pieces.end[piece] && first[place] == a && second[place] == b;
}

std::optional<ListRoom> SortedPairs::insert(const SortedPairs& more) {
  if (pieces.count == 0) return std::nullopt;
  std::vector<std::int64_t> at;
  std::vector<PairOrder::Pair> pairs;
  std::array<std::int64_t, fixed_pieces> up_to{};
  more.for_each([&](std::int32_t a, std::int32_t b) {
    const std::int64_t piece = piece_of(a);
    at.push_back(place_in(piece, a, b));
    pairs.push_back({a, b});
    ++up_to[piece];
  });
  for (std::int64_t piece = 0; piece < pieces.count; ++piece) {
    if (up_to[piece] > room_end(piece) - pieces.end[piece]) return std::nullopt;
    if (piece > 0) up_to[piece] += up_to[piece - 1];
  }
  ListRoom room(pieces, std::move(at), up_to);
  room.make_in(first.data());
  room.make_in(second.data());
  auto next = pairs.begin();
  room.for_each_place([&](std::int64_t place) {
    first[place] = next->first;
    second[place] = next->second;
    ++next;
  });
  for (std::int64_t piece = 0; piece < pieces.count; ++piece) {
    const std::int64_t came = up_to[piece] - (piece > 0 ? up_to[piece - 1] : 0);
    pieces.end[piece] += came;
    came_[piece] += came;
  }
  pieces.entries += more.pieces.entries;
  return room;
}

void SortedPairs::persist(StateArchive& archive) {
  archive(pieces, first, second);
  if (archive.reads()) next_.clear();
}

void SortedPairs::check(const StateArchive& archive, std::size_t firsts, std::size_t seconds,
                        std::int64_t width) const {
  const std::int64_t places = pieces.places;
  archive.require(pieces.count >= 1 && pieces.count <= fixed_pieces && places >= 0 && places % width == 0);
  archive.require(std::ssize(first) == places && second.size() == first.size());
  archive.require_all(first, 0, firsts);
  archive.require_all(second, 0, seconds);
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
  return (first.capacity() + second.capacity()) * sizeof(first[0]) + order_.bytes() +
         next_.capacity() * sizeof(next_[0]);
}

}  // namespace pinball
