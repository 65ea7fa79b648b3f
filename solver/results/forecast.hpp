#pragma once

#include <cstdint>
#include <vector>

#include <solver/scene.hpp>

namespace pinball {

/// Where a run is.
struct RunPlace {
  double time = 0, dt = 0;  ///< [time]
  std::int64_t steps = 0;
  double seconds = 0;     ///< since its first step
  bool touching = false;  ///< some bodies are in contact
};

struct ExpectedRun {
  double steps = 0, seconds = 0;
};

/// How long a run will take, from how it has gone so far and from what is still to come.
///
/// Steps shrink with the elements that an impact squeezes: over the run by exp(0.55 e), where the plastic strain e is
/// what erodes the material, or 3.5 rho v^2 / Y of the impact where that is less, and 4 at most: nine times for a bar
/// that strikes a wall (taylor_bar). The further a run is, the more its last steps count instead. Elements at rest wake
/// in the first tenth of a run, or never; contact that is still to come costs 0.3 of a step.
class Forecast {
 public:
  /// speed: of the fastest impact that is expected; 0: none is [length/time]
  Forecast(const Scene& scene, double speed);

  void take(const RunPlace& place);
  /// Of the whole run, after at least one place. at_rest: part of the element steps that were left out so far [-].
  ExpectedRun expected(double at_rest) const;

 private:
  double end_, shrinking_;
  std::int64_t most_steps_;
  bool meets_;
  std::vector<RunPlace> places_;
};

}  // namespace pinball
