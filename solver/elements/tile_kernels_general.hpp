#pragma once

#include "tile_kernels_instances.hpp"

/// By themselves, so that they are compiled beside those that most scenes have.
namespace pinball {

template <class E, class S>
TileKernel<E, S> choose_general_tile_kernel(const ElementFeatures& features) {
  return choose_general_features(UpdatesTiles<E, S>{}, features);
}

}  // namespace pinball
