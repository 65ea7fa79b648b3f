#include <solver/device/space_elements_general.hpp>

namespace pinball {

template ElementKernel<double> choose_general_kernel<double, Mock>(const ElementFeatures&);

}  // namespace pinball
