#include "body_energies.hpp"

#include <algorithm>
#include <numeric>

#include <solver/model/mass_shares.hpp>

namespace pinball {

template <class S>
BodyEnergies<S>::BodyEnergies(const Model<S>& model, const BoundaryKernels<S>& kernels) {
  if (!model.scene.output.body_energies) return;
  const std::size_t bodies = model.scene.bodies.size();
  std::vector<std::int32_t> group(bodies);
  std::iota(group.begin(), group.end(), 0);
  for (const MassShares& body : mass_shares(model, group, bodies)) {
    std::vector<double> mass;
    for (std::size_t i = 0; i < body.nodes.size(); ++i) mass.push_back(body.share[i] * model.node_mass[body.nodes[i]]);
    mass_.push_back(std::accumulate(mass.begin(), mass.end(), 0.0));
    motion_.push_back(kernels.motion(body.nodes, body.share, mass));
  }
  energies_.resize(bodies);
}

template <class S>
void BodyEnergies<S>::begin_with(const std::vector<double>& internal) {
  for (std::size_t b = 0; b < std::min(internal.size(), energies_.size()); ++b) energies_[b].internal = internal[b];
}

template <class S>
void BodyEnergies<S>::book(const std::vector<ElementWork>& of_body) {
  for (std::size_t b = 0; b < energies_.size(); ++b) {
    Sums& body = energies_[b];
    body.internal += of_body[b].internal - of_body[b].eroded;
    body.hourglass += of_body[b].hourglass;
    body.bulk_viscosity += of_body[b].viscous;
  }
}

template <class S>
void BodyEnergies<S>::take_kinetic(const NodeArrays<S>& nodes, const StepLengths& step) {
  for (std::size_t b = 0; b < motion_.size(); ++b) energies_[b].kinetic = motion_[b]->kinetic(nodes, step.before);
}

template <class S>
std::vector<BodyShare> BodyEnergies<S>::results(const NodeArrays<S>& nodes) const {
  std::vector<BodyShare> results;
  for (std::size_t b = 0; b < motion_.size(); ++b) {
    const Sums& e = energies_[b];
    const VectorSum momentum = motion_[b]->momentum(nodes);
    results.push_back(
        {e.kinetic, e.internal, e.hourglass, e.bulk_viscosity, mass_[b], {momentum.x, momentum.y, momentum.z}});
  }
  return results;
}

template <class S>
std::size_t BodyEnergies<S>::bytes() const {
  std::size_t sum = 0;
  for (const auto& body : motion_) sum += body->bytes();
  return sum;
}

template class BodyEnergies<double>;
template class BodyEnergies<float>;

}  // namespace pinball
