#pragma once

#include <optional>
#include <vector>

namespace pinball {

/// A run that came to its end.
struct MadeRun {
  double factor = 1;  ///< of the number of elements in each direction
  double elements = 0, steps = 0;
  double seconds = 0;  ///< of one thread
};

/// How long a run on another mesh takes, from those that were made.
///
/// Elements go with the third power of the factor and steps with the first. Small meshes gain from what a step costs
/// whatever its size, contact goes with the surface: so the exponent of the time is not 4. It is gone on with from the
/// two runs that are nearest in two ways, whose geometric mean counts, since one is too low where the other is too
/// high: by the power of the factor between them, and by the time of a step, as a part that is constant and one for
/// each element. So the runs of eight scenes were foretold within a factor of 1.4 (tests/program/run_times_test.cpp).
/// Of one run alone the exponent is 4, which for runs of milliseconds is too high, by 6 at worst.
class RunTimes {
 public:
  explicit RunTimes(std::vector<MadeRun> made);

  /// Of one thread [s]; none: no run was made.
  std::optional<double> expected(double factor) const;
  /// Of the mesh; none: no run was made.
  std::optional<double> elements(double factor) const;

 private:
  std::vector<MadeRun> made_;  ///< from coarse to fine
};

}  // namespace pinball
