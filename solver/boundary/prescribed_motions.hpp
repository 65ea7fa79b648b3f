#pragma once

#include <vector>

#include <kernels/boundary/external_work.hpp>
#include <solver/model/model.hpp>

namespace pinball {

/// The factor of a velocity that is given over time: the mean over the coming step, so that places are those of the
/// integral of the table, or the velocity where that has no length; of a displacement the mean over the step before
/// then [-]. A displacement is that of its table from the start of `when` to its end, wherever between two steps these
/// lie: the first step makes up for what has been done before it.
double mean_factor(const TimeTable& table, MotionQuantity quantity, const TimeSpan& when, double time,
                   const StepLengths& step);

/// How much mean_factor changes from the step before `time` to that from `later` on; where none is before, from that
/// from `time` on, of an acceleration from the velocity at `time` [-].
double factor_change(const TimeTable& table, MotionQuantity quantity, const TimeSpan& when, double time, double later,
                     const StepLengths& step);
/// Of an acceleration to the coming step. It is added to the velocity that is there, whatever that is and whenever the
/// motion begins [-].
inline double factor_change(const TimeTable& table, const TimeSpan& when, double time, const StepLengths& step) {
  return factor_change(table, MotionQuantity::acceleration, when, time, time, step);
}

/// The velocities that [[prescribed_velocity]] gives to nodes over time, and how far they leap.
class PrescribedMotions {
 public:
  template <class S>
  explicit PrescribedMotions(const Model<S>& model);

  /// Of each the factor of its velocity (mean_factor), of an acceleration that of the change of it (factor_change).
  std::vector<double> factors(double time, const StepLengths& step) const;
  /// Largest change that nodes which are moved, or held, undergo as the run begins [length/time].
  double leap_at_start() const { return leap_at_start_; }
  /// Kinetic energy that constraints take as the run begins [energy].
  double stopped_at_start() const { return stopped_at_start_; }
  /// Largest change that nodes undergo which these hold or move from a time on, from the velocities of the model
  /// [length/time].
  template <class S>
  double leap_of(const Model<S>& model, const HeldNodes<S>& held, double time, const StepLengths& step) const;
  /// Largest change from the step before `time` to that from `later` on, of motions that act in both, and of
  /// accelerations that begin between [length/time].
  double leap(double time, double later, const StepLengths& step) const;

 private:
  std::vector<PrescribedVelocity> given_;
  double leap_at_start_ = 0, stopped_at_start_ = 0;
};

}  // namespace pinball
