#include "tile_kernels_instances.hpp"

namespace pinball {

template TileKernel<float> choose_tile_kernel<float>(const ElementFeatures&);

}  // namespace pinball
