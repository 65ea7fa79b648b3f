#pragma once

#include <algorithm>

#include <solver/base/state_archive.hpp>
#include <solver/contact/algorithm/contact_ledger.hpp>
#include <solver/elements/internal_forces.hpp>
#include <solver/results.hpp>

namespace pinball {

/// The energies of a run, at the time of the forces, and how well they balance.
class EnergyLedger {
 public:
  const Energies& energies() const { return energies_; }
  double initial() const { return initial_; }  ///< total of the first step
  /// Relative to the initial total or the largest work from outside, whichever is larger [-].
  double balance_error() const;
  double balance_error_max() const { return balance_error_max_; }  ///< largest absolute value so far

  double difference() const { return energies_.total() - initial_; }  ///< what the balance is off by [energy]
  /// What is in motion in its own frame at the start, or the largest work from outside, whichever is larger [energy].
  double in_motion() const { return std::max(in_motion_, external_max_); }
  /// As balance_error, but relative to in_motion(), so that it does not depend on who watches [-].
  double balance_error_in_motion() const;
  double balance_error_in_motion_max() const { return balance_error_in_motion_max_; }

  /// Adds what a step has done. external: all work from outside so far; dt_before: the step that led to the forces.
  void book(const ElementWork& elements, const ContactWork& contact, double external, double dt_before);
  /// Before the first close(). drift: kinetic energy that all has by moving together [energy]; rounding: the part of it
  /// below which what is left over is no more than what the numbers are rounded by [-]; at_rest: what rounding alone
  /// moves [energy].
  void set_drift(double drift, double rounding, double at_rest = 0);
  /// Before the first step: what initial stresses have stored [energy].
  void begin_with(double internal) { energies_.internal = internal; }
  /// Where all elements are at one time: the total, and how far it is off.
  void close(bool first, double kinetic);

  void persist(StateArchive& archive) {
    contact_.persist(archive);
    archive(energies_, initial_, external_max_, balance_error_max_);
    archive(drift_, least_in_motion_, in_motion_, balance_error_in_motion_max_);
  }

 private:
  Energies energies_;
  ContactLedger contact_;
  double initial_ = 0, external_max_ = 0, balance_error_max_ = 0;
  double drift_ = 0, least_in_motion_ = 0, in_motion_ = 0, balance_error_in_motion_max_ = 0;
};

}  // namespace pinball
