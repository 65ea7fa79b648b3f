#include <solver/device/space_step.hpp>

namespace pinball {

template <class S>
std::unique_ptr<DeviceStep<S>> make_mock_step(const DeviceMesh<S>& mesh) {
  return std::make_unique<SpaceStep<S, Mock>>(mesh);
}

template std::unique_ptr<DeviceStep<double>> make_mock_step(const DeviceMesh<double>&);
template std::unique_ptr<DeviceStep<float>> make_mock_step(const DeviceMesh<float>&);

}  // namespace pinball
