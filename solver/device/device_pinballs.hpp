#pragma once

#include <memory>

#include <solver/contact/algorithm/pinball_kernels.hpp>

namespace pinball {

template <class S>
std::unique_ptr<PinballKernels<S>> make_mock_pinball_kernels();
#if defined(PINBALL_WITH_CUDA) || defined(PINBALL_WITH_HIP)
template <class S>
std::unique_ptr<PinballKernels<S>> make_gpu_pinball_kernels();
#endif

}  // namespace pinball
