#include <kernels/exec/gpu.hpp>
#include <solver/device/gpu_report.hpp>

namespace pinball {

GpuReport gpu_report() {
  try {
    const auto properties = Gpu::properties();
    return {"", properties.name, properties.totalGlobalMem};
  } catch (const GpuError& error) {
    return {error.reason(), "", 0};
  }
}

ChosenGpu choose_gpu(int number) {
  try {
    const int count = Gpu::count();
    Gpu::choose(number % count);
    return {"", number % count, count};
  } catch (const GpuError& error) {
    return {error.reason(), -1, 0};
  }
}

}  // namespace pinball
