#include "tile_kernels_instances.hpp"

namespace pinball {

template TileKernel<double> choose_tile_kernel<double>(const ElementFeatures&);

}  // namespace pinball
