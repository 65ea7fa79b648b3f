#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <solver/model/stores.hpp>

#include "device_step.hpp"
#include "step_space.hpp"

namespace pinball {

/// The common nodes of a run on a device (StepSpace), in both memories. Their numbers cross over when the other side
/// asks for them, and only then; who changes them says so.
template <class S>
class CommonMirror {
 public:
  /// Both have to stay where they are.
  CommonMirror(DeviceStep<S>& device, NodeStore<S>& host)
      : device_(device), host_(host), is_common_(static_cast<std::size_t>(host.count), 0) {}

  /// Returns whether any were not common before.
  bool add(std::span<const std::int32_t> nodes);
  /// All numbers, also of those that were added last.
  void show_anew();
  /// For the host.
  void show(NodeNumbers numbers);
  /// The host has changed them.
  void take(NodeNumbers changed);
  /// For the device, which is going to change these.
  void give(NodeNumbers changes);
  /// Motion is the same in both memories.
  void equal_motion() { motion_ = {}; }
  std::size_t bytes() const {
    return is_common_.capacity() + nodes_.capacity() * sizeof(std::int32_t) + numbers_.bytes();
  }

 private:
  struct Newer {
    bool on_host = false, on_device = false;
  };
  void read_motion();
  void read_force();
  void send_motion();
  void send_force();

  DeviceStep<S>& device_;
  NodeStore<S>& host_;
  std::vector<std::uint8_t> is_common_;  ///< per node of the store
  std::vector<std::int32_t> nodes_;
  Newer motion_, force_;
  Array<S> numbers_;  ///< that cross over
};

}  // namespace pinball
