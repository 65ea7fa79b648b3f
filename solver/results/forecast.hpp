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
  double time = 0;  ///< that it comes to: less than the scene's end where the number of steps is bounded [time]
};

/// Where the time of some steps went, in any unit.
struct StepPhases {
  double elements = 0, searches = 0, impulses = 0, others = 0;
  std::int64_t steps = 0, lists = 0;  ///< steps that were made, and lists of contact
  double iterations = 0;              ///< mean number of them [-]
  double of_list = 0;                 ///< where none was made: what one takes
  bool touching = true;               ///< some bodies are in contact

  /// What these would have taken later in a run, over what they took: lists serve 20 steps (horizon_steps) and not
  /// those few with which a run begins; impulses need the iterations of an impact at its beginning alone, later 10 in
  /// the mean (taylor_plate, crushed_tube, contact_patch, sliding_block, sphere_floor: 23, 4, 22, 12, 9); where
  /// nothing touches, what looks for contact has the first lists, before these know how little nodes stray; elements
  /// that rest wake. waking: times as many are updated.
  double settled(double waking) const;
};

/// How long a run will take, from how it has gone so far and from what is still to come.
///
/// Steps shrink with the elements that an impact squeezes: in the mean of the run by exp(0.6 e), where the plastic
/// strain e is what erodes the material, or 3.5 rho v^2 / Y of the impact where that is less, and 3.72 at most: 9.3
/// times. Bars that strike a wall or a plate make 8.5 to 10 times as many steps as with the longest of their first
/// (taylor_plate, taylor_bar, taylor_300.k), rods that erode at 2 make 2.8 and 3.4 times as many (3.3), a plate that
/// does at 0.5 makes 1.35 times as many (1.35). The further a run is, the more its last steps count instead. Elements
/// at rest wake in the first tenth of a run, or never; those that an impact makes yield take a quarter more
/// (taylor_bar: 0.21 ms a step at first, 0.35 later, rest among it). Contact that is still to come costs 0.2 of a step
/// times the part of the elements that lie on the surface; of a body with itself, which folds, 0.7 (crushed_tube); and
/// nothing where nothing is expected to meet (fragmenting_plate).
class Forecast {
 public:
  /// speed: of the fastest impact that is expected; 0: none is [length/time]
  /// surface: part of the elements that contact has on the surface; 0: there is no contact [-]
  Forecast(const Scene& scene, double speed, double surface);

  void take(const RunPlace& place);
  /// Of the whole run, after at least one place. at_rest: part of the element steps that were left out so far [-];
  /// phases: of the steps between the first and the last place, or nothing that is known of them.
  ExpectedRun expected(double at_rest, const StepPhases& phases = {}) const;

 private:
  /// After the first place, before which everything was built.
  double seconds_per_step() const;
  /// Of those that are still to be made [time]. trust: in the last ones, 0 to 1 [-].
  double length_of_steps(double trust) const;

  double end_, shrinking_;
  bool strikes_;    ///< an impact is expected
  double contact_;  ///< what it is still to cost, over a step
  std::int64_t most_steps_;
  std::vector<RunPlace> places_;
};

}  // namespace pinball
