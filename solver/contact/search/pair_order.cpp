#include "pair_order.hpp"

namespace pinball {

void PairOrder::share_out(const Begins& begins, std::int64_t count) {
  const std::size_t pieces = count;
  const double pieces_per_number = static_cast<double>(count) / std::max(1, begins[pieces]);
  const auto piece_of = [&](std::int32_t first) -> std::size_t {
    if (pieces == 1) return 0;
    auto piece = static_cast<std::size_t>(pieces_per_number * first);
    while (begins[piece] > first) --piece;
    while (begins[piece + 1] <= first) ++piece;
    return piece;
  };
  const auto for_each_pair = [&](std::int64_t piece, const auto& visit) {
    const auto firsts = found_[piece].firsts();
    for (std::size_t i = 0; i < firsts.size(); ++i) visit(i, piece_of(firsts[i]));
  };
  parallel_for("pieces of pairs", RangePolicy<>{0, fixed_pieces}, [&](std::int64_t piece) {
    std::array<std::size_t, fixed_pieces> places{};
    for_each_pair(piece, [&](std::size_t, std::size_t to) { ++places[to]; });
    place_[piece] = places;
  });
  std::size_t next = 0;
  for (std::size_t to = 0; to < pieces; ++to) {
    piece_start_[to] = next;
    for (auto& of_found : place_) {
      const std::size_t here = of_found[to];
      of_found[to] = next;
      next += here;
    }
  }
  piece_start_[pieces] = next;
  pair_.renew(next);
  parallel_for("pairs by piece", RangePolicy<>{0, fixed_pieces}, [&](std::int64_t piece) {
    const PairColumns& of = found_[piece];
    auto& place = place_[piece];
    for_each_pair(piece, [&](std::size_t i, std::size_t to) { pair_[place[to]++] = {of.first[i], of.second[i]}; });
  });
}

void PairOrder::sort(const Begins& begins, Pieces& sorted) {
  share_out(begins, fixed_pieces);
  parallel_for("sorted pairs", RangePolicy<>{0, fixed_pieces}, [&](std::int64_t piece) {
    const std::size_t p = piece;
    sort_piece(piece, begins[p], begins[p + 1], sorted[p]);
  });
}

/// Counts, scans and fills by the first number; then few seconds are to be sorted each time.
void PairOrder::sort_piece(std::int64_t piece, std::int32_t begin, std::int32_t end, PairColumns& sorted) {
  const std::size_t p = piece;
  const std::span<const Pair> pairs = pairs_of(piece);
  const std::size_t count = pairs.size();
  sorted.pairs = 0;
  sorted.make_room(count);
  sorted.pairs = count;
  if (count == 0) return;
  std::vector<std::int32_t>& start = start_[p];
  start.assign(end - begin + 1, 0);
  const auto place_of = [&](std::int32_t first) { return static_cast<std::size_t>(first - begin); };
  for (std::size_t i = 0; i < count; ++i) ++start[place_of(pairs[i].first)];
  std::int32_t next = 0;
  for (std::int32_t& s : start) {
    const std::int32_t here = s;
    s = next;
    next += here;
  }
  for (std::size_t i = 0; i < count; ++i) {  // moves each start to where the next one begins
    const std::size_t place = start[place_of(pairs[i].first)]++;
    sorted.first[place] = pairs[i].first;
    sorted.second[place] = pairs[i].second;
  }
  std::int32_t from = 0;
  for (const std::int32_t to : start) {
    if (to - from > 1) std::sort(sorted.second.begin() + from, sorted.second.begin() + to);
    from = to;
  }
}

std::size_t PairOrder::bytes() const {
  std::size_t sum = pair_.bytes() + sizeof place_;
  for (const PairColumns& found : found_) sum += found.bytes();
  for (const auto& start : start_) sum += start.capacity() * sizeof(std::int32_t);
  return sum;
}

}  // namespace pinball
