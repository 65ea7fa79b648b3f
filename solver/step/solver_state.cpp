#include <algorithm>

#include <solver/base/built_features.hpp>
#include <solver/base/error.hpp>

#include "impact_speed.hpp"
#include "integration.hpp"
#include "solver.hpp"

/// The state of a solver between its steps: who changes it, what is told of it, and how it is saved.
namespace pinball {

template <class S>
Model<S>& Solver<S>::change_model() {
  schedule_.forget_resting();
  space_->bring_back();
  space_->host_has_changed();
  return model_;
}

template <class S>
Array<S>& Solver<S>::change_velocities() {
  if (subcycling() != nullptr) {
    throw InputError("velocities: expected time.subcycling = false, with it they cannot be changed");
  }
  Model<S>& model = change_model();
  if (!changed_velocities_.any()) {
    changed_velocities_.keep(model);
    if (tied_.any()) tied_.keep_velocities(model);
  }
  return model.nodes.velocity;
}

/// Before the first step they are those that the run begins with.
template <class S>
void Solver<S>::take_first_velocities() {
  changed_velocities_.forget();
  take_velocities_of_host();
  initial_momentum_ = momentum();
}

/// Of nodes that go with others: rigid bodies, and faces that nodes are tied to.
template <class S>
void Solver<S>::take_velocities_of_host() {
  if (rigid_.any()) rigid_.take_velocities(model_);
  if (tied_.any()) tied_.take_velocities(model_);
  schedule_.forget_resting();
  contact_.forget_lists();
  if (contact() != nullptr) clock_.limit_by_impact_speed(longest_contact_step(model_));
}

template <class S>
void Solver<S>::begin_change_of_velocities() {
  changed_velocities_.exchange(model_);
  const double beside = rigid_.kinetic_beside({});
  take_velocities_of_host();
  boundary_.add_work(changed_velocities_.begin(model_) + rigid_.kinetic_beside({}) - beside);
  given_leap_.join(unequal_velocities(model_, changed_velocities_.changes()));
  space_->take_velocities();
}

template <class S>
void Solver<S>::end_change_of_velocities() {
  if (!changed_velocities_.any()) return;
  std::vector<S> memory;
  boundary_.add_work(changed_velocities_.end(space_->forces(memory), clock_.dt()));
}

template <class S>
Point Solver<S>::way_ahead(std::int32_t node) const {
  const double time = schedule_.steps_ahead(node) * clock_.dt();
  const S* const v = changed_velocities_.of_last_step(model_, node);
  return {time * v[0], time * v[1], time * v[2]};
}

/// Nodes of rigid bodies that turn do not come back on straight ways.
template <class S>
Point Solver<S>::watched_way_ahead(std::int32_t node) const {
  const std::optional<Point> then = rigid_.position_of_forces(node);
  if (!then) return way_ahead(node);
  const S* const x = model_.nodes.position_of(node);
  return {x[0] - (*then)[0], x[1] - (*then)[1], x[2] - (*then)[2]};
}

template <class S>
Point Solver<S>::momentum() const {
  const VectorSum of_nodes = motion_->momentum(space_->nodes_for_output());
  const Point beside = rigid_.momentum_beside();
  return {of_nodes.x + beside[0], of_nodes.y + beside[1], of_nodes.z + beside[2]};
}

template <class S>
std::vector<BodyShare> Solver<S>::body_shares() const {
  if (!body_energies_.any()) return {};
  return body_energies_.results(space_->nodes_for_output());
}

template <class S>
std::vector<double> Solver<S>::probe_values() const {
  space_->show_watched(probes_.nodes(model_), probes_.slots(model_));
  return probes_.values(model_, [this](std::int32_t node) { return watched_way_ahead(node); });
}

template <class S>
std::vector<ProbeResult> Solver<S>::probe_results() const {
  return probes_.results(model(), [this](std::int32_t node) { return watched_way_ahead(node); });
}

template <class S>
Array<S>& Solver<S>::host_forces() {
  if (!built::boundary_conditions) {
    throw InputError("external forces: this library was built without boundary conditions (PINBALL_WITHOUT)");
  }
  return boundary_.host_forces(model_);
}

template <class S>
std::vector<ForceResult> Solver<S>::named_forces() const {
  std::vector<ForceResult> forces = boundary_.forces(model_);
  symmetry_walls_.add_forces(forces);
  rigid_at_planes_.add_forces(rigid_.results(), forces);
  return forces;
}

/// Pairs and walls begin to act in the step whose forces belong to the present time.
template <class S>
void Solver<S>::look_at_begun_contact() {
  const double before = clock_.force_time(), time = clock_.time();
  if (boundary_.walls_begin(before, time))
    begun_overlaps_.take_passed_walls(boundary_.passed_by_begun_walls(model(), before, time));
  if (contact() == nullptr || !BegunOverlaps::begins(model_.scene, before, time)) return;
  look_at_present_mesh([&] { begun_overlaps_.look(model_.scene, model_.mesh, before, time); });
}

template <class S>
std::size_t Solver<S>::bytes() const {
  return model_.bytes() + internal_forces_.bytes() + schedule_.bytes() + contact_.bytes() + symmetry_walls_.bytes() +
         boundary_.bytes() + equations_.bytes() + tied_.bytes() + rigid_.bytes() + body_energies_.bytes() +
         space_->bytes() + changed_velocities_.bytes() + (domain_ ? domain_->bytes() : 0);
}

template <class S>
void Solver<S>::persist(StateArchive& archive) {
  if (!archive.reads()) {
    space_->bring_back();
    space_->bring_back_resting();
  }
  model_.persist(archive);
  if (archive.reads()) space_->host_has_changed();
  internal_forces_.persist(archive, model_);
  schedule_.persist(archive, model_);
  boundary_.persist(archive, model_);
  symmetry_walls_.persist(archive);
  if (archive.reads()) {
    contact_.take_held_directions(model_);
    equations_.take_held_directions(model_);
  }
  equations_.persist(archive);
  tied_.persist(archive, model_);
  if (archive.reads() && tied_.any()) contact_.set_ties(tied_.nodes(), false);
  rigid_.persist(archive);
  contact_.persist(archive, model_);
  clock_.persist(archive);
  ledger_.persist(archive);
  body_energies_.persist(archive);
  watch_.persist(archive);
  inside_out_.persist(archive);
  counts_.persist(archive);
  timers_.persist(archive);
  changed_velocities_.persist(archive, model_);
  archive(initial_momentum_);
  begun_overlaps_.persist(archive, model_.nodes.count);
  if (!archive.reads()) return;
  check_places(archive);
  choose_common_nodes();
  if (!domain_) return;
  domain_->connect_sums(model_);
  domain_->state_was_read(model_);
}

/// What a state says of places where something happened is looked up for messages and for the summary, which multiplies
/// steps by elements, too.
template <class S>
void Solver<S>::check_places(const StateArchive& archive) const {
  archive.require(model_.may_be_place(clock_.limiting_slot()) && model_.may_be_place(inside_out_.first_slot()) &&
                  counts_.deepest_node() < model_.nodes.count &&
                  clock_.steps() <= RunCounts::most / std::max<std::int64_t>(1, model_.element_count()));
  for (const Watched kind : {Watched::balance, Watched::hourglass_created, Watched::hourglass_large,
                             Watched::hourglass_plastic, Watched::kinetic_below_zero, Watched::internal_below_zero}) {
    archive.require(model_.may_be_place(watch_.place(kind)));
  }
  for (const Watched kind : {Watched::contact_created, Watched::contact_swallowed}) {
    archive.require(watch_.place(kind) < model_.nodes.count);
  }
}

template Model<double>& Solver<double>::change_model();
template Model<float>& Solver<float>::change_model();
template Array<double>& Solver<double>::change_velocities();
template Array<float>& Solver<float>::change_velocities();
template void Solver<double>::take_first_velocities();
template void Solver<double>::begin_change_of_velocities();
template void Solver<double>::end_change_of_velocities();
template void Solver<float>::take_first_velocities();
template void Solver<float>::begin_change_of_velocities();
template void Solver<float>::end_change_of_velocities();
template Point Solver<double>::way_ahead(std::int32_t) const;
template Point Solver<float>::way_ahead(std::int32_t) const;
template Point Solver<double>::momentum() const;
template Point Solver<float>::momentum() const;
template std::vector<BodyShare> Solver<double>::body_shares() const;
template std::vector<BodyShare> Solver<float>::body_shares() const;
template std::vector<double> Solver<double>::probe_values() const;
template std::vector<double> Solver<float>::probe_values() const;
template std::vector<ProbeResult> Solver<double>::probe_results() const;
template std::vector<ProbeResult> Solver<float>::probe_results() const;
template std::vector<ForceResult> Solver<double>::named_forces() const;
template std::vector<ForceResult> Solver<float>::named_forces() const;
template void Solver<double>::look_at_begun_contact();
template void Solver<float>::look_at_begun_contact();
template Array<double>& Solver<double>::host_forces();
template Array<float>& Solver<float>::host_forces();
template std::size_t Solver<double>::bytes() const;
template std::size_t Solver<float>::bytes() const;
template void Solver<double>::persist(StateArchive&);
template void Solver<float>::persist(StateArchive&);
template void Solver<double>::check_places(const StateArchive&) const;
template void Solver<float>::check_places(const StateArchive&) const;

}  // namespace pinball
