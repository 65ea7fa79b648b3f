#include "energy_watch.hpp"

#include <algorithm>
#include <cmath>

#include <solver/results/sound_bounds.hpp>

namespace pinball {

void EnergyWatch::look(const EnergyLedger& ledger, double sound_swallowing, double time) {
  const Energies& energies = ledger.energies();
  in_motion_ = ledger.in_motion();
  hourglass_measure_ =
      std::max({hourglass_measure_, energies.internal + energies.eroded, sound::least_internal * in_motion_});
  look(Watched::balance, std::abs(ledger.difference()), sound::balance * in_motion_, time);
  look(Watched::contact_created, contact_ ? -energies.contact() : 0.0, sound::contact_created * in_motion_, time);
  look(Watched::contact_swallowed, energies.contact_damped,
       sound_swallowing > 0 ? sound_swallowing * in_motion_ : HUGE_VAL, time);
  look(Watched::hourglass_created, -energies.hourglass, sound::hourglass_created * hourglass_measure_, time);
  look(Watched::hourglass_large, energies.hourglass, sound::hourglass * hourglass_measure_, time);
  look(Watched::hourglass_plastic, energies.hourglass_plastic, sound::hourglass_plastic * hourglass_measure_, time);
  look(Watched::kinetic_below_zero, -energies.kinetic, sound::kinetic_below_zero * in_motion_, time);
  look(Watched::internal_below_zero, -energies.internal, sound::internal_below_zero * in_motion_, time);
}

void EnergyWatch::look(Watched kind, double energy, double bound, double time) {
  Item& item = items_[static_cast<std::size_t>(kind)];
  item.largest = std::max(item.largest, energy);
  item.present = energy;
  const bool beyond = energy > bound;
  item.since_now = beyond && item.beyond == 0 ? 1 : 0;
  if (item.since_now != 0) item.since = time;
  item.beyond = beyond ? 1 : 0;
}

double EnergyWatch::share(Watched kind) const {
  const bool hourglass =
      kind == Watched::hourglass_created || kind == Watched::hourglass_large || kind == Watched::hourglass_plastic;
  const double measure = hourglass ? hourglass_measure_ : in_motion_;
  const double energy = kind == Watched::contact_swallowed ? std::max(0.0, of(kind).present) : of(kind).largest;
  return measure > 0 ? energy / measure : 0.0;
}

}  // namespace pinball
