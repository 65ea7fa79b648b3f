#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <solver/scene.hpp>

/// Which devices this program was built for, and which of them this machine has.
namespace pinball {

/// As --device has it.
const char* device_name(Device device);

struct DeviceReport {
  Device device = Device::none;
  std::string what;  ///< "NVIDIA H200"; where there is none: why
  bool is_there = false;
  std::size_t memory = 0;  ///< of its own [bytes]
};

/// Of a device other than none.
DeviceReport report_of(Device device);

/// Throws InputError, with one sentence, where the program was not built for a device or the machine has none.
void require_device(Device device);

/// Of several ranks on this machine each takes another device, one after the other and then from the first again: what
/// this process does on a device from now on is done on that one. number: of the rank on this machine. Returns which it
/// is ("NVIDIA H200, 0 of 4"). Throws InputError where there is none.
std::string choose_device(Device device, int number);

}  // namespace pinball
