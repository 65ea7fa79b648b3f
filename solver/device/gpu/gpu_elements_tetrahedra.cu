#include <solver/device/space_elements_tetrahedra.hpp>

namespace pinball {

template ElementKernel<double> tetrahedron_kernel<double, Gpu>();
template ElementKernel<float> tetrahedron_kernel<float, Gpu>();

}  // namespace pinball
