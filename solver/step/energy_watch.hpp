#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <solver/base/state_archive.hpp>

#include "energy_ledger.hpp"

namespace pinball {

/// What a run is watched for (results/sound_bounds.hpp tells what is sound).
enum class Watched {
  balance,
  contact_created,
  contact_swallowed,
  hourglass_created,
  hourglass_large,
  hourglass_plastic,
  kinetic_below_zero,
  internal_below_zero
};

/// Energies that should be small, of which a warning at the end tells how large they got, since when and where.
///
/// Energies that arise with the work of a load or of a wall are compared with the work done so far, which is
/// next to nothing in the first steps: what counts is when they went beyond their bound for the last time, and at the
/// end their largest value over that of what they are compared with.
class EnergyWatch {
 public:
  static constexpr std::size_t kinds = 8;

  /// contact: whether there is any. Of the energy of ties alone, which what turns or stretches has more of as soon as
  /// they lump its masses (TiedNodes), nothing is told.
  explicit EnergyWatch(bool contact = true) : contact_(contact) {}

  /// All energies are at one time. sound_swallowing: bound of what contact swallows, of the energy in motion, 0: none
  /// [-]; time: of the forces.
  void look(const EnergyLedger& ledger, double sound_swallowing, double time);
  /// Whether one has gone beyond its bound at the last look: then its place is asked for.
  bool just_beyond(Watched kind) const { return of(kind).since_now != 0; }
  /// place: number of the node or slot where it is worst.
  void set_place(Watched kind, std::int64_t place) { items_[static_cast<std::size_t>(kind)].place = place; }

  /// Largest energy over that with which it is compared, both of the whole run. What contact has swallowed is that of
  /// the last look: impulses give back when bodies part what they take when they meet [-].
  double share(Watched kind) const;
  double since(Watched kind) const { return of(kind).since; }        ///< when it last went beyond its bound [time]
  std::int64_t place(Watched kind) const { return of(kind).place; }  ///< as it was set; negative: it never was

  void persist(StateArchive& archive) { archive(items_, in_motion_, hourglass_measure_); }

 private:
  struct Item {
    double largest = 0, present = 0, since = 0;
    std::int64_t place = -1;
    std::int32_t beyond = 0, since_now = 0;  // whether; no padding in what is saved
  };
  const Item& of(Watched kind) const { return items_[static_cast<std::size_t>(kind)]; }
  void look(Watched kind, double energy, double bound, double time);

  bool contact_;
  std::array<Item, kinds> items_;
  double in_motion_ = 0, hourglass_measure_ = 0;  ///< what the energies are compared with, so far [energy]
};

}  // namespace pinball
