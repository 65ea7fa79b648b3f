#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <solver/model/model.hpp>
#include <solver/parallel/subdomain.hpp>

#include "nodal_volume_lists.hpp"

namespace pinball {

/// Elements whose volumes another rank and this one tell each other.
struct VolumeNeighbour {
  std::int32_t rank = 0;
  std::vector<std::int32_t> sent;     ///< elements of this rank
  std::int64_t first = 0, count = 0;  ///< those of the other in NodalVolumeLists, one after the other
};

/// The elements with averaged volumes around each node, those of each material apart.
template <class S>
struct VolumeGroups {
  /// Of a slot: the rank that works its element for a sum, which may be another than that of its tile.
  using Adder = std::function<std::int32_t(std::int64_t)>;

  /// domain: of several ranks, each of which averages around the nodes of the elements that it works; null: one process
  /// has all. adder: nothing where only the ranks of tiles work elements. Undeformed is what the model is now.
  explicit VolumeGroups(const Model<S>& model, const Subdomain<S>* domain = nullptr, const Adder& adder = {});

  NodalVolumeLists<S> lists;  ///< by slots; first those that this rank works, ascending
  std::int64_t own = 0;       ///< that this rank works
  std::vector<VolumeNeighbour> neighbours;
  std::int64_t sent_by_all = 0;  ///< volumes, of all ranks together
};

/// The present volumes of the first `count` elements of the lists, by the host.
template <class S>
void find_volumes_of(const Model<S>& model, NodalVolumeLists<S>& lists, std::int64_t count);

}  // namespace pinball
