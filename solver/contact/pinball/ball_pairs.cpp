#include "ball_pairs.hpp"

#include <kernels/exec.hpp>

namespace pinball {

namespace {

/// Box of ball i of a group, as box_of_balls has it (kernels/ball_tree.hpp).
template <class S>
MovingBox<S> box_of_ball(const S* ball, int i) {
  constexpr int G = ball_group<S>;
  MovingBox<S> box;
  const S radius = ball[6 * G + i];
  for (int k = 0; k < 3; ++k) {
    const S middle = ball[k * G + i], half = ball[(3 + k) * G + i];
    const S reach = radius + static_cast<S>(box_margin<S>) * (absolute(middle) + absolute(half) + radius);
    for (int end = 0; end < 2; ++end) {
      const S centre = end == 0 ? middle - half : middle + half;
      box.bound[6 * end + k] = centre - reach;
      box.bound[6 * end + 3 + k] = centre + reach;
    }
  }
  return box;
}

}  // namespace

template <class S>
void BallPairs<S>::find(const SurfacePinballs<S>& pinballs, const BallTreeView<S>& tree, const float* reference,
                        bool self) {
  constexpr int G = ball_group<S>;
  boxes_.reset(pinballs.count);
  parallel_for("boxes of balls", RangePolicy<>{0, pinballs.count},
               [&](std::int64_t i) { boxes_.set(i, box_of_ball(tree.ball + i / G * 7 * G, i % G)); });
  if (tree.moves) {
    find_moving<true>(pinballs, tree, reference, self);
  } else {
    find_moving<false>(pinballs, tree, reference, self);
  }
}

template <class S>
template <bool moves>
void BallPairs<S>::find_moving(const SurfacePinballs<S>& pinballs, const BallTreeView<S>& tree, const float* reference,
                               bool self) {
  using T = Pack<S, native_width<S>>;
  constexpr std::int64_t G = ball_group<S>;
  // The same arithmetic as for groups of balls: as many numbers at a time, of which one is asked for.
  pairs_.find(boxes_, ContactSearch::hash, [&, reference, self](std::int32_t first, std::int32_t second) {
    const S *own = tree.ball + first / G * 7 * G, *others = tree.ball + second / G * 7 * G;
    const int i = first % G;
    unsigned near = test_ball<T, G>(i, maybe_meeting_test<T, moves>(own, others));
    if constexpr (moves) near &= meeting_balls<T>(own, i, others);
    if ((near >> second % G & 1U) == 0) return false;
    const float* own_reference = reference + first / G * reference_components * G;
    const float* other_reference = reference + second / G * reference_components * G;
    if (own_reference[4 * G + i] != other_reference[4 * G + second % G]) return true;
    const unsigned apart = test_ball<ReferencePack<S>, G>(i, apart_test<S>(own_reference, other_reference));
    return (self || pinballs.body[first] != pinballs.body[second]) && (apart >> second % G & 1U) != 0 &&
           !share_corner(pinballs.corners[first], pinballs.corners[second]);
  });
}

template class BallPairs<double>;
template class BallPairs<float>;

}  // namespace pinball
