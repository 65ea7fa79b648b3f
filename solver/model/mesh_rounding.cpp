#include "mesh_rounding.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <solver/base/hexahedron_of_points.hpp>

namespace pinball {

double relative_rounding(const std::array<Point, 8>& corners, Precision precision) {
  const double epsilon =
      precision == Precision::float32 ? std::numeric_limits<float>::epsilon() : std::numeric_limits<double>::epsilon();
  const HexahedronModes<double> x = modes_of(corners);
  const UniformGradient<double> b = uniform_gradient(x);
  const double volume = hexahedron_volume(b, x);
  const Symmetric<double> b_b = gradient_square(b);
  const double squares[3] = {b_b.xx, b_b.yy, b_b.zz};  // sum_I B_iI^2
  double error = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    double farthest = 0;
    for (const Point& corner : corners) farthest = std::max(farthest, std::abs(corner[k]));
    error += 0.5 * epsilon * farthest * std::sqrt(8 * squares[k]);
  }
  return volume > 0 && std::isfinite(error) ? error / volume : std::numeric_limits<double>::infinity();
}

}  // namespace pinball
