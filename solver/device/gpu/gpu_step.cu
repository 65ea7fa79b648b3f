#include <solver/device/space_step.hpp>

namespace pinball {

template <class S>
std::unique_ptr<DeviceStep<S>> make_gpu_step(const DeviceMesh<S>& mesh) {
  return std::make_unique<SpaceStep<S, Gpu>>(mesh);
}

template std::unique_ptr<DeviceStep<double>> make_gpu_step(const DeviceMesh<double>&);
template std::unique_ptr<DeviceStep<float>> make_gpu_step(const DeviceMesh<float>&);

}  // namespace pinball
