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
/// asks for them, and only then, and where it asks for the listed ones only theirs do, motion and forces in one copy;
/// who changes them says so.
template <class S>
class CommonMirror {
 public:
  /// Both have to stay where they are.
  CommonMirror(DeviceStep<S>& device, NodeStore<S>& host)
      : device_(device), host_(host), is_common_(static_cast<std::size_t>(host.count), 0) {}

  /// Returns whether any were not common before.
  bool add(std::span<const std::int32_t> nodes);
  /// These of them are the listed ones.
  void list(std::span<const std::int32_t> nodes);
  /// Of several ranks, and these are those whose forces this one gives to all.
  void set_own(const std::vector<std::int32_t>& nodes);
  /// Brings the forces of these to the host, where all others have none: before they go to all.
  void show_own_forces();
  /// All numbers, also of those that were added last.
  void show_anew();
  /// For the host.
  void show(NodeNumbers numbers);
  void show_listed(NodeNumbers numbers);
  /// The host has changed them.
  void take(NodeNumbers changed);
  void take_listed(NodeNumbers changed);
  /// For the device, which is going to change these.
  void give(NodeNumbers changes);
  /// Motion is the same in both memories.
  void equal_motion() { motion_ = {}; }
  std::size_t bytes() const {
    return is_common_.capacity() + (nodes_.capacity() + listed_.capacity() + own_.capacity()) * sizeof(std::int32_t) +
           numbers_.bytes();
  }

 private:
  /// Whose numbers are newer than those of the other side: of all nodes, and of the listed ones where that differs.
  struct Newer {
    bool on_host = false, on_device = false;
    bool listed_on_host = false;
    bool listed_shown = false;  ///< those of the device are newer, but these the host has
  };
  const std::vector<std::int32_t>& nodes_of(CommonSet of) const {
    if (of == CommonSet::own) return own_;
    return of == CommonSet::all ? nodes_ : listed_;
  }
  void read(CommonSet of, NodeNumbers numbers);
  void send(CommonSet of, NodeNumbers numbers);
  void give_listed();
  /// Those of the numbers for which this is true of what is newer.
  template <class Is>
  NodeNumbers numbers_where(const Is& is) const;
  /// Calls work(records per node of the host's memory, place of them among the numbers that cross over).
  template <class Work>
  void for_records(CommonSet of, NodeNumbers numbers, const Work& work);

  DeviceStep<S>& device_;
  NodeStore<S>& host_;
  std::vector<std::uint8_t> is_common_;  ///< per node of the store
  std::vector<std::int32_t> nodes_, listed_, own_;
  Newer motion_, force_;
  Array<S> numbers_;  ///< that cross over
};

}  // namespace pinball
