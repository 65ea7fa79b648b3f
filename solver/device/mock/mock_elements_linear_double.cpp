#include <solver/device/space_elements_linear.hpp>

namespace pinball {

template ElementKernel<double> choose_linear_kernel<double, Mock>(const ElementFeatures&);

}  // namespace pinball
