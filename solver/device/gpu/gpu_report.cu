#include <kernels/exec/gpu.hpp>
#include <solver/device/gpu_report.hpp>

namespace pinball {

GpuReport gpu_report() {
  try {
    return {"", Gpu::name(), Gpu::memory()};
  } catch (const GpuError& error) {
    return {error.reason(), "", 0};
  }
}

}  // namespace pinball
