#include "tile_kernels_general.hpp"

namespace pinball {

template TileKernel<double, double> choose_general_tile_kernel<double, double>(const ElementFeatures&);

}  // namespace pinball
