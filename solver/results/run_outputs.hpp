#pragma once

#include <solver/scene.hpp>

namespace pinball {

/// How much a run writes.
struct RunOutputs {
  double rows = 0;    ///< of history.csv
  double fields = 0;  ///< times at which fields are written
};

/// Of a run of so many steps, up to this time [time]: there is at most one of each in a step, and one at the start.
RunOutputs outputs_of(const Scene& scene, double steps, double time);

}  // namespace pinball
