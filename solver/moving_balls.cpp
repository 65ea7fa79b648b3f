#include <algorithm>
#include <limits>
#include <pinball/kernels/exec.hpp>
#include <pinball/solver/moving_balls.hpp>

namespace pinball {

namespace {

std::int64_t groups_of(std::int64_t count, int group) { return std::max<std::int64_t>(1, (count + group - 1) / group); }

}  // namespace

template <class S>
MovingBalls<S>::MovingBalls(std::int32_t count)
    : count_(count), record_(static_cast<std::size_t>(7 * ball_group<S> * groups_of(count, ball_group<S>))) {
  std::fill(record_.data(), record_.data() + record_.size(), std::numeric_limits<S>::quiet_NaN());
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
    if (level.size() != static_cast<std::size_t>(groups * 12 * G)) {
      level = AlignedArray<S>();
      level = AlignedArray<S>(static_cast<std::size_t>(groups * 12 * G));
    }
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

template class MovingBalls<double>;
template class MovingBalls<float>;
template class BallTree<double>;
template class BallTree<float>;

}  // namespace pinball
