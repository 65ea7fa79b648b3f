#include "tile_kernels_linear.hpp"

namespace pinball {

template TileKernel<double, double> choose_tile_kernel<double, double>(const ElementFeatures&);

}  // namespace pinball
