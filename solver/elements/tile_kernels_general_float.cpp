#include "tile_kernels_general.hpp"

namespace pinball {

template TileKernel<float> choose_general_tile_kernel<float>(const ElementFeatures&);

}  // namespace pinball
