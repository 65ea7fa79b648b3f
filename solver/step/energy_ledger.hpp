#pragma once

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

  /// Adds what a step has done. external: all work from outside so far; dt_before: the step that led to the forces.
  void book(const ElementWork& elements, const ContactWork& contact, double external, double dt_before);
  /// Where all elements are at one time: the total, and how far it is off.
  void close(bool first, double kinetic);

  void persist(StateArchive& archive) {
    contact_.persist(archive);
    archive(energies_, initial_, external_max_, balance_error_max_);
  }

 private:
  Energies energies_;
  ContactLedger contact_;
  double initial_ = 0, external_max_ = 0, balance_error_max_ = 0;
};

}  // namespace pinball
