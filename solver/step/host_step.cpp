#include "host_step.hpp"

#include <solver/boundary/space/make_boundary_kernels.hpp>
#include <solver/boundary/space/model_arrays.hpp>
#include <solver/device/body_elements.hpp>

#include "integration.hpp"

namespace pinball {

template <class S>
std::unique_ptr<BoundaryKernels<S>> HostStep<S>::boundary_kernels() const {
  return make_host_boundary_kernels<S>(domain_);
}

template <class S>
NodeArrays<S> HostStep<S>::nodes(NodeNumbers /*changes*/) {
  return node_arrays(model_);
}

template <class S>
MotionEnergy HostStep<S>::integrate(const Due& due, const StepLengths& step) {
  return integrate_nodes(model_, schedule_.due_spans(due), step, domain_);
}

template <class S>
template <class E>
std::vector<BodySum> HostStep<S>::sums_of(std::optional<Bodies<E>>& bodies) {
  if (!bodies) bodies.emplace(body_elements(model_, [](std::int64_t slot) { return slot; }));
  const ElementView<E> elements = model_.elements.template view<E>();
  return bodies->of({model_.nodes.velocity.data(), elements.corner, elements.mass, elements.plastic_strain});
}

template <class S>
std::vector<BodySum> HostStep<S>::body_sums() {
  bring_back();
  return is_mixed<S>(model_.scene) ? sums_of<float>(single_bodies_) : sums_of<S>(bodies_);
}

template <class S>
std::vector<ElementWork> HostStep<S>::work_of_bodies() {
  std::vector<ElementWork> work(model_.scene.bodies.size());
  for (std::size_t t = 0; t < model_.tile_body.size(); ++t) {
    const TileResult<S>& tile = forces_.tiles()[t];
    ElementWork& body = work[model_.tile_body[t]];
    body.internal += tile.internal;
    body.eroded += tile.eroded;
    body.hourglass += tile.hourglass;
    body.viscous += tile.viscous;
  }
  return work;
}

template class HostStep<double>;
template class HostStep<float>;

}  // namespace pinball
