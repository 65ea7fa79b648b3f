#include "boundary_conditions.hpp"

#include <algorithm>

#include <kernels/exec.hpp>
#include <kernels/node_update.hpp>
#include <solver/model/node_selection.hpp>

namespace pinball {

template <class S>
BoundaryConditions<S>::BoundaryConditions(const Model<S>& model)
    : damping_(model.scene.damping.mass), gravities_(model.scene.gravities), walls_(model) {
  for (const NodalLoad& given : model.scene.loads) {
    Load load{given.force, given.table, {}, {}, {}};
    double mass = 0;
    for (const std::int32_t n : select_nodes(model.mesh, given.nodes)) {
      load.nodes.push_back(model.node_of_scene_node[n]);
      mass += model.node_mass[load.nodes.back()];
    }
    for (const std::int32_t n : load.nodes) {
      load.share.push_back(given.each ? S(1) : static_cast<S>(model.node_mass[n] / mass));
    }
    loads_.push_back(std::move(load));
  }
  for (const PrescribedVelocity& given : model.scene.prescribed_velocities) {
    velocity_tables_.push_back(given.table);
    quantities_.push_back(given.quantity);
  }
  reaction_.assign(model.prescribed.size(), S(0));
  acts_ = !loads_.empty() || !gravities_.empty() || damping_ > 0 || !model.prescribed.empty() || walls_.any();
  any_ = acts_ || !model.constraints.empty();
  if (model.constraints.empty()) return;
  for (std::int32_t span = 0; span <= span_count(model.nodes.count); ++span) {
    const auto first = std::partition_point(  // they are in the order of nodes
        model.constraints.begin(), model.constraints.end(),
        [span](const NodeConstraint<S>& c) { return c.node / nodes_per_span < span; });
    constraints_of_span_.push_back(static_cast<std::size_t>(first - model.constraints.begin()));
  }
}

template <class S>
void BoundaryConditions<S>::add_loads(Model<S>& model, double time) {
  if (!loads_.empty()) add_nodal_loads(model, time);
  if (!host_forces_.empty()) add_host_forces(model);
  if (!gravities_.empty()) add_gravity(model, time);
  if (damping_ > 0) add_damping(model);
  std::fill(reaction_.begin(), reaction_.end(), S(0));
}

template <class S>
void BoundaryConditions<S>::hold(Model<S>& model, double time, const StepLengths& step, const DueSpans& due) {
  constrain(model, due);
  if (!model.prescribed.empty()) prescribe(model, time, step);
}

template <class S>
void BoundaryConditions<S>::add_wall_reactions(Model<S>& model, const StepLengths& step) {
  if (walls_.any()) walls_.apply(model, step);
  if (!acts_) return;
  done_ += last_.now + last_.later;
  last_ = work_of_step(model, step);
}

template <class S>
void BoundaryConditions<S>::add_nodal_loads(Model<S>& model, double time) {
  for (Load& load : loads_) {
    const double factor = load.table.value(time);
    for (std::size_t k = 0; k < 3; ++k) load.present[k] = static_cast<S>(factor * load.force[k]);
    for (std::size_t i = 0; i < load.nodes.size(); ++i) {
      S* f = model.nodes.force_of(load.nodes[i]);
      for (int k = 0; k < 3; ++k) f[k] += load.share[i] * load.present[k];
    }
  }
}

template <class S>
AlignedArray<S>& BoundaryConditions<S>::host_forces(const Model<S>& model) {
  if (host_forces_.empty()) host_forces_.reset(model.nodes.force.size());
  any_ = acts_ = true;
  return host_forces_;
}

template <class S>
void BoundaryConditions<S>::add_host_forces(Model<S>& model) const {
  parallel_for("host forces", RangePolicy<>{0, model.nodes.count}, [&](std::int64_t n) {
    for (std::int64_t k = 4 * n; k < 4 * n + 3; ++k) model.nodes.force.data()[k] += host_forces_.data()[k];
  });
}

/// f = -a m v, with the velocity of the middle of the step before.
template <class S>
void BoundaryConditions<S>::add_damping(Model<S>& model) {
  NodeStore<S>& nodes = model.nodes;
  parallel_for("damping", RangePolicy<>{0, nodes.count}, [&](std::int64_t n) {
    const auto factor = static_cast<S>(-damping_ * model.node_mass[n]);
    for (std::int64_t k = 4 * n; k < 4 * n + 3; ++k) nodes.force.data()[k] += factor * nodes.velocity.data()[k];
  });
}

/// f = m g
template <class S>
void BoundaryConditions<S>::add_gravity(Model<S>& model, double time) {
  gravity_ = {};
  for (const Gravity& gravity : gravities_) {
    const double factor = gravity.table.value(time);
    for (std::size_t k = 0; k < 3; ++k) gravity_[k] += factor * gravity.acceleration[k];
  }
  parallel_for("gravity", RangePolicy<>{0, model.nodes.count}, [&](std::int64_t n) {
    for (std::int64_t k = 0; k < 3; ++k)
      model.nodes.force.data()[4 * n + k] += static_cast<S>(model.node_mass[n] * gravity_[k]);
  });
}

template <class S>
void BoundaryConditions<S>::constrain(Model<S>& model, const DueSpans& due) const {
  if (model.constraints.empty()) return;
  parallel_for("constraints", RangePolicy<>{0, span_count(model.nodes.count)}, [&](std::int64_t span) {
    if (!due.contain(span)) return;
    const auto s = static_cast<std::size_t>(span);
    for (std::size_t i = constraints_of_span_[s]; i < constraints_of_span_[s + 1]; ++i) {
      const NodeConstraint<S>& c = model.constraints[i];
      constrain_node(model.nodes.force_of(c.node), model.nodes.velocity_of(c.node), c.normal);
    }
  });
}

namespace {

/// Mean of the velocity over the coming step, or the velocity where that has no length; of a displacement the mean over
/// the step before then.
double mean_velocity(const TimeTable& table, MotionQuantity quantity, double time, const StepLengths& step) {
  const auto displacement = [&](double t) {
    return quantity == MotionQuantity::velocity       ? table.integral(t)
           : quantity == MotionQuantity::displacement ? table.value(t)
                                                      : table.second_integral(t);
  };
  if (step.after > 0) return (displacement(time + step.after) - displacement(time)) / step.after;
  if (quantity == MotionQuantity::velocity) return table.value(time);
  if (quantity == MotionQuantity::acceleration) return table.integral(time);
  return step.before > 0 ? (table.value(time) - table.value(time - step.before)) / step.before : 0.0;
}

}  // namespace

/// Adds to the reactions what gives a node the mean of the prescribed velocity over the coming step, so that its place
/// is that of the integral of the table.
template <class S>
void BoundaryConditions<S>::prescribe(Model<S>& model, double time, const StepLengths& step) {
  std::vector<double> factor;
  for (std::size_t t = 0; t < velocity_tables_.size(); ++t) {
    factor.push_back(mean_velocity(velocity_tables_[t], quantities_[t], time, step));
  }
  for (std::size_t i = 0; i < model.prescribed.size(); ++i) {
    const NodePrescription<S>& p = model.prescribed[i];
    const S* v = model.nodes.velocity_of(p.node);
    S* f = model.nodes.force_of(p.node);
    const auto wanted = static_cast<S>(factor[p.table]) * p.speed;
    S velocity = 0, force = 0;
    for (int k = 0; k < 3; ++k) {
      velocity += v[k] * p.normal[k];
      force += f[k] * p.normal[k];
    }
    const S mobility = static_cast<S>(step.velocity()) * model.nodes.inverse_mass[p.node];
    if (!(mobility > S(0))) continue;
    const S reaction = (wanted - velocity) / mobility - force;
    reaction_[i] += reaction;  // contact by impulses comes between two parts of it
    for (int k = 0; k < 3; ++k) f[k] += reaction * p.normal[k];
  }
}

template <class S>
ExternalWork BoundaryConditions<S>::work_of_step(const Model<S>& model, const StepLengths& step) const {
  const NodeStore<S>& nodes = model.nodes;
  const auto work_on = [&](std::int32_t n, const S* force) {
    const auto node = static_cast<std::size_t>(n);
    S acceleration[3];
    for (std::size_t k = 0; k < 3; ++k) acceleration[k] = nodes.force[4 * node + k] * nodes.inverse_mass[node];
    return work_of(force, nodes.velocity.data() + 4 * node, acceleration, step);
  };
  ExternalWork sum;
  for (const Load& load : loads_) {
    for (std::size_t i = 0; i < load.nodes.size(); ++i) {
      const S s = load.share[i];
      const S force[3] = {s * load.present[0], s * load.present[1], s * load.present[2]};
      sum.add(work_on(load.nodes[i], force));
    }
  }
  for (std::size_t i = 0; i < model.prescribed.size(); ++i) {
    const NodePrescription<S>& p = model.prescribed[i];
    const S r = reaction_[i];
    const S force[3] = {r * p.normal[0], r * p.normal[1], r * p.normal[2]};
    sum.add(work_on(p.node, force));
  }
  if (!gravities_.empty()) {
    parallel_reduce(
        "work of gravity", RangePolicy<>{0, nodes.count}, sum,
        [&](std::int64_t begin, std::int64_t end, ExternalWork& partial) {
          for (std::int64_t n = begin; n < end; ++n) {
            const double mass = model.node_mass[n];
            const S force[3] = {static_cast<S>(mass * gravity_[0]), static_cast<S>(mass * gravity_[1]),
                                static_cast<S>(mass * gravity_[2])};
            partial.add(work_on(static_cast<std::int32_t>(n), force));
          }
        },
        [](ExternalWork& whole, const ExternalWork& partial) { whole.add(partial); });
  }
  if (damping_ > 0) {
    parallel_reduce(
        "work of damping", RangePolicy<>{0, nodes.count}, sum,
        [&](std::int64_t begin, std::int64_t end, ExternalWork& partial) {
          for (std::int64_t n = begin; n < end; ++n) {
            const auto factor = static_cast<S>(-damping_ * model.node_mass[n]);
            const S* v = nodes.velocity.data() + 4 * n;
            const S force[3] = {factor * v[0], factor * v[1], factor * v[2]};
            partial.add(work_on(static_cast<std::int32_t>(n), force));
          }
        },
        [](ExternalWork& whole, const ExternalWork& partial) { whole.add(partial); });
  }
  if (!host_forces_.empty()) {
    parallel_reduce(
        "work of host forces", RangePolicy<>{0, nodes.count}, sum,
        [&](std::int64_t begin, std::int64_t end, ExternalWork& partial) {
          for (std::int64_t n = begin; n < end; ++n) {
            partial.add(work_on(static_cast<std::int32_t>(n), host_forces_.data() + 4 * n));
          }
        },
        [](ExternalWork& whole, const ExternalWork& partial) { whole.add(partial); });
  }
  sum.add(walls_.work(model, step));
  return sum;
}

template <class S>
std::size_t BoundaryConditions<S>::bytes() const {
  std::size_t sum = walls_.bytes() + reaction_.size() * sizeof(S) + host_forces_.bytes();
  for (const Load& load : loads_) sum += load.nodes.size() * (sizeof(std::int32_t) + sizeof(S));
  return sum;
}

template class BoundaryConditions<double>;
template class BoundaryConditions<float>;

}  // namespace pinball
