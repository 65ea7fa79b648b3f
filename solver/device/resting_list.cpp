#include "resting_list.hpp"

#include <algorithm>

namespace pinball {

template <class S>
void keep_time_steps(const Model<S>& model, const DeviceLayout<S>& layout, const RestingTiles<S>& resting,
                     const Array<S>& rates, InternalForces<S>& forces) {
  for (const auto& tile : resting.tiles()) {
    S rate = 0;
    std::int64_t of = -1;
    for (const std::int64_t slot : model.slots_of(tile.number)) {
      if (model.is_padding(slot)) continue;
      const S here = rates[layout.place_of_slot(slot)];
      if (!(here > rate)) continue;
      rate = here;
      of = slot;
    }
    forces.keep_time_step(tile.number, S(2) / rate, of);
  }
}

template <class S>
DeviceResting<S> resting_list(const Model<S>& model, const RestingTiles<S>& resting,
                              const std::vector<TileResult<S>>& results) {
  constexpr std::int32_t piece = 16;
  DeviceResting<S> list;
  list.updated = !model.scene.skip.resting;
  for (const auto& tile : resting.tiles()) {
    const std::int32_t index = list.tile.size();
    list.tile.push_back(tile.number);
    list.elements.push_back(tile.elements);
    list.record.push_back(tile.nodes.front().first);
    list.time_step.push_back(results[tile.number].time_step);
    list.first_piece.push_back(list.pieces.size());
    for (const NodeRange& range : tile.nodes) {
      for (std::int32_t n = range.first; n < range.end; n += piece) {
        list.pieces.push_back({n, std::min(n + piece, range.end), index});
      }
    }
  }
  list.first_piece.push_back(list.pieces.size());
  return list;
}

template void keep_time_steps(const Model<double>&, const DeviceLayout<double>&, const RestingTiles<double>&,
                              const Array<double>&, InternalForces<double>&);
template void keep_time_steps(const Model<float>&, const DeviceLayout<float>&, const RestingTiles<float>&,
                              const Array<float>&, InternalForces<float>&);
template DeviceResting<double> resting_list(const Model<double>&, const RestingTiles<double>&,
                                            const std::vector<TileResult<double>>&);
template DeviceResting<float> resting_list(const Model<float>&, const RestingTiles<float>&,
                                           const std::vector<TileResult<float>>&);

}  // namespace pinball
