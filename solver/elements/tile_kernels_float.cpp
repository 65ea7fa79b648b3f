#include "tile_kernels_linear.hpp"

namespace pinball {

template TileKernel<float, float> choose_tile_kernel<float, float>(const ElementFeatures&);

}  // namespace pinball
