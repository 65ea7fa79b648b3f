#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <kernels/boundary/node_arrays.hpp>
#include <kernels/node_update.hpp>
#include <solver/base/piece_share.hpp>
#include <solver/boundary/space/boundary_kernels.hpp>
#include <solver/contact/algorithm/pinball_kernels.hpp>
#include <solver/contact/surface/surface.hpp>
#include <solver/elements/internal_forces.hpp>
#include <solver/elements/schedule.hpp>

#include "body_sums.hpp"
#include "common_numbers.hpp"

namespace pinball {

/// Where the arrays of a run lie and its loops over all elements and nodes run: the host's threads, alone or as one of
/// several ranks, or a device. A step asks for all of it in the same words.
///
/// Contact, ties and rigid bodies work on the model, in the memory of the host, and there on some nodes alone: the
/// common ones, or, where lists of what may touch hold, those in the lists; but for what contact does in such steps
/// where there are kernels for it. What they read of these has to be shown to them before, and what they have changed
/// to be taken after; the host's own space has nothing to do for either.
template <class S>
class StepSpace {
 public:
  virtual ~StepSpace() = default;

  // ---- Loops over all elements and nodes ----

  virtual std::unique_ptr<BoundaryKernels<S>> boundary_kernels() const = 0;
  /// Null: contact has its own, on the host.
  virtual std::unique_ptr<PinballKernels<S>> pinball_kernels() const = 0;
  /// What these work on, with all that was taken. changes: what they are going to change.
  virtual NodeArrays<S> nodes(NodeNumbers changes) = 0;
  /// Adds the internal forces of what is due to the nodes and updates element states (InternalForces::compute).
  /// step: the one just made; more_forces: others are added to those of nodes before these are integrated.
  virtual InternalForceResult<S> update_elements(const Due& due, const ElementStep<S>& step, bool more_forces) = 0;
  /// Velocities and positions of the nodes that are due, and zero forces.
  virtual MotionEnergy integrate(const Due& due, const StepLengths& step) = 0;

  // ---- Stages that work on the model ----

  /// Nodes that they read and move; some perhaps several times, or common already. Before the first step.
  virtual void add_common(std::span<const std::int32_t> nodes) = 0;
  /// The same in the middle of a step, which shows all numbers of those that are new.
  virtual void take_in(std::span<const std::int32_t> nodes) = 0;
  /// Brings these numbers of the common nodes up to date in the model.
  virtual void show(NodeNumbers numbers) = 0;
  /// The model has newer ones of them.
  virtual void take(NodeNumbers changed) = 0;
  /// From now on these of the common nodes are the listed ones, whose numbers can be shown and taken without those of
  /// the others. Each once.
  virtual void list(std::span<const std::int32_t> nodes) = 0;
  virtual void show_listed(NodeNumbers numbers) = 0;
  /// They have been shown.
  virtual void take_listed(NodeNumbers changed) = 0;
  /// Processes that have the same of these and may work loops over them together; null: this one is alone.
  virtual Sharers* sharers() { return nullptr; }
  /// Masses of nodes have been changed in the model.
  virtual void take_masses() = 0;
  /// Slots of elements that have eroded in the last update, ascending, perhaps with padding and others that are no
  /// longer alive; in the model they have no mass.
  virtual std::vector<std::int64_t> eroded_slots() = 0;
  /// Brings up to date the plastic strains of the surface, from which contact guesses what erodes next.
  virtual void show_strains(const Surface& surface) = 0;

  /// Of several ranks: motion and forces of all nodes go to all, in the middle of a step.
  virtual void bring_nodes() = 0;

  // ---- Of one process, in a step that began with what a host has changed ----

  /// Velocities of the model are newer, of all nodes.
  virtual void take_velocities() = 0;
  /// Forces of all nodes, in records of four; memory: that they may be put into.
  virtual const S* forces(std::vector<S>& memory) = 0;

  // ---- What output asks for, without the whole state ----

  /// Nodes for sums; of several ranks, those of all are here then.
  virtual NodeArrays<S> nodes_for_output() = 0;
  /// Per body of the scene.
  virtual std::vector<BodySum> body_sums() = 0;
  /// What the elements of each body did in the last update, where output.body_energies asks for it.
  virtual std::vector<ElementWork> work_of_bodies() = 0;
  /// Brings the motion of some nodes, and stresses and plastic strains of some slots, up to date in the model.
  virtual void show_watched(std::span<const std::int32_t> nodes, std::span<const std::int64_t> slots) = 0;

  // ---- Between steps: the whole state ----

  /// Brings the state in the model up to date, where steps have changed it.
  virtual void bring_back() = 0;
  /// The same for which tiles rest.
  virtual void bring_back_resting() = 0;
  /// The state in the model has been changed: the next step begins with it.
  virtual void host_has_changed() = 0;
  virtual std::size_t bytes() const = 0;  ///< beside the stores of the model
};

}  // namespace pinball
