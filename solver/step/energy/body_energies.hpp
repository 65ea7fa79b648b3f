#pragma once

#include <memory>
#include <vector>

#include <kernels/boundary/external_work.hpp>
#include <solver/base/state_archive.hpp>
#include <solver/elements/tile_kernels.hpp>
#include <solver/model/mass_shares.hpp>
#include <solver/parallel/subdomain.hpp>

namespace pinball {

/// What of a run's mass, momentum and energies is one body's.
struct BodyShare {
  double kinetic = 0, internal = 0, hourglass = 0, bulk_viscosity = 0;  ///< as in Energies [energy]
  double mass = 0;   ///< of all its elements, eroded ones too: their nodes move on [mass]
  Point momentum{};  ///< [mass length/time]
};

/// Energies and momentum of each body (output.body_energies): sums over its tiles, and over its nodes with its share of
/// what they have. Of a node that several bodies have, each has the share that its elements have in the mass of all
/// elements around it, so that the bodies together are the totals. The kinetic energy is of the masses as they move:
/// that of tied nodes is in the corners of the faces that they follow; momentum and mass are those of the body's own
/// elements.
template <class S>
class BodyEnergies {
 public:
  /// Of nothing where the scene does not ask for it. domain: of several ranks, which share the sums; null: one process
  /// has all.
  explicit BodyEnergies(const Model<S>& model, Subdomain<S>* domain = nullptr);
  bool any() const { return !shares_.empty(); }

  /// Adds what the tiles have done in a step.
  void book(const Model<S>& model, const std::vector<TileResult<S>>& tiles);
  /// Before the integration, when all forces are known: the kinetic energy at their time (node_update.hpp).
  void take_kinetic(const Model<S>& model, const StepLengths& step);

  std::vector<BodyShare> results(const Model<S>& model) const;
  void persist(StateArchive& archive) { archive.of_fixed_size(energies_); }
  std::size_t bytes() const;

 private:
  struct Sums {
    double kinetic = 0, internal = 0, hourglass = 0, bulk_viscosity = 0;
  };
  std::vector<MassShares> shares_;  ///< per body
  /// Per body the pieces of its sum, whose are which; empty: one process has all.
  std::vector<std::shared_ptr<const SharedBlocks>> pieces_;
  std::vector<std::vector<double>> mass_;  ///< of its nodes without ties [mass]
  std::vector<Sums> energies_;             ///< per body
};

}  // namespace pinball
