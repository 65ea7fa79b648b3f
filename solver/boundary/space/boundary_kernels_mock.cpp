#include "make_boundary_kernels.hpp"
#include "space_boundary_kernels.hpp"

namespace pinball {

template <class S>
std::unique_ptr<BoundaryKernels<S>> make_mock_boundary_kernels(std::vector<std::int64_t> place_of_slot,
                                                               SharedNodes* sharing) {
  return std::make_unique<SpaceBoundaryKernels<S, Mock>>(std::move(place_of_slot), sharing);
}

template std::unique_ptr<BoundaryKernels<double>> make_mock_boundary_kernels(std::vector<std::int64_t>, SharedNodes*);
template std::unique_ptr<BoundaryKernels<float>> make_mock_boundary_kernels(std::vector<std::int64_t>, SharedNodes*);

}  // namespace pinball
