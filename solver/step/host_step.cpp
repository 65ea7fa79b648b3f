#include "host_step.hpp"

#include <solver/boundary/space/make_boundary_kernels.hpp>
#include <solver/boundary/space/model_arrays.hpp>

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
  const MotionEnergy motion = integrate_nodes(model_, schedule_.due_spans(due), step, domain_);
  schedule_.end_step(model_.nodes);
  return motion;
}

template class HostStep<double>;
template class HostStep<float>;

}  // namespace pinball
