#include "tetrahedron_features.hpp"
#include "tile_kernels_instances.hpp"

namespace pinball {

template <class E, class S>
TileKernel<E, S> tetrahedron_tile_kernel() {
  return update_tile<E, S, tetrahedron_features>;
}

template TileKernel<double, double> tetrahedron_tile_kernel<double, double>();
template TileKernel<float, float> tetrahedron_tile_kernel<float, float>();
template TileKernel<float, double> tetrahedron_tile_kernel<float, double>();

}  // namespace pinball
