#pragma once

#include <cstdint>

namespace pinball {

/// Of what is asked for where cycles of subcycling end, and is another in each of their steps: the mean over the steps.
class CycleMean {
 public:
  /// A step begins. last: what it was in the one before, which counts where the cycle goes on.
  void begin_step(bool begins_cycle, double last) {
    before_ = begins_cycle ? 0 : before_ + last;
    steps_ = begins_cycle ? 0 : steps_ + 1;
  }
  /// now: what it is in the last step made.
  double with(double now) const { return (before_ + now) / (steps_ + 1); }

 private:
  double before_ = 0;       ///< sum over the steps of the cycle before the last one made
  std::int32_t steps_ = 0;  ///< how many these are
};

}  // namespace pinball
