#include "tile_kernels_linear.hpp"

namespace pinball {

template TileKernel<float, double> choose_tile_kernel<float, double>(const ElementFeatures&);

}  // namespace pinball
