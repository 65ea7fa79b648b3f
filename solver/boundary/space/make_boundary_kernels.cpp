#include "make_boundary_kernels.hpp"

#include "space_boundary_kernels.hpp"

namespace pinball {

template <class S>
std::unique_ptr<BoundaryKernels<S>> make_host_boundary_kernels(Subdomain<S>* domain) {
  return std::make_unique<SpaceBoundaryKernels<S, DefaultExecutionSpace>>(std::vector<std::int64_t>(), domain);
}

template std::unique_ptr<BoundaryKernels<double>> make_host_boundary_kernels(Subdomain<double>*);
template std::unique_ptr<BoundaryKernels<float>> make_host_boundary_kernels(Subdomain<float>*);

}  // namespace pinball
