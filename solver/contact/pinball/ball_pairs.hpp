#pragma once

#include <array>
#include <cstdint>

#include <kernels/reference_balls.hpp>
#include <solver/contact/search/box_pairs.hpp>
#include <solver/contact/search/moving_balls.hpp>

#include "surface_pinballs.hpp"

namespace pinball {

/// Pairs of pinballs by a hash of their boxes: those that PairList finds by its tree, by the same tests, in the same
/// order and in the same pieces.
template <class S>
class BallPairs {
 public:
  /// balls: of the tree; reference: groups of balls of the undeformed mesh (reference_balls.hpp); self: a body may
  /// touch itself.
  void find(const SurfacePinballs<S>& pinballs, const BallTreeView<S>& tree, const float* reference, bool self);
  const BoxPairs<S>& pairs() const { return pairs_; }
  std::size_t bytes() const { return boxes_.bytes() + pairs_.bytes(); }

 private:
  template <bool moves>
  void find_moving(const SurfacePinballs<S>& pinballs, const BallTreeView<S>& tree, const float* reference, bool self);

  MovingBoxes<S> boxes_;
  BoxPairs<S> pairs_;
};

}  // namespace pinball
