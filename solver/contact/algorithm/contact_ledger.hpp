#pragma once

#include <solver/base/state_archive.hpp>

#include "contact_algorithm.hpp"

namespace pinball {

/// Energies that contact has taken out of a run, summed over its steps.
class ContactLedger {
 public:
  /// Books a step, all of its stages together. dt_before: the step just made, over which the power of the damping is
  /// summed by the trapezoidal rule [time].
  void book(const ContactWork& work, double dt_before) {
    dissipated_ += 0.5 * (damped_power_ + work.damped_power) * dt_before + work.dissipated;
    eroded_ += work.eroded;
    damped_power_ = work.damped_power;
  }
  double dissipated() const { return dissipated_; }  ///< by damping, impulses, friction, contacts that jumped [energy]
  double eroded() const { return eroded_; }          ///< of springs that went with eroded elements [energy]
  double damped_power() const { return damped_power_; }  ///< of the last step [power]
  void persist(StateArchive& archive) { archive(dissipated_, eroded_, damped_power_); }

 private:
  double dissipated_ = 0, eroded_ = 0, damped_power_ = 0;
};

}  // namespace pinball
