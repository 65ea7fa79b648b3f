#pragma once

#include <vector>

#include <solver/elements/internal_forces.hpp>

#include "device_layout.hpp"
#include "device_resting.hpp"

namespace pinball {

/// The stable steps of tiles at rest, from the rates of their elements. rates: per place, 2/dt [1/time].
template <class S>
void keep_time_steps(const Model<S>& model, const DeviceLayout<S>& layout, const RestingTiles<S>& resting,
                     const Array<S>& rates, InternalForces<S>& forces);

/// What a device has to know of the tiles that rest now. results: with the stable steps that they keep.
template <class S>
DeviceResting<S> resting_list(const Model<S>& model, const RestingTiles<S>& resting,
                              const std::vector<TileResult<S>>& results);

}  // namespace pinball
