#include "contact_algorithm.hpp"

#include <cmath>
#include <utility>

namespace pinball {

namespace {

const std::vector<std::int32_t> no_nodes;

}  // namespace

template <class S>
ContactAlgorithm<S>::ContactAlgorithm(const ContactSettings& settings, const SurfaceSource<S>& source,
                                      InitialSurface& start)
    : settings_(settings), pairs_(std::move(start.pairs)) {
  // A damped spring is stable for dt <= 2/w (sqrt(1 + xi^2) - xi): as an undamped one of the higher frequency.
  const double xi = settings.damping;
  damping_factor_ = 1.0 / std::pow(std::sqrt(1 + xi * xi) - xi, 2);
  if (settings.enforcement != Enforcement::penalty) {
    impulses_ = std::make_unique<ImpulseSolver<S>>(settings, source.node_count, std::move(start.held), pairs_.get());
  }
}

template <class S>
ContactWork ContactAlgorithm<S>::before_step(const SurfaceSource<S>& source, double dt) {
  if (!impulses_) return spring_forces(source, static_cast<S>(dt));
  collect_impulses(source, dt);
  ContactWork work;
  work.expected_change = impulses_->expected_change(source, dt);
  return work;
}

template <class S>
void ContactAlgorithm<S>::add_forces(const SurfaceSource<S>& source, ContactWork& work) {
  if (!impulses_) add_spring_forces(source, work);
}

template <class S>
ContactWork ContactAlgorithm<S>::after_constraints(const SurfaceSource<S>& source, const StepLengths& step,
                                                   std::span<const NodeBound> bounds) {
  ContactWork work;
  if (!impulses_) return work;
  const ImpulseResult solved = impulses_->solve(source, step, bounds);
  work.dissipated = solved.dissipated;
  work.penetration_ratio = solved.penetration_ratio;
  work.deepest = solved.deepest;
  work.pairs = solved.pairs;
  work.iterations.add(solved.iterations, solved.at_bound, solved.unsolved, solved.residual, solved.scale);
  return work;
}

template <class S>
const std::vector<std::int32_t>& ContactAlgorithm<S>::spring_nodes() {
  return impulses_ ? no_nodes : nodes_of_springs();
}

template <class S>
const std::vector<std::int32_t>& ContactAlgorithm<S>::impulse_nodes() const {
  return impulses_ ? impulses_->nodes() : no_nodes;
}

template class ContactAlgorithm<double>;
template class ContactAlgorithm<float>;

}  // namespace pinball
