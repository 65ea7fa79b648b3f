#include "gravity_loads.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "force_factor.hpp"

namespace pinball {

template <class S>
GravityLoads<S>::GravityLoads(const Model<S>& model, const BoundaryKernels<S>& kernels) {
  for (const Gravity& given : model.scene.gravities) {
    if (given.bodies.empty()) {
      of_all_.push_back(given);
      factors_.push_back({.now = given.table.value(0)});
    } else {
      of_bodies_.push_back(of_bodies(model, given, kernels));
    }
  }
  if (!of_all_.empty()) forces_on_all_ = kernels.gravity(model.nodes.count);
}

template <class S>
typename GravityLoads<S>::OfBodies GravityLoads<S>::of_bodies(const Model<S>& model, const Gravity& given,
                                                              const BoundaryKernels<S>& kernels) {
  std::vector<std::int32_t> group;
  for (const Body& body : model.scene.bodies) group.push_back(std::ranges::count(given.bodies, body.name) > 0 ? 0 : -1);
  MassShares theirs = std::move(mass_shares(model, group, 1).front());
  double mass = 0;
  for (std::size_t i = 0; i < theirs.nodes.size(); ++i) {
    theirs.share[i] *= model.node_mass[theirs.nodes[i]];
    mass += theirs.share[i];
  }
  return {given, {.now = given.table.value(0)}, mass, kernels.gravity(theirs.nodes, theirs.share)};
}

template <class S>
void GravityLoads<S>::apply(const NodeArrays<S>& nodes, double time, const StepLengths& step, bool begins_cycle) {
  if (forces_on_all_) {
    Point sum{};
    for (std::size_t i = 0; i < of_all_.size(); ++i) {
      factors_[i].take(force_factor(of_all_[i].table, time, step), begins_cycle);
      for (std::size_t k = 0; k < 3; ++k) sum[k] += factors_[i].now * of_all_[i].acceleration[k];
    }
    forces_on_all_->add(nodes, sum);
  }
  for (OfBodies& gravity : of_bodies_) {
    gravity.factor.take(force_factor(gravity.given.table, time, step), begins_cycle);
    Point present{};
    for (std::size_t k = 0; k < 3; ++k) present[k] = gravity.factor.now * gravity.given.acceleration[k];
    gravity.forces->add(nodes, present);
  }
}

template <class S>
void GravityLoads<S>::add_work(const NodeArrays<S>& nodes, const StepLengths& step, ExternalWork& sum) const {
  if (forces_on_all_) forces_on_all_->add_work(nodes, step, sum);
  for (const OfBodies& gravity : of_bodies_) gravity.forces->add_work(nodes, step, sum);
}

/// Masses are those of the host, which all memories have.
template <class S>
void GravityLoads<S>::add_forces(const Model<S>& model, const NamedForces& named, std::vector<Point>& sums) const {
  const auto add = [&](const Gravity& gravity, double factor, double mass) {
    const double force = mass * factor;
    const Point& a = gravity.acceleration;
    named.add(gravity.name, {force * a[0], force * a[1], force * a[2]}, sums);
  };
  for (std::size_t i = 0; i < of_all_.size(); ++i) {
    if (of_all_[i].name.empty()) continue;
    add(of_all_[i], factors_[i].mean(), std::accumulate(model.node_mass.begin(), model.node_mass.end(), 0.0));
  }
  for (const OfBodies& gravity : of_bodies_) {
    if (!gravity.given.name.empty()) add(gravity.given, gravity.factor.mean(), gravity.mass);
  }
}

template <class S>
std::size_t GravityLoads<S>::bytes() const {
  std::size_t sum = 0;
  for (const OfBodies& gravity : of_bodies_) sum += gravity.forces->bytes();
  return sum;
}

template class GravityLoads<double>;
template class GravityLoads<float>;

}  // namespace pinball
