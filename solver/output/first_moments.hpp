#pragma once

#include <chrono>
#include <string>

#include <solver/results/forecast.hpp>
#include <solver/simulation.hpp>

namespace pinball {

/// Looks at the first tenth of a second of a run, and says then how long it will take.
class FirstMoments {
 public:
  /// impact_speed: as of a Forecast.
  FirstMoments(const Simulation& simulation, double impact_speed);

  /// To be asked after each step. Once, when a tenth of a second is over, a sentence; else empty: also of a run that is
  /// complete before.
  std::string expected(const Simulation& simulation);

 private:
  using Clock = std::chrono::steady_clock;

  Forecast forecast_;
  Clock::time_point start_ = Clock::now();
  double noted_ = 0;  ///< [s]
  bool said_;
};

}  // namespace pinball
