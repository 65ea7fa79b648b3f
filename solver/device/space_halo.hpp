#pragma once

#include <cstdint>

#include <solver/boundary/space/loops.hpp>

#include "device_halo.hpp"
#include "device_mesh.hpp"
#include "staging_memory.hpp"

/// Forces of element corners that cross between ranks, packed and unpacked where they lie.
namespace pinball {

/// The first of the three numbers of a corner, which are device_row apart (KeptAtCorners).
PINBALL_FUNCTION std::int64_t place_of_corner(std::int64_t corner) {
  return place_in_rows<device_row>(corner / 8, 24) + 3 * (corner % 8) * device_row;
}

/// Of a list of corners, three numbers each.
template <class S>
struct GathersCorners {
  const std::uint32_t* corner;
  const S* corner_force;
  S* to;
  PINBALL_FUNCTION void operator()(std::int64_t i) const {
    const S* const force = corner_force + place_of_corner(corner[i]);
    for (int k = 0; k < 3; ++k) to[3 * i + k] = force[k * device_row];
  }
};

/// To consecutive corners.
template <class S>
struct ScattersCorners {
  std::int64_t first;  ///< corner
  const S* from;
  S* corner_force;
  PINBALL_FUNCTION void operator()(std::int64_t i) const {
    S* const force = corner_force + place_of_corner(first + i);
    for (int k = 0; k < 3; ++k) force[k * device_row] = from[3 * i + k];
  }
};

template <class S, class Space>
class SpaceHalo {
  using Memory = typename Space::memory_space;
  using MessageMemory = StagingMemory<Memory>;

 public:
  /// places: of elements.
  void set(const DeviceHalo& halo, std::int64_t places) {
    first_received_ = 8 * places;
    corner_ = list_in<Space>(halo.sent);
    sent_.renew(3 * halo.sent.size());
    sent_here_.renew(sent_.size());
    received_.renew(3 * static_cast<std::size_t>(halo.received));
    received_here_.renew(received_.size());
  }
  /// Places of elements that the corners that come take up.
  static std::int64_t places_of(const DeviceHalo& halo) {
    const std::int64_t elements = (halo.received + 7) / 8;
    return (elements + device_row - 1) / device_row * device_row;
  }

  /// Returns what this rank sends, on the host, or where it lies.
  const S* gather(const S* corner_force, Messages on) {
    parallel_for("forces for other ranks", RangePolicy<Space>{0, std::ssize(corner_)},
                 GathersCorners<S>{corner_.data(), corner_force, sent_.data()});
    if (on == Messages::device) {
      fence<Space>();
      return sent_.data();
    }
    deep_copy(sent_here_.data(), sent_);
    return sent_here_.data();
  }
  /// Where what comes is to be put.
  S* received(Messages on) { return on == Messages::device ? received_.data() : received_here_.data(); }
  void scatter(S* corner_force, Messages on) {
    if (on == Messages::host) deep_copy(received_, received_here_.data(), received_.size());
    parallel_for("forces of other ranks", RangePolicy<Space>{0, static_cast<std::int64_t>(received_.size() / 3)},
                 ScattersCorners<S>{first_received_, received_.data(), corner_force});
  }
  std::size_t bytes() const { return corner_.bytes() + sent_.bytes() + received_.bytes(); }

 private:
  std::int64_t first_received_ = 0;  ///< corner
  Array<std::uint32_t, Memory> corner_;
  Array<S, Memory> sent_, received_;
  Array<S, MessageMemory> sent_here_, received_here_;  ///< on the host
};

}  // namespace pinball
