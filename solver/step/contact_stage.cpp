#include "contact_stage.hpp"

#include "space_surface.hpp"

namespace pinball {

/// In the first steps, and where the surface changes, of any node.
template <class S>
void ContactStage<S>::show(NodeNumbers numbers, bool any) {
  if (!in_space_) {
    space_.show(numbers);
    return;
  }
  if (const std::int64_t choices = contact_->choices_of_read_nodes(); choices != choices_) {
    choices_ = choices;
    space_.list(contact_->read_nodes());
  }
  if (any || choices_ == 0) {
    space_.show(numbers);
  } else {
    space_.show_listed(numbers);
  }
}

template <class S>
ContactWork ContactStage<S>::before_constraints(Model<S>& model, double time, double dt, const ComingStep& coming,
                                                Timers& timers, RunCounts& counts) {
  if (!built::contact || !contact_) return {};
  contact_->set_time(time);
  contact_->expect(coming);
  const SpaceSurface<S> source(model, space_, contact_->surface(), in_space_);
  timers.measure(Phase::pinballs, [&] {
    const std::vector<std::int64_t> eroded = space_.eroded_slots();
    // Forces in the same copy, if impulses are likely to need them.
    const bool with_forces = !in_space_ || !impulse_nodes().empty();
    if (!in_space_ || contact_->acts_on_velocities()) {
      show(with_forces ? NodeNumbers::all : NodeNumbers::motion, !eroded.empty() || coming.stops);
    }
    contact_->update_surface(source, eroded);
  });
  const std::int64_t searches = contact_->searches();
  const double seconds = timers.seconds(Phase::contact_search);
  timers.measure(Phase::contact_search, [&] { contact_->search(source, dt); });
  if (contact_->searches() > searches) counts.count_search(timers.seconds(Phase::contact_search) - seconds);
  ContactWork work = timers.measure(Phase::contact_forces, [&] { return contact_->before_step(source, dt); });
  timers.measure(Phase::contact_scatter, [&] {
    contact_->add_forces(source, work);
    if (!in_space_ && !contact_->acts_on_velocities()) space_.take(NodeNumbers::force);
  });
  return work;
}

template <class S>
ContactWork ContactStage<S>::after_constraints(Model<S>& model, const StepLengths& step,
                                               std::span<const NodeBound> bounds, Timers& timers) {
  if (!built::contact || !contact_) return {};
  return timers.measure(Phase::contact_forces, [&] {
    const bool adds = !impulse_nodes().empty();
    const ContactWork work = contact_->after_constraints(ModelSurface<S>(model), step, bounds);
    if (adds && in_space_) space_.take_listed(NodeNumbers::force);
    if (adds && !in_space_) space_.take(NodeNumbers::force);
    if (pairs_.any()) pairs_.book([this](std::vector<Point>& sums) { contact_->add_pair_forces(sums); }, step);
    return work;
  });
}

template class ContactStage<double>;
template class ContactStage<float>;

}  // namespace pinball
