#include <algorithm>
#include <pinball/kernels/exec.hpp>
#include <pinball/solver/pair_list.hpp>

namespace pinball {

namespace {

/// Whether two elements have a corner in common.
bool share_corner(const std::array<std::int32_t, 8>& a, const std::array<std::int32_t, 8>& b) {
  std::int32_t equal = 0;
  for (const std::int32_t m : a) {
    for (const std::int32_t n : b) equal |= static_cast<std::int32_t>(m == n);
  }
  return equal != 0;
}

/// Whether two elements of one body may touch.
template <class S>
bool may_touch(const SurfacePinballs<S>& pinballs, std::size_t a, std::size_t b) {
  // Balls of flat elements may overlap from the start; such a pair says nothing about contact.
  const std::array<float, 4>&p = pinballs.reference[a], &q = pinballs.reference[b];
  float d2 = 0;
  for (std::size_t k = 0; k < 3; ++k) d2 += (p[k] - q[k]) * (p[k] - q[k]);
  const float reach = p[3] + q[3];
  if (!(d2 > 1.0001f * reach * reach)) return false;
  // Elements that share a corner are kept apart by the mesh.
  return !share_corner(pinballs.corners[a], pinballs.corners[b]);
}

}  // namespace

template <class S>
void PairList<S>::build(const SurfacePinballs<S>& pinballs, const MovingBalls<S>& balls, bool self) {
  const std::vector<Memory> memory = remember();
  boxes_.build(balls);
  find(pinballs, balls, self);
  number(pinballs);
  recall(memory);
}

template <class S>
std::int32_t PairList<S>::piece_begin(std::int64_t piece) const {
  const std::int64_t begin = boxes_.view().groups * piece / pieces * ball_group<S>;
  return static_cast<std::int32_t>(std::min(begin, static_cast<std::int64_t>(has_pair_.size())));
}

/// The pairs of each piece, and which pinballs have any.
template <class S>
void PairList<S>::find(const SurfacePinballs<S>& pinballs, const MovingBalls<S>& balls, bool self) {
  constexpr int G = ball_group<S>;
  const BallTreeView<S>& tree = boxes_.view();
  has_pair_.assign(static_cast<std::size_t>(balls.count()), 0);
  parallel_for("neighbours", RangePolicy<>{0, pieces}, [&](std::int64_t piece) {
    std::vector<Pair>& found = found_[static_cast<std::size_t>(piece)];
    std::vector<std::int32_t>& elsewhere = elsewhere_[static_cast<std::size_t>(piece)];
    found.clear();
    elsewhere.clear();
    NearBalls<S> near;
    const std::int32_t end = piece_begin(piece + 1);
    for (std::int32_t i = piece_begin(piece); i < end; ++i) {
      const std::int32_t group = i / G, ball = i % G;
      if (ball == 0) near.find(tree, tree.ball + static_cast<std::int64_t>(group) * 7 * G, group);
      const auto a = static_cast<std::size_t>(i);
      for (const auto& [other, balls_near] : near.of(ball)) {
        unsigned bits = balls_near;
        if (other == group) bits &= ~1U << ball;  // those of higher number
        for (; bits != 0; bits &= bits - 1) {
          const std::int32_t j = other * G + __builtin_ctz(bits);
          const auto b = static_cast<std::size_t>(j);
          if (pinballs.body[a] == pinballs.body[b] && !(self && may_touch(pinballs, a, b))) continue;
          found.push_back({i, j});
          has_pair_[a] = 1;
          if (j < end) {
            has_pair_[b] = 1;
          } else {
            elsewhere.push_back(j);
          }
        }
      }
    }
  });
  for (const std::vector<std::int32_t>& elsewhere : elsewhere_) {
    for (const std::int32_t j : elsewhere) has_pair_[static_cast<std::size_t>(j)] = 1;
  }
}

/// Numbers the pinballs that have a pair, and puts the pairs one after the other.
template <class S>
void PairList<S>::number(const SurfacePinballs<S>& pinballs) {
  constexpr std::int64_t W = native_width<S>;
  number_.resize(has_pair_.size());
  listed_.clear();
  slot_.clear();
  std::int64_t places = 0;
  for (std::int64_t p = 0; p < pieces; ++p) {
    Piece& piece = piece_[static_cast<std::size_t>(p)];
    piece.begin = places;
    piece.end = places + static_cast<std::int64_t>(found_[static_cast<std::size_t>(p)].size());
    piece.pinballs_begin = size();
    for (std::int32_t i = piece_begin(p); i < piece_begin(p + 1); ++i) {
      const auto a = static_cast<std::size_t>(i);
      if (has_pair_[a] == 0) continue;
      number_[a] = size();
      listed_.push_back(i);
      slot_.push_back(pinballs.slot[a]);
    }
    piece.pinballs_end = size();
    places = (piece.end + W - 1) / W * W;
  }
  first_.reset(static_cast<std::size_t>(places));
  second_.reset(static_cast<std::size_t>(places));
  parallel_for("pairs", RangePolicy<>{0, pieces}, [&](std::int64_t p) {
    std::int64_t place = piece(p).begin;
    for (const Pair& pair : found_[static_cast<std::size_t>(p)]) {
      first_[static_cast<std::size_t>(place)] = number_[static_cast<std::size_t>(pair.first)];
      second_[static_cast<std::size_t>(place)] = number_[static_cast<std::size_t>(pair.second)];
      ++place;
    }
  });
}

template <class S>
std::vector<typename PairList<S>::Memory> PairList<S>::remember() const {
  std::vector<Memory> memory;
  for (std::size_t i = 0; i < offset_.size(); ++i) {
    if (offset_[i] < S(0)) continue;
    memory.push_back({slot_[static_cast<std::size_t>(first_[i])], slot_[static_cast<std::size_t>(second_[i])],
                      offset_[i], stored_[i]});
  }
  return memory;
}

template <class S>
std::int64_t PairList<S>::find_pair(std::int32_t first, std::int32_t second) const {
  const auto piece =
      std::partition_point(piece_.begin(), piece_.end(), [first](const Piece& p) { return p.pinballs_end <= first; });
  std::int64_t low = piece->begin, high = piece->end;
  while (low < high) {
    const std::int64_t middle = (low + high) / 2;
    const auto m = static_cast<std::size_t>(middle);
    if (first_[m] < first || (first_[m] == first && second_[m] < second)) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  const auto l = static_cast<std::size_t>(low);
  return low < piece->end && first_[l] == first && second_[l] == second ? low : -1;
}

template <class S>
void PairList<S>::recall(const std::vector<Memory>& memory) {
  offset_.reset(first_.size());
  stored_.reset(first_.size());
  std::fill(offset_.data(), offset_.data() + offset_.size(), S(-1));
  const auto number_of_slot = [this](std::int32_t slot) {
    const auto found = std::lower_bound(slot_.begin(), slot_.end(), slot);  // pinballs are in the order of slots
    return found != slot_.end() && *found == slot ? static_cast<std::int32_t>(found - slot_.begin()) : -1;
  };
  for (const Memory& m : memory) {
    const std::int32_t first = number_of_slot(m.first), second = number_of_slot(m.second);
    if (first < 0 || second < 0) continue;
    const std::int64_t place = find_pair(first, second);
    if (place < 0) continue;
    offset_[static_cast<std::size_t>(place)] = m.offset;
    stored_[static_cast<std::size_t>(place)] = m.stored;
  }
}

template <class S>
double PairList<S>::end_pairs_of_inactive(const S* outward) {
  const auto inactive = [outward](std::int32_t p) { return !(outward[4 * static_cast<std::int64_t>(p) + 3] > S(0)); };
  double sum = 0;
  for (std::size_t i = 0; i < offset_.size(); ++i) {
    if (offset_[i] < S(0) || !(inactive(first_[i]) || inactive(second_[i]))) continue;
    sum += static_cast<double>(stored_[i]);
    offset_[i] = S(-1);
    stored_[i] = S(0);
  }
  return sum;
}

template <class S>
std::int64_t PairList<S>::pairs() const {
  std::int64_t sum = 0;
  for (const Piece& p : piece_) sum += p.end - p.begin;
  return sum;
}

template <class S>
std::size_t PairList<S>::bytes() const {
  const auto of = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
  std::size_t sum = of(listed_) + of(slot_) + of(has_pair_) + of(number_) + first_.bytes() + second_.bytes() +
                    offset_.bytes() + stored_.bytes() + boxes_.bytes();
  for (const auto& list : found_) sum += of(list);
  for (const auto& list : elsewhere_) sum += of(list);
  return sum;
}

template class PairList<double>;
template class PairList<float>;

}  // namespace pinball
