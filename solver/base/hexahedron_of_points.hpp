#pragma once

#include <array>

#include "../../kernels/folding.hpp"
#include "point.hpp"

/// Points as vectors of the kernels and back, and the kernels' formulas for one hexahedron that is given by points.
namespace pinball {

inline Vec3<double> to_vector(const Point& p) { return {p[0], p[1], p[2]}; }
inline Point to_point(const Vec3<double>& v) { return {v.x, v.y, v.z}; }

/// Modes of the coordinates [length]. corners: in the order of the kernels (kernels/hexahedron.hpp).
inline HexahedronModes<double> modes_of(const std::array<Point, 8>& corners) {
  Vec3<double> x[8];
  for (int i = 0; i < 8; ++i) x[i] = to_vector(corners[i]);
  return to_modes(x);
}

/// Exact volume of the trilinear hexahedron in the kernels' closed form, negative if it is turned inside out
/// [length^3].
inline double hexahedron_volume(const std::array<Point, 8>& corners) {
  const HexahedronModes<double> x = modes_of(corners);
  return hexahedron_volume(uniform_gradient(x), x);
}

/// The least Jacobian of a corner over the mean of the element, not above zero where a corner has turned over [-].
inline double least_corner_share(const std::array<Point, 8>& corners) {
  Vec3<double> x[8];
  for (int i = 0; i < 8; ++i) x[i] = to_vector(corners[i]);
  return least_corner_share(x, hexahedron_volume(corners));
}

}  // namespace pinball
