#include <algorithm>
#include <pinball/kernels/exec.hpp>
#include <pinball/solver/neighbour_list.hpp>

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
void NeighbourList<S>::build(const SurfacePinballs<S>& pinballs, const MovingBalls<S>& balls, bool self) {
  const std::vector<Memory> memory = remember();
  boxes_.build(balls);
  find(pinballs, balls, self);
  join(pinballs);
  recall(memory);
}

template <class S>
std::int32_t NeighbourList<S>::piece_begin(std::int64_t piece) const {
  const std::int64_t first = boxes_.view().groups * piece / pieces * ball_group<S>;
  return static_cast<std::int32_t>(std::min(first, static_cast<std::int64_t>(count_above_.size())));
}

/// For each pinball its neighbours of higher number; those of lower number are counted.
template <class S>
void NeighbourList<S>::find(const SurfacePinballs<S>& pinballs, const MovingBalls<S>& balls, bool self) {
  constexpr int G = ball_group<S>;
  const BallTreeView<S>& tree = boxes_.view();
  const auto all = static_cast<std::size_t>(balls.count());
  count_above_.resize(all);
  count_below_.resize(all);
  parallel_for("neighbours", RangePolicy<>{0, pieces}, [&](std::int64_t piece) {
    std::vector<std::int32_t>& above = above_[static_cast<std::size_t>(piece)];
    std::vector<Pair>& crossing = crossing_[static_cast<std::size_t>(piece)];
    above.clear();
    crossing.clear();
    NearBalls<S> near;
    const std::int32_t begin = piece_begin(piece), end = piece_begin(piece + 1);
    std::fill(count_below_.begin() + begin, count_below_.begin() + end, 0);
    for (std::int32_t i = begin; i < end; ++i) {
      const std::int32_t group = i / G, ball = i % G;
      if (ball == 0) near.find(tree, tree.ball + static_cast<std::int64_t>(group) * 7 * G, group);
      const auto a = static_cast<std::size_t>(i);
      const std::size_t before = above.size();
      for (const auto& [other, balls_near] : near.of(ball)) {
        unsigned bits = balls_near;
        if (other == group) bits &= ~1U << ball;
        for (; bits != 0; bits &= bits - 1) {
          const std::int32_t j = other * G + __builtin_ctz(bits);
          const auto b = static_cast<std::size_t>(j);
          if (pinballs.body[a] == pinballs.body[b] && !(self && may_touch(pinballs, a, b))) continue;
          above.push_back(j);
          if (j < end) {
            ++count_below_[b];
          } else {
            crossing.push_back({i, j});
          }
        }
      }
      count_above_[a] = static_cast<std::int32_t>(above.size() - before);
    }
  });
  for (const std::vector<Pair>& crossing : crossing_) {
    for (const Pair& pair : crossing) ++count_below_[static_cast<std::size_t>(pair.second)];
  }
}

/// From the neighbours of higher number to one list of all, in which only pinballs with neighbours have numbers.
template <class S>
void NeighbourList<S>::join(const SurfacePinballs<S>& pinballs) {
  constexpr int W = native_width<S>;
  number_.resize(count_above_.size());
  listed_.clear();
  slot_.clear();
  count_.clear();
  start_.assign(1, 0);
  for (std::size_t i = 0; i < count_above_.size(); ++i) {
    const std::int32_t n = count_above_[i] + count_below_[i];
    if (n == 0) continue;
    number_[i] = size();
    listed_.push_back(static_cast<std::int32_t>(i));
    slot_.push_back(pinballs.slot[i]);
    count_.push_back(n);
    start_.push_back(start_.back() + (n + W - 1) / W * W);
  }
  next_ = start_;
  neighbour_.resize(static_cast<std::size_t>(start_.back()));
  const auto append = [this](std::int32_t to, std::int32_t entry) {
    neighbour_[static_cast<std::size_t>(next_[static_cast<std::size_t>(to)]++)] = entry;
  };
  // Neighbours of lower number come first, and among them those of lower pieces.
  for (const std::vector<Pair>& crossing : crossing_) {
    for (const Pair& pair : crossing) {
      append(number_[static_cast<std::size_t>(pair.second)], number_[static_cast<std::size_t>(pair.first)]);
    }
  }
  parallel_for("joined lists", RangePolicy<>{0, pieces}, [&](std::int64_t piece) {
    const std::int32_t* above = above_[static_cast<std::size_t>(piece)].data();
    const std::int32_t end = piece_begin(piece + 1);
    for (std::int32_t i = piece_begin(piece); i < end; ++i) {
      const auto a = static_cast<std::size_t>(i);
      if (count_above_[a] + count_below_[a] == 0) continue;
      const std::int32_t p = number_[a];
      for (std::int32_t k = 0; k < count_above_[a]; ++k) {
        const std::int32_t j = *above++, q = number_[static_cast<std::size_t>(j)];
        append(p, q);
        if (j < end) append(q, p);
      }
      while (next_[static_cast<std::size_t>(p)] < start_[static_cast<std::size_t>(p) + 1]) append(p, p);
    }
  });
}

template <class S>
std::vector<typename NeighbourList<S>::Memory> NeighbourList<S>::remember() const {
  std::vector<Memory> memory;
  for (std::size_t p = 0; p < count_.size(); ++p) {
    for (std::int64_t e = start_[p]; e < start_[p] + count_[p]; ++e) {
      const auto entry = static_cast<std::size_t>(e);
      if (offset_[entry] < S(0)) continue;
      memory.push_back({slot_[p], slot_[static_cast<std::size_t>(neighbour_[entry])], offset_[entry], stored_[entry]});
    }
  }
  return memory;
}

template <class S>
void NeighbourList<S>::recall(const std::vector<Memory>& memory) {
  offset_.reset(neighbour_.size());
  stored_.reset(neighbour_.size());
  std::fill(offset_.data(), offset_.data() + offset_.size(), S(-1));
  for (const Memory& m : memory) {
    const auto found = std::lower_bound(slot_.begin(), slot_.end(), m.slot);  // pinballs are in the order of slots
    if (found == slot_.end() || *found != m.slot) continue;
    const auto p = static_cast<std::size_t>(found - slot_.begin());
    for (std::int64_t e = start_[p]; e < start_[p] + count_[p]; ++e) {
      const auto entry = static_cast<std::size_t>(e);
      if (slot_[static_cast<std::size_t>(neighbour_[entry])] != m.other) continue;
      offset_[entry] = m.offset;
      stored_[entry] = m.stored;
    }
  }
}

template <class S>
double NeighbourList<S>::end_pairs_of_inactive(const S* outward) {
  const auto inactive = [outward](std::size_t p) { return !(outward[4 * p + 3] > S(0)); };
  double sum = 0;
  for (std::size_t p = 0; p < count_.size(); ++p) {
    const bool itself = inactive(p);
    for (std::int64_t e = start_[p]; e < start_[p] + count_[p]; ++e) {
      const auto entry = static_cast<std::size_t>(e);
      if (offset_[entry] < S(0) || !(itself || inactive(static_cast<std::size_t>(neighbour_[entry])))) continue;
      sum += static_cast<double>(stored_[entry]);
      offset_[entry] = S(-1);
      stored_[entry] = S(0);
    }
  }
  return sum;
}

template <class S>
std::int64_t NeighbourList<S>::pairs() const {
  std::int64_t entries = 0;
  for (const std::int32_t n : count_) entries += n;
  return entries / 2;
}

template <class S>
std::size_t NeighbourList<S>::bytes() const {
  const auto of = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
  std::size_t sum = of(start_) + of(count_) + of(listed_) + of(slot_) + of(neighbour_) + of(count_above_) +
                    of(count_below_) + of(next_) + of(number_) + offset_.bytes() + stored_.bytes() + boxes_.bytes();
  for (const auto& list : above_) sum += of(list);
  for (const auto& list : crossing_) sum += of(list);
  return sum;
}

template class NeighbourList<double>;
template class NeighbourList<float>;

}  // namespace pinball
