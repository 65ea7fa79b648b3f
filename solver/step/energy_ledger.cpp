#include "energy_ledger.hpp"

#include <algorithm>
#include <cmath>

namespace pinball {

namespace {

double relative(double difference, double scale) {
  return scale > 0 ? difference / scale : difference == 0 ? 0.0 : std::copysign(1.0, difference);
}

}  // namespace

double EnergyLedger::balance_error() const { return relative(difference(), std::max(initial_, external_max_)); }

double EnergyLedger::balance_error_in_motion() const { return relative(difference(), in_motion()); }

void EnergyLedger::set_drift(double drift, double rounding, double at_rest) {
  drift_ = drift;
  least_in_motion_ = std::max(rounding * drift, at_rest);
}

void EnergyLedger::book(const ElementWork& elements, const ContactWork& contact, double external, double dt_before) {
  energies_.internal += elements.internal - elements.eroded;
  energies_.hourglass += elements.hourglass;
  energies_.hourglass_plastic += elements.hourglass_plastic;
  energies_.bulk_viscosity += elements.viscous;
  energies_.folding = elements.folding;
  energies_.eroded += elements.eroded + contact.eroded;
  energies_.contact_stored = contact.stored;
  contact_.book(contact, dt_before);
  energies_.contact_damped = contact_.dissipated();
  energies_.external = external;
  external_max_ = std::max(external_max_, std::abs(external));
}

void EnergyLedger::close(bool first, double kinetic) {
  energies_.kinetic = kinetic;
  if (first) {
    initial_ = energies_.total();
    in_motion_ = std::max(initial_ - drift_, least_in_motion_);
  }
  balance_error_max_ = std::max(balance_error_max_, std::abs(balance_error()));
  balance_error_in_motion_max_ = std::max(balance_error_in_motion_max_, std::abs(balance_error_in_motion()));
}

}  // namespace pinball
