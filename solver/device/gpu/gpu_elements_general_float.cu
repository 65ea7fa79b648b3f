#include <solver/device/space_elements_general.hpp>

namespace pinball {

template ElementKernel<float> choose_general_kernel<float, Gpu>(const ElementFeatures&);

}  // namespace pinball
