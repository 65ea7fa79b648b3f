#include "devices.hpp"

#include <fmt/core.h>

#include <kernels/exec.hpp>
#include <solver/base/error.hpp>

#include "gpu_report.hpp"

namespace pinball {

namespace {

[[maybe_unused]] DeviceReport not_built(Device device, const char* language) {
  return {device, fmt::format("this program was built without {}: PINBALL_DEVICE={}", language, device_name(device)),
          false, 0};
}

#if defined(PINBALL_WITH_CUDA) || defined(PINBALL_WITH_HIP)
DeviceReport of_gpu(Device device, const char* language) {
  const GpuReport gpu = gpu_report();
  if (!gpu.problem.empty()) return {device, fmt::format("no {} device was found: {}", language, gpu.problem), false, 0};
  return {device, gpu.name, true, gpu.memory};
}
#endif

}  // namespace

const char* device_name(Device device) {
  switch (device) {
    case Device::mock:
      return "mock";
    case Device::cuda:
      return "cuda";
    case Device::hip:
      return "hip";
    case Device::none:
      break;
  }
  return "none";
}

DeviceReport report_of(Device device) {
  switch (device) {
    case Device::cuda:
#if defined(PINBALL_WITH_CUDA)
      return of_gpu(device, "CUDA");
#else
      return not_built(device, "CUDA");
#endif
    case Device::hip:
#if defined(PINBALL_WITH_HIP)
      return of_gpu(device, "HIP");
#else
      return not_built(device, "HIP");
#endif
    case Device::mock:
#if defined(PINBALL_WITH_MOCK)
      return {device, fmt::format("threads of the host, on memory that {} closes to it", MockSpace::protection()), true,
              0};
#else
      return {device, "this program was built without the device of tests: PINBALL_MOCK=ON", false, 0};
#endif
    case Device::none:
      break;
  }
  return {device, "threads of the host", true, 0};
}

void require_device(Device device) {
  if (const DeviceReport report = report_of(device); !report.is_there) {
    throw InputError(fmt::format("device {}: {}", device_name(device), report.what));
  }
}

std::string choose_device(Device device, [[maybe_unused]] int number) {
  require_device(device);
#if defined(PINBALL_WITH_CUDA) || defined(PINBALL_WITH_HIP)
  if (device != Device::mock) {
    const ChosenGpu chosen = choose_gpu(number);
    if (chosen.number < 0) throw InputError(fmt::format("device {}: {}", device_name(device), chosen.problem));
    return fmt::format("{}, {} of {}", report_of(device).what, chosen.number, chosen.count);
  }
#endif
  return device_name(device);
}

}  // namespace pinball
