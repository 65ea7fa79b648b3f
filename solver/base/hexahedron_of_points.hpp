#pragma once

#include <array>

#include "../../kernels/folding.hpp"
#include "../../kernels/tetrahedron.hpp"
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

/// What the bound on the stable step of an element is made of (kernels/stable_time_step.hpp).
struct SizeOfElement {
  double volume;             ///< [length^3]
  Symmetric<double> square;  ///< of the mean gradient, as of eight corners with an eighth of the mass each [length^4]
  double face_area;          ///< of a cube [length^2]
};

/// tetrahedron: whether the hexahedron is collapsed to one.
inline SizeOfElement element_size(const std::array<Point, 8>& corners, bool tetrahedron) {
  if (!tetrahedron) {
    const HexahedronModes<double> x = modes_of(corners);
    const UniformGradient<double> b = uniform_gradient(x);
    const Symmetric<double> square = gradient_square(b);
    return {hexahedron_volume(b, x), square, face_area(trace(square))};
  }
  Vec3<double> at[8];
  for (int i = 0; i < 8; ++i) at[i] = to_vector(corners[i]);
  const TetrahedronEdges<double> x = tetrahedron_edges(at);
  const TetrahedronGradient<double> b = uniform_gradient(x);
  const Symmetric<double> square = gradient_square(b);
  return {tetrahedron_volume(b, x), square, face_area(2 * trace(square))};
}

}  // namespace pinball
