#pragma once

#include <cstddef>
#include <cstdint>
#include <tuple>

#include <kernels/exec.hpp>
#include <kernels/nodal_volumes.hpp>

namespace pinball {

/// What the loops of kernels/nodal_volumes.hpp work on, in some memory. No type of the model: sources of nvcc see it.
template <class S, class Memory = HostSpace>
struct NodalVolumeLists {
  Array<std::int64_t, Memory> place;
  Array<std::int32_t, Memory> corners, group, first, around;
  Array<S, Memory> undeformed, volume, ratio;

  std::int64_t elements() const { return place.size(); }
  std::int64_t groups() const { return ratio.size(); }
  /// All arrays.
  auto arrays() { return std::tie(place, corners, group, first, around, undeformed, volume, ratio); }
  auto arrays() const { return std::tie(place, corners, group, first, around, undeformed, volume, ratio); }
  /// The same lists in this memory.
  template <class Other>
  void copy(const NodalVolumeLists<S, Other>& other) {
    const auto copy_one = [](auto& mine, const auto& theirs) {
      mine.reset(theirs.size());
      deep_copy(mine, theirs);
    };
    std::apply(
        [&](auto&... mine) {
          std::apply([&](const auto&... theirs) { (copy_one(mine, theirs), ...); }, other.arrays());
        },
        arrays());
  }
  NodalVolumeView<S> view() {
    return {place.data(),  corners.data(), group.data(),  undeformed.data(),
            volume.data(), first.data(),   around.data(), ratio.data()};
  }
  std::size_t bytes() const {
    return std::apply([](const auto&... array) { return (array.bytes() + ...); }, arrays());
  }
};

/// Of the first `count` elements. L: elements in a row of the arrays; corner, mass: of ElementView; position: of
/// NodeView.
template <class Space, int L, class E, class S>
void find_volumes(const NodalVolumeView<S>& of, std::int64_t count, const std::int32_t* corner, const E* mass,
                  const S* position) {
  parallel_for("volumes of elements", RangePolicy<Space>{0, count}, FindsVolumes<E, S, L>{of, corner, mass, position});
}

/// Gives the first `count` elements the averages of all; groups: all; volume_ratio: of ElementView.
template <class Space, int L, class E, class S>
void average_volumes(const NodalVolumeView<S>& of, std::int64_t count, std::int64_t groups, E* volume_ratio) {
  parallel_for("volumes of nodes", RangePolicy<Space>{0, groups}, AveragesVolumes<S>{of});
  parallel_for("averaged volumes", RangePolicy<Space>{0, count}, TakesAveragedVolumes<E, S, L>{of, volume_ratio});
}

}  // namespace pinball
