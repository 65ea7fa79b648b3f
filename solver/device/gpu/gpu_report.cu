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

}  // namespace pinball
