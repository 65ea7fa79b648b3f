#include "moving_boxes.hpp"

#include <algorithm>
#include <limits>

#include <kernels/exec.hpp>

namespace pinball {

template <class S>
void MovingBoxes<S>::reset(std::int32_t count) {
  constexpr int G = ball_group<S>;
  count_ = count;
  groups_ = std::max<std::int64_t>(1, (std::int64_t(count) + G - 1) / G);
  bound_.renew(groups_ * 12 * G);
  for (std::int64_t i = count; i < groups_ * G; ++i) put_box(empty_box<S>(), bound_.data(), i);
}

template <class S>
void MovingBoxes<S>::set(std::int32_t i, const MovingBox<S>& box) {
  constexpr S largest = std::numeric_limits<S>::max();
  MovingBox<S> kept;
  bool proper = true;
  for (int c = 0; c < 12; ++c) {
    if (c % 6 < 3) proper = proper && box.bound[c] <= box.bound[c + 3];  // false for what is not a number
    // Finite, so that nothing meets the box that nothing is in.
    kept.bound[c] = std::clamp(box.bound[c], -largest, largest);
  }
  put_box(proper ? kept : empty_box<S>(), bound_.data(), i);
}

template <class S>
void BoxLevels<S>::build(const S* lowest, std::int64_t groups, BoxTreeView<S>& view) {
  using T = Pack<S, native_width<S>>;
  constexpr int G = ball_group<S>;
  view.box[0] = lowest;
  view.levels = 1;
  for (std::int64_t boxes = groups; boxes > 1; ++view.levels) {
    const std::int64_t above = (boxes + G - 1) / G;
    const S* below = view.box[view.levels - 1];
    Array<S>& level = level_[view.levels];
    level.renew(above * 12 * G);
    view.box[view.levels] = level.data();
    parallel_for("levels of boxes", RangePolicy<>{0, above}, [&level, below, boxes](std::int64_t group) {
      for (std::int64_t b = group * G; b < (group + 1) * G; ++b) {
        put_box(b >= boxes ? empty_box<S>() : box_of_boxes<T>(below + b * 12 * G), level.data(), b);
      }
    });
    boxes = above;
  }
}

template <class S>
void BoxLevels<S>::include(const MovingBox<S>& box, std::int64_t i, int levels) {
  for (int level = 1; level < levels; ++level) {
    i /= ball_group<S>;
    MovingBox<S> above = get_box(level_[level].data(), i);
    include_box(above, box);
    put_box(above, level_[level].data(), i);
  }
}

template <class S>
std::size_t BoxLevels<S>::bytes() const {
  std::size_t sum = 0;
  for (const auto& level : level_) sum += level.bytes();
  return sum;
}

template class MovingBoxes<double>;
template class MovingBoxes<float>;
template class BoxLevels<double>;
template class BoxLevels<float>;

}  // namespace pinball
