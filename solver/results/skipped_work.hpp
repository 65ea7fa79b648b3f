#pragma once

#include <algorithm>
#include <cstdint>

#include <solver/base/iteration_counts.hpp>
#include <solver/model/stores.hpp>
#include <solver/results.hpp>

#include "timers.hpp"

namespace pinball {

/// Bytes of the element arrays that the scene's features need not have.
inline double bytes_not_stored(const ElementStore& store) {
  int numbers = 0;  // per element
  if (store.plastic_strain.empty()) numbers += 1;
  if (store.hourglass_state.empty()) numbers += 12;
  if (store.viscous_stress.empty()) numbers += 1;
  if (store.internal_energy.empty()) numbers += 1;
  return static_cast<double>(numbers) * static_cast<double>(store.slots) *
         (store.single ? sizeof(float) : sizeof(double));
}

/// What the steps of a run have done and left out, counted by Solver.
struct WorkCounts {
  std::int64_t resting_element_steps = 0;    ///< left out, because the tile rests
  std::int64_t subcycled_element_steps = 0;  ///< left out, because the element makes a larger step
  std::int64_t eroded_element_steps = 0;
  std::int64_t rigid_element_steps = 0;    ///< of rigid bodies, which no kernel works
  std::int64_t surface_element_steps = 0;  ///< of pinballs, or elements with segments
  std::int64_t inner_element_steps = 0;    ///< of elements without an exposed face, in a scene with contact
  std::int64_t searches = 0, searches_skipped = 0;
  double search_seconds = 0;  ///< of the steps that searched
  IterationCounts iterations;
};

/// Estimates from what the run itself has measured of the work that it did.
inline SkippedSeconds estimate_skipped(const WorkCounts& counts, const Timers& timers, std::int64_t all_element_steps) {
  const auto share = [](double seconds, std::int64_t done, std::int64_t skipped) {
    return done > 0 ? seconds * static_cast<double>(skipped) / static_cast<double>(done) : 0.0;
  };
  SkippedSeconds s;
  const std::int64_t computed =
      all_element_steps - counts.resting_element_steps - counts.subcycled_element_steps - counts.rigid_element_steps;
  s.resting = share(timers.seconds(Phase::internal_forces), computed, counts.resting_element_steps);
  s.subcycling = share(timers.seconds(Phase::internal_forces), computed, counts.subcycled_element_steps);
  // A step that does not search still asks whether the lists hold.
  const double checks = timers.seconds(Phase::contact_search) - counts.search_seconds;
  s.searches = std::max(0.0, share(counts.search_seconds, counts.searches, counts.searches_skipped) - checks);
  s.inner_elements = share(timers.seconds(Phase::pinballs) + timers.seconds(Phase::contact_search),
                           counts.surface_element_steps, counts.inner_element_steps);
  return s;
}

}  // namespace pinball
