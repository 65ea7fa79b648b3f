#include "tile_kernels_instances.hpp"

namespace pinball {

template <class E, class S>
TileKernel<E, S> tetrahedron_tile_kernel() {
  constexpr bool rare_cases = true, tetrahedra = true;
  return update_tile<E, S,
                     ElementFeatures{true, built::erosion, built::bulk_viscosity, HourglassKind::none,
                                     YieldLaw::general, rare_cases, tetrahedra}>;
}

template TileKernel<double, double> tetrahedron_tile_kernel<double, double>();
template TileKernel<float, float> tetrahedron_tile_kernel<float, float>();
template TileKernel<float, double> tetrahedron_tile_kernel<float, double>();

}  // namespace pinball
