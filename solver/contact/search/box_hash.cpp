#include "box_hash.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pinball {

namespace {

constexpr std::uint32_t no_bucket = ~0U;

template <class S>
bool is_empty(const MovingBox<S>& box) {
  return box.bound[0] > box.bound[3];
}

/// The element that so large a part of all is below, or 0.
double quantile(std::vector<double>& values, double part) {
  if (values.empty()) return 0;
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size()));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

std::int64_t numbers_begin(std::int64_t piece, std::int64_t count) { return count * piece / fixed_pieces; }

}  // namespace

template <class S>
void BoxHash<S>::build(const MovingBoxes<S>& boxes) {
  const std::size_t count = boxes.count();
  choose_grid(boxes);
  view_.bits = 9;
  while ((std::size_t(1) << view_.bits) < 2 * count) ++view_.bits;
  bucket_start_.resize((std::size_t(1) << view_.bits) + 1);
  bounds_.renew(count);
  made_.renew(count);
  bucket_.resize(count);
  cell_begin_.resize(count);
  make_boxes(boxes);
  sort_into_pieces(boxes.count());
  box_.renew(piece_start_.back());
  parallel_for("buckets", RangePolicy<>{0, fixed_pieces}, [this](std::int64_t piece) { sort_piece(piece); });
  bucket_start_.back() = piece_start_.back();
  view_.bucket_start = bucket_start_.data();
  view_.box = box_.data();
}

/// Units for most of the boxes, by some of them; the others are found, too, whatever they are.
template <class S>
void BoxHash<S>::choose_grid(const MovingBoxes<S>& boxes) {
  constexpr std::int32_t most = 256;
  std::vector<MovingBox<S>> sample;
  const std::int32_t step = boxes.count() / most + 1;
  for (std::int32_t i = 0; i < boxes.count(); i += step) {
    const MovingBox<S> box = boxes.box(i);
    if (!is_empty(box)) sample.push_back(box);
  }
  std::vector<double> values;
  const auto middle_one = [&](const auto& value) {
    values.clear();
    for (const MovingBox<S>& box : sample) {
      if (const double v = value(box); std::isfinite(v)) values.push_back(v);
    }
    return quantile(values, 0.5);
  };
  double centre[3];
  for (std::size_t k = 0; k < 3; ++k) {
    way_[k] = static_cast<S>(middle_one([k](const auto& b) { return double(b.bound[6 + k]) - double(b.bound[k]); }));
    centre[k] = middle_one([k](const auto& b) { return double(b.bound[k]); });
  }
  std::vector<double> distances, sides;
  for (const MovingBox<S>& box : sample) {
    double distance = 0, side = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double low = std::min<double>(box.bound[k], double(box.bound[6 + k]) - double(way_[k]));
      const double high = std::max<double>(box.bound[3 + k], double(box.bound[9 + k]) - double(way_[k]));
      distance = std::max(distance, std::abs(low - centre[k]));
      side = std::max(side, high - low);
    }
    if (std::isfinite(distance)) distances.push_back(distance);
    if (side > 0 && std::isfinite(side)) sides.push_back(side);
  }
  // The middle box takes a third of a cell of its level, so that boxes a little larger or smaller have the same.
  const double side = 3 * quantile(sides, 0.5);
  // Half of the coordinates reach sixteen times as far as nearly all boxes.
  const double least = std::ldexp(16 * (quantile(distances, 0.9) + side), 1 - cell_coordinate_bits);
  double unit = least;
  if (const double ratio = least / side; ratio > 0 && std::isfinite(ratio)) {
    const int exponent = std::max(-20, std::ilogb(ratio) + 1);
    unit = std::ldexp(side, exponent + (exponent & 1));  // from level to level cells grow by four
  }
  if (!(unit > std::numeric_limits<double>::min()) || !std::isfinite(unit)) unit = 1;
  view_.grid.inverse_unit = 1 / unit;
  for (int k = 0; k < 3; ++k) view_.grid.origin[k] = centre[k] - std::ldexp(unit, cell_coordinate_bits - 1);
}

template <class S>
HashBox BoxHash<S>::hash_box(const MovingBox<S>& box, std::int32_t number) const {
  HashBox result;
  std::int32_t longest = 0;
  for (int k = 0; k < 3; ++k) {
    const auto at = [&](int c) { return view_.grid.coordinate(box.bound[c], k); };
    const auto at_end = [&](int c) {
      return view_.grid.coordinate(static_cast<double>(box.bound[c]) - static_cast<double>(way_[k]), k);
    };
    const std::int32_t low = std::min(at(k), at_end(6 + k)), high = std::max(at(3 + k), at_end(9 + k));
    result.value[k] = low;
    result.value[3 + k] = -high;
    longest = std::max(longest, high - low);
  }
  result.value[6] = number;
  result.value[7] = level_of(longest);
  return result;
}

template <class S>
void BoxHash<S>::make_boxes(const MovingBoxes<S>& boxes) {
  const int bucket_bits = view_.bits - 6;  // of the 64 pieces of buckets
  static_assert(fixed_pieces == 64);
  std::array<std::uint32_t, fixed_pieces> levels{};
  std::array<bool, fixed_pieces> moves{};
  parallel_for("boxes of a hash", RangePolicy<>{0, fixed_pieces}, [&](std::int64_t piece) {
    const std::size_t p = piece;
    std::array<std::int32_t, fixed_pieces> places{};
    std::uint32_t all_levels = 0;
    bool any_moves = false;
    for (std::int64_t i = numbers_begin(piece, boxes.count()); i < numbers_begin(piece + 1, boxes.count()); ++i) {
      bounds_[i] = boxes.box(i);
      bucket_[i] = no_bucket;
      cell_begin_[i] = -1;
      if (is_empty(bounds_[i])) continue;
      for (int c = 0; c < 6; ++c) any_moves |= bounds_[i].bound[c] != bounds_[i].bound[6 + c];
      made_[i] = hash_box(bounds_[i], i);
      bucket_[i] = bucket_of(cell_of(made_[i]), view_.bits);
      all_levels |= 1U << made_[i].level();
      ++places[bucket_[i] >> bucket_bits];
    }
    place_[p] = places;
    levels[p] = all_levels;
    moves[p] = any_moves;
  });
  view_.levels = 0;
  for (const std::uint32_t l : levels) view_.levels |= l;
  moves_ = std::find(moves.begin(), moves.end(), true) != moves.end();
}

/// Puts what is in the hash in order of the pieces of buckets; in a piece by number.
template <class S>
void BoxHash<S>::sort_into_pieces(std::int32_t count) {
  std::int32_t next = 0;
  for (std::size_t bucket_piece = 0; bucket_piece < fixed_pieces; ++bucket_piece) {
    piece_start_[bucket_piece] = next;
    for (auto& of_numbers : place_) {
      const std::int32_t here = of_numbers[bucket_piece];
      of_numbers[bucket_piece] = next;
      next += here;
    }
  }
  piece_start_.back() = next;
  member_.renew(next);
  const int bucket_bits = view_.bits - 6;
  parallel_for("pieces of buckets", RangePolicy<>{0, fixed_pieces}, [&](std::int64_t piece) {
    auto& place = place_[piece];
    for (std::int64_t i = numbers_begin(piece, count); i < numbers_begin(piece + 1, count); ++i) {
      const std::uint32_t bucket = bucket_[i];
      if (bucket == no_bucket) continue;
      member_[place[bucket >> bucket_bits]++] = {static_cast<std::int32_t>(i), bucket};
    }
  });
}

template <class S>
void BoxHash<S>::sort_piece(std::int64_t piece) {
  const std::size_t p = piece;
  std::int32_t* const start = bucket_start_.data();
  const std::size_t first = p * buckets_of_piece(), last = first + buckets_of_piece();
  const Member *begin = member_.data() + piece_start_[p], *end = member_.data() + piece_start_[p + 1];
  std::fill(start + first, start + last, 0);
  for (const Member* m = begin; m < end; ++m) ++start[m->bucket];
  std::int32_t next = piece_start_[p];
  for (std::size_t b = first; b < last; ++b) {
    const std::int32_t here = start[b];
    start[b] = next;
    next += here;
  }
  for (const Member* m = begin; m < end; ++m) {  // moves each start to the end of its bucket
    box_[start[m->bucket]++] = made_[m->number];
  }
  for (std::size_t b = last - 1; b > first; --b) start[b] = start[b - 1];  // starts again
  start[first] = piece_start_[p];
  const auto in_order = [](const HashBox& a, const HashBox& b) {
    const HashCell c = cell_of(a), d = cell_of(b);
    for (const auto& [x, y] :
         {std::pair{c.level, d.level}, {c.at[0], d.at[0]}, {c.at[1], d.at[1]}, {c.at[2], d.at[2]}}) {
      if (x != y) return x < y;
    }
    return a.number() < b.number();
  };
  for (std::size_t b = first; b < last; ++b) {
    HashBox* const of_bucket = box_.data() + start[b];
    HashBox* const bucket_end = box_.data() + (b + 1 < last ? start[b + 1] : next);
    // Nearly always one cell has the bucket to itself.
    if (!std::is_sorted(of_bucket, bucket_end, in_order)) std::sort(of_bucket, bucket_end, in_order);
    for (const HashBox* box = of_bucket; box < bucket_end; ++box) {
      if (box > of_bucket && is_in_cell(*box, cell_of(box[-1]))) continue;
      cell_begin_[box->number()] = box - box_.data();
    }
  }
}

template <class S>
std::size_t BoxHash<S>::bytes() const {
  return (bucket_start_.capacity() + cell_begin_.capacity()) * sizeof(bucket_start_[0]) +
         bucket_.capacity() * sizeof(bucket_[0]) + box_.bytes() + bounds_.bytes() + made_.bytes() + member_.bytes();
}

template class BoxHash<double>;
template class BoxHash<float>;

}  // namespace pinball
