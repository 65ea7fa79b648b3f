#include "tile_kernels_linear.hpp"

namespace pinball {

template TileKernel<double> choose_tile_kernel<double>(const ElementFeatures&);

}  // namespace pinball
