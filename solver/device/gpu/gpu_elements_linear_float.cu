#include <solver/device/space_elements_linear.hpp>

namespace pinball {

template ElementKernel<float> choose_linear_kernel<float, Gpu>(const ElementFeatures&);

}  // namespace pinball
