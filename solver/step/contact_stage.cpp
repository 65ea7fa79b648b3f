#include "contact_stage.hpp"

#include "space_surface.hpp"

namespace pinball {

template <class S>
ContactWork ContactStage<S>::before_constraints(Model<S>& model, double time, double dt, Timers& timers,
                                                RunCounts& counts) {
  if (!built::contact || !contact_) return {};
  contact_->set_time(time);
  const SpaceSurface<S> source(model, space_, contact_->surface(), in_space_);
  timers.measure(Phase::pinballs, [&] {
    const std::vector<std::int64_t> eroded = space_.eroded_slots();
    if (!in_space_) space_.show(NodeNumbers::all);
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
    if (contact_->acts_on_velocities()) space_.show(NodeNumbers::all);
    const ContactWork work = contact_->after_constraints(ModelSurface<S>(model), step, bounds);
    if (contact_->acts_on_velocities()) space_.take(NodeNumbers::force);
    if (pairs_.any()) pairs_.book([this](std::vector<Point>& sums) { contact_->add_pair_forces(sums); }, step);
    return work;
  });
}

template class ContactStage<double>;
template class ContactStage<float>;

}  // namespace pinball
