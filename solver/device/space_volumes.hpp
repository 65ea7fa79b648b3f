#pragma once

#include <cstdint>

#include <solver/boundary/space/loops.hpp>

#include "device_halo.hpp"
#include "device_mesh.hpp"
#include "staging_memory.hpp"

/// Averaged volumes where they lie; of several ranks, what they tell each other before they average.
namespace pinball {

/// Volumes of a list of elements, one after the other.
template <class S>
struct GathersVolumes {
  const std::int32_t* element;
  const S* volume;
  S* to;
  PINBALL_FUNCTION void operator()(std::int64_t i) const { to[i] = volume[element[i]]; }
};

template <class S, class Space>
class SpaceVolumes {
  using Memory = typename Space::memory_space;
  using MessageMemory = StagingMemory<Memory>;

 public:
  explicit SpaceVolumes(const DeviceVolumes<S>& volumes) : own_(volumes.own), element_(list_in<Space>(volumes.sent)) {
    lists_.copy(volumes.lists);
    sent_.renew(element_.size());
    sent_here_.renew(element_.size());
    received_here_.renew(received());
  }

  bool any() const { return lists_.elements() > 0; }
  /// Of the elements that are worked here; corner, mass: of ElementView, position: of NodeView.
  void find(const std::int32_t* corner, const S* mass, const S* position) {
    find_volumes<Space, device_row, S>(lists_.view(), own_, corner, mass, position);
  }
  /// volume_ratio: of ElementView.
  void average(S* volume_ratio) {
    average_volumes<Space, device_row>(lists_.view(), own_, lists_.groups(), volume_ratio);
  }

  /// Returns what this rank sends, on the host, or where it lies.
  const S* gather(Messages on) {
    parallel_for("volumes for other ranks", RangePolicy<Space>{0, static_cast<std::int64_t>(element_.size())},
                 GathersVolumes<S>{element_.data(), lists_.volume.data(), sent_.data()});
    if (on == Messages::device) {
      fence<Space>();
      return sent_.data();
    }
    deep_copy(sent_here_.data(), sent_);
    return sent_here_.data();
  }
  /// Where what comes is to be put: behind the volumes that are found here.
  S* received(Messages on) { return on == Messages::device ? first_received() : received_here_.data(); }
  void scatter(Messages on) {
    if (on == Messages::device || received() == 0) return;
    Memory::copy_from_host(first_received(), received_here_.data(), received_here_.bytes());
  }

  std::size_t bytes() const { return lists_.bytes() + element_.bytes() + sent_.bytes(); }

 private:
  std::size_t received() const { return static_cast<std::size_t>(lists_.elements() - own_); }
  S* first_received() { return lists_.volume.data() + own_; }

  NodalVolumeLists<S, Memory> lists_;
  std::int64_t own_;                                   ///< elements that are worked here, the first of the lists
  Array<std::int32_t, Memory> element_;                ///< that others need
  Array<S, Memory> sent_;                              ///< their volumes
  Array<S, MessageMemory> sent_here_, received_here_;  ///< on the host
};

}  // namespace pinball
