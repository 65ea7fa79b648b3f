#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <solver/parallel/shared_nodes.hpp>

#include "boundary_kernels.hpp"

namespace pinball {

/// For the threads of the host. sharing: of several ranks; null: one process has all.
template <class S>
std::unique_ptr<BoundaryKernels<S>> make_host_boundary_kernels(SharedNodes* sharing = nullptr);
/// For the mock device. place_of_slot: of SpaceBoundaryKernels.
template <class S>
std::unique_ptr<BoundaryKernels<S>> make_mock_boundary_kernels(std::vector<std::int64_t> place_of_slot = {},
                                                               SharedNodes* sharing = nullptr);
/// For the GPU that is current, in a library with boundary_kernels_gpu.cu.
template <class S>
std::unique_ptr<BoundaryKernels<S>> make_gpu_boundary_kernels(std::vector<std::int64_t> place_of_slot,
                                                              SharedNodes* sharing = nullptr);

}  // namespace pinball
