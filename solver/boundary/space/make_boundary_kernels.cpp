#include "make_boundary_kernels.hpp"

#include "space_boundary_kernels.hpp"

namespace pinball {

template <class S>
std::unique_ptr<BoundaryKernels<S>> make_host_boundary_kernels() {
  return std::make_unique<SpaceBoundaryKernels<S, DefaultExecutionSpace>>();
}

template std::unique_ptr<BoundaryKernels<double>> make_host_boundary_kernels();
template std::unique_ptr<BoundaryKernels<float>> make_host_boundary_kernels();

}  // namespace pinball
