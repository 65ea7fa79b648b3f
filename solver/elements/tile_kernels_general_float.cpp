#include "tile_kernels_general.hpp"

namespace pinball {

template TileKernel<float, float> choose_general_tile_kernel<float, float>(const ElementFeatures&);

}  // namespace pinball
