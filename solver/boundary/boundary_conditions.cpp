#include "boundary_conditions.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <solver/model/selection/node_selection.hpp>

#include "force_factor.hpp"

namespace pinball {

template <class S>
BoundaryConditions<S>::BoundaryConditions(const Model<S>& model, std::unique_ptr<const BoundaryKernels<S>> kernels)
    : kernels_(std::move(kernels)),
      named_(model.scene),
      gravity_(model, *kernels_),
      motions_(model),
      held_(kernels_->held_nodes()),
      pressures_(model, *kernels_),
      walls_(model, *kernels_) {
  const Scene& scene = model.scene;
  for (const NodalLoad& given : scene.loads) loads_.push_back(load_of(model, given, *kernels_));
  if (scene.damping.mass > 0) damping_ = kernels_->damping(model.nodes.count, scene.damping.mass);
  stopped_ = motions_.stopped_at_start();
  find_changes(scene);
  const bool moves = !model.prescribed.empty() || !scene.prescribed_velocities.empty();
  acts_ = !loads_.empty() || !scene.gravities.empty() || pressures_.any() || damping_ || moves || walls_.any();
  any_ = acts_ || !model.constraints.empty() || !changes_.empty();
  take_constraints(model);
}

template <class S>
typename BoundaryConditions<S>::Load BoundaryConditions<S>::load_of(const Model<S>& model, const NodalLoad& given,
                                                                    const BoundaryKernels<S>& kernels) {
  std::vector<std::int32_t> nodes;
  std::vector<S> share;
  double mass = 0;
  for (const std::int32_t n : select_nodes(model.mesh, given.nodes)) {
    nodes.push_back(model.node_of_scene_node[n]);
    mass += model.material_mass_of_node(nodes.back());
  }
  for (const std::int32_t n : nodes) {
    share.push_back(given.each ? S(1) : static_cast<S>(model.material_mass_of_node(n) / mass));
  }
  return {given, kernels.load(nodes, share)};
}

template <class S>
void BoundaryConditions<S>::find_changes(const Scene& scene) {
  const auto add = [this](const TimeSpan& when) {
    if (when.start > 0) changes_.push_back(when.start);
    if (!std::isinf(when.end)) changes_.push_back(when.end);
  };
  for (const FixedConstraint& fixed : scene.fixed_constraints) add(fixed.when);
  for (const PrescribedVelocity& given : scene.prescribed_velocities) add(given.when);
  std::sort(changes_.begin(), changes_.end());
}

/// A constraint that begins takes the velocities that nodes have along it, and with them kinetic energy.
template <class S>
bool BoundaryConditions<S>::follow(Model<S>& model, const NodeArrays<S>& nodes, double time, const StepLengths& step) {
  if (!changes(time)) return false;
  set_present(model, time);
  if (constrains_) {
    const double stopped = held_->energy_along(nodes, step);
    done_ -= stopped;
    stopped_ += stopped;
  }
  changed_ = past(time);
  return true;
}

template <class S>
void BoundaryConditions<S>::set_present(Model<S>& model, double time) {
  set_constraints(model, time);
  take_constraints(model);
  walls_.take_held_directions(model);
}

template <class S>
void BoundaryConditions<S>::persist(StateArchive& archive, Model<S>& model) {
  archive(done_, last_, changed_, stopped_);
  std::vector<Point> forces;
  if (!archive.reads()) forces = named_forces(model);
  archive(forces);
  archive.require(forces.size() == named_.names().size());
  if (archive.reads()) forces_read_ = std::move(forces);
  archive.require(changed_ <= changes_.size());
  // The model is of the start, or of a later time: what acts from the last change on is set at once, so that neither a
  // stage of the next step that comes before follow() nor another save finds anything else.
  if (archive.reads() && !changes_.empty()) set_present(model, changed_ == 0 ? 0.0 : changes_[changed_ - 1]);
  pressures_.persist(archive);
  walls_.persist(archive);
}

template <class S>
void BoundaryConditions<S>::take_constraints(const Model<S>& model) {
  held_->set(model.constraints, model.prescribed, named_.of_constraints());
  constrains_ = !model.constraints.empty();
  prescribes_ = !model.prescribed.empty();
}

template <class S>
void BoundaryConditions<S>::add_loads(const NodeArrays<S>& nodes, double time, const StepLengths& step,
                                      bool ends_cycle) {
  forces_read_.reset();
  const bool begins_cycle = std::exchange(cycle_ends_, ends_cycle);
  if (begins_cycle) {
    steps_before_ = 0;
    forces_before_.assign(named_.names().size(), Point{});
  }
  for (const Load& load : loads_) {
    const double factor = force_factor(load.given.table, time, step);
    Point present{};
    for (std::size_t k = 0; k < 3; ++k) present[k] = factor * load.given.force[k];
    load.nodes->add(nodes, present);
  }
  if (of_host_) of_host_->add(nodes);
  if (pressures_.any()) pressures_.apply(nodes, time, step, begins_cycle);
  gravity_.apply(nodes, time, step, begins_cycle);
  if (damping_) damping_->add(nodes);
  if (prescribes_ || (constrains_ && named_.of_constraints())) held_->clear_forces();
}

template <class S>
void BoundaryConditions<S>::add_wall_reactions(const NodeArrays<S>& nodes, double time, const StepLengths& step,
                                               const DueSpans& due) {
  if (walls_.any()) walls_.apply(nodes, time, step);
  if (walls_push_held_nodes()) {
    walls_.add_held_parts(nodes, time);
    hold(nodes, time, step, due);
  }
  if (named_.any() && !cycle_ends_) {
    held_->share_forces();
    add_held_forces(forces_before_);
    ++steps_before_;
  }
}

template <class S>
void BoundaryConditions<S>::count_work(const NodeArrays<S>& nodes, const StepLengths& step) {
  if (!acts_) return;
  done_ += last_.now + last_.later;
  last_ = work_of_step(nodes, step);
}

template <class S>
Array<S>& BoundaryConditions<S>::host_forces(const Model<S>& model) {
  if (!of_host_) {
    host_forces_.reset(model.nodes.force.size());
    of_host_ = kernels_->given_forces(model.nodes.count, host_forces_.data());
  }
  any_ = acts_ = true;
  return host_forces_;
}

template <class S>
void BoundaryConditions<S>::hold(const NodeArrays<S>& nodes, double time, const StepLengths& step,
                                 const DueSpans& due) {
  if (constrains_) held_->constrain(nodes, step.velocity(), due);
  if (!prescribes_) return;
  held_->prescribe(nodes, motions_.factors(time, step), step.velocity());
}

template <class S>
ExternalWork BoundaryConditions<S>::work_of_step(const NodeArrays<S>& nodes, const StepLengths& step) {
  ExternalWork sum;
  for (const Load& load : loads_) load.nodes->add_work(nodes, step, sum);
  if (prescribes_) held_->add_work(nodes, step, sum);
  gravity_.add_work(nodes, step, sum);
  if (damping_) damping_->add_work(nodes, step, sum);
  if (of_host_) of_host_->add_work(nodes, step, sum);
  if (pressures_.any()) sum.join(pressures_.work(nodes, step));
  sum.join(walls_.work(nodes, step));
  return sum;
}

template <class S>
std::size_t BoundaryConditions<S>::bytes() const {
  std::size_t sum = gravity_.bytes() + held_->bytes() + pressures_.bytes() + walls_.bytes() + host_forces_.bytes();
  if (of_host_) sum += of_host_->bytes();
  for (const Load& load : loads_) sum += load.nodes->bytes();
  return sum;
}

template class BoundaryConditions<double>;
template class BoundaryConditions<float>;

}  // namespace pinball
