#include <solver/device/device_pinballs.hpp>
#include <solver/device/space_pinballs.hpp>

namespace pinball {

template <class S>
std::unique_ptr<PinballKernels<S>> make_gpu_pinball_kernels() {
  return std::make_unique<SpacePinballs<S, Gpu>>();
}

template std::unique_ptr<PinballKernels<double>> make_gpu_pinball_kernels();
template std::unique_ptr<PinballKernels<float>> make_gpu_pinball_kernels();

}  // namespace pinball
