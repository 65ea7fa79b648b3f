#include "tile_kernels_general.hpp"

namespace pinball {

template TileKernel<float, double> choose_general_tile_kernel<float, double>(const ElementFeatures&);

}  // namespace pinball
