#include "solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <kernels/exec.hpp>
#include <kernels/node_update.hpp>
#include <solver/base/built_features.hpp>

#include "impact_speed.hpp"
#include "require_built.hpp"

namespace pinball {

template <class S>
Solver<S>::Solver(const Scene& scene)
    : model_(build_model<S>(scene)),
      internal_forces_(model_),
      symmetry_walls_(model_),
      boundary_(model_),
      probes_(model_),
      contact_(make_model_contact(model_)),
      longest_contact_step_(contact_ ? longest_contact_step(model_) : std::numeric_limits<double>::infinity()) {
  if (contact_) initial_overlap_ = find_initial_overlap(model_.mesh);
  require_built(model_, boundary_.any());
  initial_momentum_ = momentum();
  if (!model_.tile_levels.empty()) {
    const bool erodes = !model_.elements.internal_energy.empty();
    subcycling_.emplace(model_, erodes || model_.scene.damping.mass > 0);
  }
}

template <class S>
void Solver<S>::advance(bool last) {
  if (kinetic_before_change_) take_changed_velocities();
  if (subcycling_ && steps_ > 0) {
    for (std::int32_t step = 1; step < subcycling_->cycle_steps(); ++step) make_step(step, false);
  }
  make_step(0, last);
}

/// The explicit step of the report's figure 4, with its figure 3 for contact: the program's table of contents.
/// step_of_cycle: 0 where all elements are worked.
template <class S>
void Solver<S>::make_step(std::int32_t step_of_cycle, bool last) {
  const bool all = step_of_cycle == 0;
  const bool touching = built::contact && contact_, bounded = built::boundary_conditions && boundary_.any();

  // Figure 4, 1-2: external loads come with the other boundary conditions; node forces are zero between steps.

  // 3. Element stresses, internal forces and their assembly
  const InternalForceResult<S> internal = timers_.measure(Phase::internal_forces, [&] {
    if (!subcycling_) return internal_forces_.compute(model_, static_cast<S>(dt_));
    if (all && steps_ > 0 && !last) subcycling_->plan(internal_forces_.tiles(), contact_frequency2_);
    return internal_forces_.compute(model_, static_cast<S>(dt_), *subcycling_, step_of_cycle);
  });

  // 4. Contact forces
  ContactWork contact;
  const ModelSurface<S> contact_model(model_);
  if (touching) {
    timers_.measure(Phase::pinballs,
                    [&] { contact_->update_surface(contact_model, eroded_slots(model_, internal_forces_.tiles())); });
    search_contact(contact_model);
    contact = timers_.measure(Phase::contact_forces, [&] { return contact_->before_step(contact_model, dt_); });
    timers_.measure(Phase::contact_scatter, [&] { contact_->add_forces(contact_model, contact); });
  }

  // The largest step that elements and contact allow, for the whole cycle
  contact_frequency2_ = std::max(all ? 0.0 : contact_frequency2_, contact.frequency2);
  dt_before_ = dt_;
  if (all) timers_.measure(Phase::time_step, [&] { choose_time_step(internal, contact, last); });

  // Loads, constraints and prescribed velocities, then contact that acts on what they leave, then rigid walls
  const StepLengths step{dt_before_, dt_};
  if (bounded) {
    timers_.measure(Phase::boundary_conditions,
                    [&] { boundary_.apply(model_, time_, step, due_nodes(step_of_cycle)); });
  }
  if (touching && contact_->acts_on_velocities()) {
    contact += timers_.measure(Phase::contact_forces, [&] { return contact_->after_constraints(contact_model, step); });
    timers_.measure(Phase::contact_forces, [&] { boundary_.hold(model_, time_, step, due_nodes(step_of_cycle)); });
  }
  if (bounded) {
    timers_.measure(Phase::boundary_conditions, [&] { boundary_.complete(model_, step); });
  }

  // 5-6. Accelerations, velocities, displacements
  const double kinetic = timers_.measure(Phase::integration, [&] { return integrate(step_of_cycle); });

  // Energies at the time of the forces; the total only where all elements are at the same time
  force_time_ = time_;
  time_ = last ? time_ : time_ + dt_;
  energies_.internal += internal.internal - internal.eroded;
  energies_.hourglass += internal.hourglass;
  energies_.bulk_viscosity += internal.viscous;
  energies_.eroded += internal.eroded + contact.eroded;
  energies_.contact_stored = contact.stored;
  energies_.contact_damped += 0.5 * (damped_power_ + contact.damped_power) * dt_before_ + contact.dissipated;
  damped_power_ = contact.damped_power;
  energies_.external = boundary_.work();
  external_max_ = std::max(external_max_, std::abs(energies_.external));
  if (!last) {
    counts_.eroded_element_steps += eroded_elements_;
    counts_.resting_element_steps += internal.resting_elements;
    counts_.subcycled_element_steps += internal.subcycled_elements;
    if (touching) {
      const std::int64_t surface = contact_->surface_elements();
      counts_.surface_element_steps += surface;
      counts_.inner_element_steps += model_.element_count() - eroded_elements_ - surface;
    }
  }
  eroded_elements_ += internal.eroded_count;
  penetration_ratio_max_ = std::max(penetration_ratio_max_, contact.penetration_ratio);
  pairs_ = contact.pairs;
  pairs_max_ = std::max(pairs_max_, pairs_);
  check_volumes(internal);
  check_finite(kinetic + energies_.total());
  if (all) {
    energies_.kinetic = kinetic;
    if (steps_ == 0) initial_energy_ = energies_.total();
    balance_error_max_ = std::max(balance_error_max_, std::abs(balance_error()));
    check_energy();
    check_time_step();
  }
  if (!last) ++steps_;
}

/// Lists of what may touch; notes what building them has taken.
template <class S>
void Solver<S>::search_contact(const ModelSurface<S>& contact_model) {
  const std::int64_t searches = contact_->searches();
  const double seconds = timers_.seconds(Phase::contact_search);
  timers_.measure(Phase::contact_search, [&] { contact_->search(contact_model); });
  if (contact_->searches() > searches) counts_.search_seconds += timers_.seconds(Phase::contact_search) - seconds;
}

/// Sets dt_ for the coming step or cycle of steps.
template <class S>
void Solver<S>::choose_time_step(const InternalForceResult<S>& internal, const ContactWork& contact, bool last) {
  if (last) {
    dt_ = 0;
    return;
  }
  // Frequencies of elements and of contact add in squares: w^2 <= w_elements^2 + w_contact^2.
  const auto element_step = static_cast<double>(internal.time_step);
  const double element_frequency2 = 4.0 / (element_step * element_step);
  double stable = 2.0 / std::sqrt(element_frequency2 + contact.frequency2);
  std::int64_t slot = internal.time_step_slot;
  std::int32_t cycle_steps = 1;
  if (subcycling_) {
    subcycling_->begin_cycle(model_);
    const auto of_cycle = subcycling_->stable_step(internal_forces_.tiles(), contact.frequency2);
    stable = of_cycle.step;
    slot = of_cycle.slot;
    cycle_steps = subcycling_->cycle_steps();
  }
  const double chosen = std::min(model_.scene.time.cfl * stable, longest_contact_step_);
  // A step that followed the vibrations of its element would feed them: a free cube at strains of 1e-3 gained half its
  // energy in 70,000 steps. So the step is kept until it is too long, or well below what is allowed.
  constexpr double raised_from = 1.05;
  const bool keeps = dt_ > 0 && dt_ <= chosen && chosen < raised_from * dt_;
  // What remains is divided into equal steps (cycles), so that the last ones are not cut: a sudden change of the step
  // changes the energy of the fast modes that central differences keep, by the square of (dt x frequency).
  const double remaining = (model_.scene.time.end - time_) / cycle_steps;
  dt_ = remaining / std::max(1.0, std::ceil(remaining / (keeps ? dt_ : chosen) - 1e-9));
  dt_max_ = std::max(dt_max_, dt_);
  // The division says nothing about stability.
  if (dt_min_ == 0 || chosen < dt_min_) {
    dt_min_ = chosen;
    dt_limited_by_ = chosen == longest_contact_step_           ? "the speed of impact"
                     : contact.frequency2 > element_frequency2 ? "contact"
                                                               : element_name(slot);
  }
}

/// Accelerations, velocities and positions, of dt_; returns the kinetic energy at the time of the forces, of the nodes
/// that are integrated in this step of the cycle.
template <class S>
double Solver<S>::integrate(std::int32_t step_of_cycle) {
  const auto position_step = static_cast<S>(dt_), energy_step = static_cast<S>(dt_before_);
  const auto velocity_step = static_cast<S>(0.5 * (dt_before_ + dt_));
  const auto integrate_nodes = [&](std::int64_t begin, std::int64_t end, S way_step) {
    // Locals: as far as the compiler knows, stores to the arrays might change anything that is reached by reference.
    S* position = model_.nodes.position.data();
    S* velocity = model_.nodes.velocity.data();
    S* force = model_.nodes.force.data();
    const S* inverse_mass = model_.nodes.inverse_mass.data();
    const double* mass = model_.node_mass.data();
    const S steps[] = {velocity_step, way_step, energy_step};
    double sum = 0;
    for (std::int64_t n = begin; n < end; ++n) {
      const S v2 = integrate_node(position + 4 * n, velocity + 4 * n, force + 4 * n, inverse_mass[n], steps[0],
                                  steps[1], steps[2]);
      sum += mass[n] * static_cast<double>(v2);
    }
    return sum;
  };
  const DueSpans due = due_nodes(step_of_cycle);
  double twice_kinetic = 0;
  parallel_reduce(
      "integration", RangePolicy<>{0, span_count(model_.nodes.count)}, twice_kinetic,
      [&](std::int64_t begin, std::int64_t end, double& partial) {
        for (std::int64_t span = begin; span < end; ++span) {
          if (!due.contain(span)) continue;
          const std::int64_t first = span * nodes_per_span;
          const std::int64_t last = std::min<std::int64_t>(model_.nodes.count, first + nodes_per_span);
          partial += integrate_nodes(first, last, position_step * static_cast<S>(due.steps(span)));
        }
      },
      [](double& whole, double partial) { whole += partial; });
  if (subcycling_) subcycling_->count_step(model_.nodes);
  if (eroded_elements_ > 0) symmetry_walls_.reflect(model_, position_step);  // what erosion has set free
  return 0.5 * twice_kinetic;
}

template class Solver<double>;
template class Solver<float>;

}  // namespace pinball
