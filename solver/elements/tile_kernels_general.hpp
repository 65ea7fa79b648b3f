#pragma once

#include "tile_kernels_instances.hpp"

/// By themselves, so that they are compiled beside those that most scenes have.
namespace pinball {

template <class S>
TileKernel<S> choose_general_tile_kernel(const ElementFeatures& f) {
  if constexpr (built::plasticity && built::erosion) {
    if (f.erosion) return choose_viscosity<S, true, true, YieldLaw::general>(f);
  }
  return choose_viscosity<S, true, false, YieldLaw::general>(f);
}

}  // namespace pinball
