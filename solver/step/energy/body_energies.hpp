#pragma once

#include <memory>
#include <vector>

#include <solver/base/state_archive.hpp>
#include <solver/boundary/space/boundary_kernels.hpp>
#include <solver/elements/internal_forces.hpp>

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
  /// Of nothing where the scene does not ask for it. kernels: of the space of the step.
  BodyEnergies(const Model<S>& model, const BoundaryKernels<S>& kernels);
  bool any() const { return !motion_.empty(); }

  /// Before the first step: what initial stresses have stored in each body; empty: nothing [energy].
  void begin_with(const std::vector<double>& internal);
  /// Adds what the elements of each body have done in a step.
  void book(const std::vector<ElementWork>& of_body);
  /// Before the integration, when all forces are known: the kinetic energy at their time (node_update.hpp).
  void take_kinetic(const NodeArrays<S>& nodes, const StepLengths& step);

  /// nodes: StepSpace::nodes_for_output().
  std::vector<BodyShare> results(const NodeArrays<S>& nodes) const;
  void persist(StateArchive& archive) { archive.of_fixed_size(energies_); }
  std::size_t bytes() const;

 private:
  struct Sums {
    double kinetic = 0, internal = 0, hourglass = 0, bulk_viscosity = 0;
  };
  std::vector<std::unique_ptr<NodeMotionKernels<S>>> motion_;  ///< per body
  std::vector<double> mass_;                                   ///< of each, without ties [mass]
  std::vector<Sums> energies_;                                 ///< per body
};

}  // namespace pinball
