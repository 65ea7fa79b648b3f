#pragma once

#include <algorithm>
#include <deque>

#include <solver/verification/solver_run.hpp>

#include "geometric_depth.hpp"

namespace pinball::test {

/// The depth that stays: the largest that nodes have for some time without a pause. What vibrates through a face and
/// comes back is none.
class LastingDepth {
 public:
  /// time: for how long [time]; self: also of a body in itself.
  LastingDepth(const Solver<double>& solver, double time, bool self = false)
      : solver_(solver), depth_(solver.mesh()), window_(time), self_(self) {}

  /// To be called after each step; looks eight times within the time.
  void look() {
    if (solver_.time() < next_) return;
    next_ = solver_.time() + window_ / 8;
    depth_.take([this](std::size_t n) { return position_of(solver_, n); });
    double depth = 0;
    for (std::int32_t b = 0; b < static_cast<std::int32_t>(solver_.mesh().body_names.size()); ++b) {
      depth = std::max(depth, depth_.deepest_node(b));
      if (self_) depth = std::max(depth, depth_.deepest_node(b, true));
    }
    last_.push_back(depth);
    if (last_.size() > 8) last_.pop_front();
    if (last_.size() == 8) deepest_ = std::max(deepest_, *std::min_element(last_.begin(), last_.end()));
  }

  double deepest() const { return deepest_; }

 private:
  const Solver<double>& solver_;
  GeometricDepth depth_;
  double window_;
  bool self_;
  double next_ = 0, deepest_ = 0;
  std::deque<double> last_;
};

}  // namespace pinball::test
