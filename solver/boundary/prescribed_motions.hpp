#pragma once

#include <vector>

#include <kernels/boundary/external_work.hpp>
#include <solver/model/model.hpp>

namespace pinball {

/// The factor of a velocity that is given over time: the mean over the coming step, so that places are those of the
/// integral of the table, or the velocity where that has no length; of a displacement the mean over the step before
/// then [-].
double mean_factor(const TimeTable& table, MotionQuantity quantity, double time, const StepLengths& step);

/// Of an acceleration that is given over time: how much mean_factor changes from the step before to the coming one. It
/// is added to the velocity that is there, whatever that is and whenever the motion begins [-].
double factor_change(const TimeTable& table, double time, const StepLengths& step);

/// The velocities that [[prescribed_velocity]] gives to nodes over time, and how far they leap.
class PrescribedMotions {
 public:
  template <class S>
  explicit PrescribedMotions(const Model<S>& model);

  /// Of each the factor of its velocity (mean_factor), of an acceleration that of the change of it (factor_change).
  std::vector<double> factors(double time, const StepLengths& step) const;
  /// Largest change that nodes which are moved, or held, undergo as the run begins [length/time].
  double jump_at_start() const { return jump_at_start_; }
  /// Kinetic energy that constraints take as the run begins [energy].
  double stopped_at_start() const { return stopped_at_start_; }
  /// Largest change that nodes undergo which these hold or move from a time on [length/time].
  template <class S>
  double leap_of(const Model<S>& model, const HeldNodes<S>& held, double time, const StepLengths& step) const;
  /// Largest change of a velocity between two times, of motions that act at both [length/time].
  double jump(double from, double to) const;
  /// The same from the step just made to the coming one [length/time].
  double jump_now(double time, const StepLengths& step) const;

 private:
  std::vector<PrescribedVelocity> given_;
  double jump_at_start_ = 0, stopped_at_start_ = 0;
};

}  // namespace pinball
