#include <solver/device/space_elements_tetrahedra.hpp>

namespace pinball {

template ElementKernel<double> tetrahedron_kernel<double, Mock>();
template ElementKernel<float> tetrahedron_kernel<float, Mock>();

}  // namespace pinball
