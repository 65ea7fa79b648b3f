#include "info_devices.hpp"

#include <fmt/core.h>

#include <string>

#include <solver/device/device_run.hpp>
#include <solver/device/devices.hpp>

namespace pinball {

std::string readable_bytes(double bytes) {
  if (bytes < 1e6) return fmt::format("{:.3g} kB", bytes / 1e3);
  if (bytes < 1e9) return fmt::format("{:.3g} MB", bytes / 1e6);
  return fmt::format("{:.3g} GB", bytes / 1e9);
}

void print_missing_on_devices(const Scene& scene) {
  const std::string missing = missing_on_device(scene);
  fmt::print("\n  on a device: {}\n", missing.empty() ? "all of it runs there" : "not yet, for its " + missing);
}

void print_devices() {
  fmt::print("devices\n");
  for (const Device device : {Device::none, Device::mock, Device::cuda, Device::hip}) {
    const DeviceReport report = report_of(device);
    fmt::print("  {}: {}{}", device_name(device), report.is_there ? "" : "not there: ", report.what);
    if (report.memory > 0) fmt::print(", {} of memory", readable_bytes(report.memory));
    fmt::print("\n");
  }
}

}  // namespace pinball
