#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <solver/base/built_features.hpp>
#include <solver/contact/algorithm/contact_algorithm.hpp>
#include <solver/device/step_space.hpp>
#include <solver/model/model_surface.hpp>
#include <solver/results/timers.hpp>

#include "pair_ledger.hpp"
#include "run_counts.hpp"

namespace pinball {

/// The contact of a step, timed by its parts. A scene without contact has none of it.
template <class S>
class ContactStage {
 public:
  /// space: of the step; has to stay where it is.
  ContactStage(const Model<S>& model, StepSpace<S>& space)
      : space_(space),
        contact_(make_model_contact(model)),
        pairs_(contact_ ? model.scene.contact_pairs : std::vector<ContactPair>()) {
    std::unique_ptr<PinballKernels<S>> kernels = space.pinball_kernels();
    // Impulses on tied nodes are those of the corners of their faces, and rigid bodies have all common nodes shown.
    const bool alone = model.scene.tied_contacts.empty() && model.rigid.empty();
    in_space_ = contact_ && kernels && (alone || !acts_on_velocities()) && contact_->work_with(kernels);
  }

  const ContactAlgorithm<S>* contact() const { return contact_.get(); }
  /// Whether after_constraints adds forces, some of them perhaps in held directions.
  bool acts_on_velocities() const { return built::contact && contact_ && contact_->acts_on_velocities(); }
  /// sides: of rigid bodies; have to stay where they are.
  void set_rigid_sides(const RigidSides& sides) {
    if (contact_) contact_->set_rigid_sides(&sides);
  }
  /// Velocities were changed by others: lists that were built for those that were there may not hold.
  void forget_lists() {
    if (contact_) contact_->forget_lists();
  }
  /// Elements that take part; negative without contact.
  std::int64_t surface_elements() const { return built::contact && contact_ ? contact_->surface_elements() : -1; }
  void set_ties(const TiedNodes<S>& ties, bool changed) {
    if (contact_) contact_->set_ties(ties, changed);
  }
  /// Surface, search, and what acts before constraints do: penalty forces, added to the nodes. time: of the forces; dt:
  /// the step just made [time]; coming: what the next one may bring.
  ContactWork before_constraints(Model<S>& model, double time, double dt, const ComingStep& coming, Timers& timers,
                                 RunCounts& counts);
  /// Brings what after_constraints reads of impulse_nodes() up to date in the model.
  void show_impulse_nodes() { show(NodeNumbers::all, false); }
  /// What acts on velocities that constraints leave: impulses, as forces added to the nodes. bounds: of
  /// impulse_nodes(), by what stops them afterwards.
  ContactWork after_constraints(Model<S>& model, const StepLengths& step, std::span<const NodeBound> bounds,
                                Timers& timers);
  /// Whether there were bounds of nodes that it pushes; then, when walls have acted.
  bool was_bounded() const { return acts_on_velocities() && contact_->was_bounded(); }
  void follow_bounds(Model<S>& model, const StepLengths& step) {
    show_impulse_nodes();
    contact_->follow_bounds(ModelSurface<S>(model), step);
  }
  /// Nodes to which after_constraints will add.
  std::span<const std::int32_t> impulse_nodes() const {
    return acts_on_velocities() ? std::span<const std::int32_t>(contact_->impulse_nodes())
                                : std::span<const std::int32_t>();
  }

  /// Force and impulse of each pair of the scene.
  const std::vector<PairResult>& pairs() const { return pairs_.results(); }
  /// To be called when constraints have begun or ended.
  void take_held_directions(const Model<S>& model) {
    if (built::contact && contact_) contact_->take_held_directions(held_directions(model));
  }

  void persist(StateArchive& archive, const Model<S>& model) {
    pairs_.persist(archive);
    if (contact_) contact_->persist(archive, ModelSurface<S>(model));
  }
  std::size_t bytes() const { return contact_ ? contact_->bytes() : 0; }

 private:
  /// Brings what impulses read in the model up to date there. any: of any node that they may touch.
  void show(NodeNumbers numbers, bool any);

  StepSpace<S>& space_;
  std::unique_ptr<ContactAlgorithm<S>> contact_;
  PairLedger pairs_;
  bool in_space_ = false;     ///< the loops of contact run there
  std::int64_t choices_ = 0;  ///< of nodes that contact reads, when the space was told of them
};

}  // namespace pinball
