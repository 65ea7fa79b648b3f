#include "tile_kernels_linear.hpp"

namespace pinball {

template TileKernel<float> choose_tile_kernel<float>(const ElementFeatures&);

}  // namespace pinball
