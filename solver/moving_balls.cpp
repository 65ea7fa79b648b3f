#include <algorithm>
#include <limits>
#include <pinball/kernels/exec.hpp>
#include <pinball/solver/moving_balls.hpp>

namespace pinball {

namespace {

std::int64_t groups_of(std::int64_t count, int group) { return std::max<std::int64_t>(1, (count + group - 1) / group); }

}  // namespace

template <class S>
void MovingBalls<S>::reset(std::int32_t count) {
  constexpr int G = ball_group<S>;
  count_ = count;
  record_.reset(static_cast<std::size_t>(7 * G * groups_of(count, G)));
  constexpr S nothing = std::numeric_limits<S>::quiet_NaN();
  for (std::int64_t i = count; i < groups_of(count, G) * G; ++i) {
    set(static_cast<std::int32_t>(i), {nothing, nothing, nothing}, {nothing, nothing, nothing}, nothing);
  }
}

template <class S>
void MovingBalls<S>::set(std::int32_t i, const std::array<S, 3>& centre, const std::array<S, 3>& way, S radius) {
  constexpr int G = ball_group<S>;
  S* ball = record_.data() + static_cast<std::int64_t>(i / G) * 7 * G + i % G;
  for (std::size_t k = 0; k < 3; ++k) {
    ball[k * G] = centre[k];
    ball[(3 + k) * G] = way[k];
  }
  ball[6 * G] = radius;
}

template <class S>
void BallTree<S>::build(const MovingBalls<S>& balls) {
  constexpr int G = ball_group<S>;
  view_.groups = static_cast<std::int32_t>(groups_of(balls.count(), G));
  view_.ball = balls.data();
  std::int64_t boxes = view_.groups;
  for (view_.levels = 0; view_.levels == 0 || boxes > 1; ++view_.levels) {
    const std::int64_t groups = groups_of(boxes, G);
    AlignedArray<S>& level = box_[static_cast<std::size_t>(view_.levels)];
    level.reset(static_cast<std::size_t>(groups * 12 * G));
    view_.box[view_.levels] = level.data();
    const S* below = view_.levels == 0 ? view_.ball : view_.box[view_.levels - 1];
    const bool of_balls = view_.levels == 0;
    parallel_for("boxes", RangePolicy<>{0, groups}, [&, boxes](std::int64_t group) {
      MovingBox<S> empty;
      for (int c = 0; c < 12; ++c) {
        empty.bound[c] = (c % 6 < 3 ? 1 : -1) * std::numeric_limits<S>::infinity();
      }
      for (std::int64_t b = group * G; b < (group + 1) * G; ++b) {
        put_box(b >= boxes ? empty
                : of_balls ? box_of_balls(below + b * 7 * G)
                           : box_of_boxes(below + b * 12 * G),
                level.data(), b);
      }
    });
    boxes = groups;
  }
}

template <class S>
std::size_t BallTree<S>::bytes() const {
  std::size_t sum = 0;
  for (const auto& level : box_) sum += level.bytes();
  return sum;
}

template <class S>
void NearBalls<S>::find(const BallTreeView<S>& tree, const S* own, std::int32_t from) {
  using T = Pack<S, native_width<S>>;
  constexpr int G = ball_group<S>;
  for (std::vector<Group>& near : near_) near.clear();
  // Groups that meet the box of ours are many, those that meet the box of one of its balls a third of them.
  const BallBounds<T> bounds = bounds_of_balls<T>(own);
  for_each_meeting_group<T>(tree, box_of_balls(own), from, [&](std::int32_t group) {
    unsigned bits = balls_meeting_box(bounds, get_box(tree.box[0], group));
    for (; bits != 0; bits &= bits - 1) near_[static_cast<std::size_t>(__builtin_ctz(bits))].push_back({group, 0});
  });
  for (int i = 0; i < G; ++i) {
    S ball[7];
    for (int c = 0; c < 7; ++c) ball[c] = own[c * G + i];
    for (Group& near : near_[static_cast<std::size_t>(i)]) {
      near.balls = meeting_balls<T>(tree.ball + static_cast<std::int64_t>(near.number) * 7 * G, ball);
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
