#include "make_boundary_kernels.hpp"

#include "space_boundary_kernels.hpp"

namespace pinball {

template <class S>
std::unique_ptr<BoundaryKernels<S>> make_host_boundary_kernels(SharedNodes* sharing) {
  return std::make_unique<SpaceBoundaryKernels<S, DefaultExecutionSpace>>(std::vector<std::int64_t>(), sharing);
}

template std::unique_ptr<BoundaryKernels<double>> make_host_boundary_kernels(SharedNodes*);
template std::unique_ptr<BoundaryKernels<float>> make_host_boundary_kernels(SharedNodes*);

}  // namespace pinball
