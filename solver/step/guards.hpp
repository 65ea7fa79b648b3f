#pragma once

#include <string>
#include <utility>
#include <vector>

#include <solver/elements/internal_forces.hpp>
#include <solver/model/model.hpp>

#include "energy_ledger.hpp"
#include "step_clock.hpp"

namespace pinball {

/// What ends a run that has gone wrong: each check throws RunError that says what, where, when and what to try. They
/// look at sums that the step has made anyway; where it went wrong is looked for only then.
template <class S>
class Guards {
 public:
  /// model: up to date where a number is not finite, or an element has no volume.
  Guards(const Model<S>& model, const StepClock& clock) : model_(model), clock_(clock) {}

  /// What is known to make the scene unstable: reported in place of other advice.
  void set_cause(std::string cause) { cause_ = std::move(cause); }

  /// Elements that are turned inside out, where they are not to be eroded for it.
  void check_volumes(const InternalForceResult<S>& element) const;
  /// Elements with a corner that has turned over, where element.inside_out is to stop the run.
  void check_inside_out(std::int64_t count) const;
  /// energy: a sum that every element and every node goes into. A number that is not finite reaches it in the step in
  /// which it arises, before it spreads to other elements.
  void check_finite(double energy) const;
  /// guard.energy_error, of what is in motion in its own frame
  void check_energy(const EnergyLedger& ledger) const;
  /// guard.time_step_collapse, and a step that does not move the time on
  void check_time_step() const;

 private:
  std::string when() const;
  [[noreturn]] void fail(const std::string& what, const std::string& advice) const;

  const Model<S>& model_;
  const StepClock& clock_;
  std::string cause_;
};

}  // namespace pinball
