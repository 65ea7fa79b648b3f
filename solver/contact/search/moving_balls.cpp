#include "moving_balls.hpp"

#include <algorithm>
#include <limits>

#include <kernels/compress.hpp>
#include <kernels/exec.hpp>

namespace pinball {

namespace {

std::int64_t groups_of(std::int64_t count, int group) { return std::max<std::int64_t>(1, (count + group - 1) / group); }

}  // namespace

template <class S>
void MovingBalls<S>::reset(std::int32_t count) {
  constexpr int G = ball_group<S>;
  count_ = count;
  record_.renew(7 * G * groups_of(count, G));
  constexpr S nothing = std::numeric_limits<S>::quiet_NaN();
  for (std::int64_t i = count; i < groups_of(count, G) * G; ++i) {
    set(i, {nothing, nothing, nothing}, {0, 0, 0}, nothing);
  }
}

template <class S>
void MovingBalls<S>::set(std::int32_t i, const std::array<S, 3>& centre, const std::array<S, 3>& way, S radius) {
  constexpr int G = ball_group<S>;
  const std::int64_t group = i / G;
  S* ball = record_.data() + group * 7 * G + i % G;
  for (std::size_t k = 0; k < 3; ++k) {
    const S half = S(0.5) * way[k];
    ball[k * G] = centre[k] + half;
    ball[(3 + k) * G] = half;
  }
  ball[6 * G] = radius;
}

namespace {

/// Whether a ball of a group makes a way.
template <class S>
bool any_ball_moves(const S* ball) {
  constexpr int G = ball_group<S>;
  bool moves = false;
  for (int i = 3 * G; i < 6 * G; ++i) moves = moves || ball[i] != S(0);
  return moves;
}

}  // namespace

template <class S>
void BallTree<S>::build(const MovingBalls<S>& balls) {
  constexpr int G = ball_group<S>;
  view_.groups = groups_of(balls.count(), G);
  view_.ball = balls.data();
  view_.moves = false;
  const std::int64_t groups = groups_of(view_.groups, G);
  lowest_.renew(groups * 12 * G);
  parallel_reduce(
      "boxes of balls", RangePolicy<>{0, groups}, view_.moves,
      [this](std::int64_t begin, std::int64_t end, bool& moves) {
        for (std::int64_t b = begin * G; b < end * G; ++b) {
          const S* ball = view_.ball + b * 7 * G;
          put_box(b < view_.groups ? finite_box_of_balls(ball) : empty_box<S>(), lowest_.data(), b);
          moves = moves || (b < view_.groups && any_ball_moves(ball));
        }
      },
      [](bool& whole, bool partial) { whole = whole || partial; });
  levels_.build(lowest_.data(), groups, view_);
}

template <class S>
void NearBalls<S>::enter(const BallTreeView<S>& tree, const MovingBox<S>& box, std::int32_t from) {
  using T = Pack<S, native_width<S>>;
  part_.clear();
  if (tree.levels == 1) {
    part_.push_back(0);
  } else {
    for_each_meeting_box<T>(tree, box, 1, from / G, [this](std::int32_t group) { part_.push_back(group); });
  }
  const std::int64_t parts = part_.size();
  part_box_.renew(groups_of(parts, G) * 12 * G);
  for (std::int64_t p = 0; p < groups_of(parts, G) * G; ++p) {
    const MovingBox<S> part_box = p >= parts         ? empty_box<S>()
                                  : tree.levels == 1 ? box_of_boxes<T>(tree.box[0])
                                                     : get_box(tree.box[1], part_[p]);
    put_box(part_box, part_box_.data(), p);
  }
  near_part_.resize(part_.size() + G);
  candidate_.resize(part_.size() * G + G);
  near_.resize(candidate_.size());
}

/// No loop here has a branch that depends on what is found: nothing tells the processor which boxes meet.
template <class S>
template <bool moves>
std::size_t NearBalls<S>::find_near(const BallTreeView<S>& tree, const S* own, std::int32_t from) {
  using T = Pack<S, native_width<S>>;
  const MovingBox<S> box = finite_box_of_balls(own);
  const std::int32_t parts = part_.size();
  std::int32_t* part_end = near_part_.data();
  for (std::int32_t p = 0; p < parts; p += G) {
    part_end += write_numbers<G>(meeting_boxes<T, moves>(part_box_.data() + p * 12, box), p, part_end);
  }
  std::int32_t* candidate_end = candidate_.data();
  for (const std::int32_t* p = near_part_.data(); p < part_end; ++p) {
    const std::int32_t part = part_[*p];
    const unsigned bits = meeting_boxes<T, moves>(tree.boxes(0, part), box);
    const std::int32_t before = std::clamp(from - part * G, 0, G);  // those that do not count
    candidate_end += write_numbers<G>(bits >> before << before, part * G, candidate_end);
  }
  Group* near_end = near_.data();
  for (const std::int32_t* candidate = candidate_.data(); candidate < candidate_end; ++candidate) {
    near_end->number = *candidate;
    near_end->balls = maybe_meeting_balls<T, moves>(own, tree.balls(*candidate));
    near_end += near_end->balls.any() ? 1 : 0;
  }
  return near_end - near_.data();
}

template <class S>
std::span<typename NearBalls<S>::Group> NearBalls<S>::find(const BallTreeView<S>& tree, const S* own,
                                                           std::int32_t from) {
  return {near_.data(), tree.moves ? find_near<true>(tree, own, from) : find_near<false>(tree, own, from)};
}

template <class S>
void NearBalls<S>::leave_out_passing(const BallTreeView<S>& tree, const S* own, std::span<Group> found) {
  using T = Pack<S, native_width<S>>;
  if (!tree.moves) return;
  for (Group& near : found) {
    const S* others = tree.balls(near.number);
    for (int i = 0; near.balls.any() && i < G; ++i) {
      const unsigned maybe = near.balls.row(i);
      if (maybe != 0) near.balls.clear_in_row(i, maybe & ~meeting_balls<T>(own, i, others));
    }
  }
}

template class NearBalls<double>;
template class NearBalls<float>;
template class MovingBalls<double>;
template class MovingBalls<float>;
template class BallTree<double>;
template class BallTree<float>;

}  // namespace pinball
