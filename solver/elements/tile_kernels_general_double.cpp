#include "tile_kernels_general.hpp"

namespace pinball {

template TileKernel<double> choose_general_tile_kernel<double>(const ElementFeatures&);

}  // namespace pinball
