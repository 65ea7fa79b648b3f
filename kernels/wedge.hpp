#pragma once

#include "hexahedron.hpp"

/// The wedge of six nodes, a hexahedron of which two edges are collapsed, {A, B, C, C, D, E, F, F}: its shape functions
/// are those of the triangle between the two at its ends, so that no node of a triangle is another than the others.
/// Each has a sixth of the mass, of which the eight corners would give C and F a quarter.
namespace pinball {

/// The corner of the collapsed hexahedron at which node 0 to 5 (A to F) is, the lower of the two: 0, 1, 2, 4, 5, 6.
PINBALL_FUNCTION constexpr int wedge_corner(int node) { return node < 3 ? node : node + 1; }

/// Three quarters of sum_I B_iI B_jI over the six nodes: what eight corners with an eighth of the mass each have in its
/// place in the bound on the stable step (stable_time_step.hpp) [length^4]. b, square: of the hexahedron,
/// gradient_square.
///
/// Where the corners 2 and 3 have e + o and e - o, their node has 2e, and so 2 (e (x) e - o (x) o) more than both; the
/// same with 6 and 7. With C and D of the hexahedron and r^2 = 1/3
///
///     e = C_2 -+ (C_3 + r D_1) ,   o = C_1 + r D_3 -+ r D_2     of 2 and 3 (-), and of 6 and 7 (+) .
template <class T>
PINBALL_FUNCTION Symmetric<T> wedge_gradient_square(const UniformGradient<T>& b, const Symmetric<T>& square) {
  const T r = number<T>(0.57735026918962576451);
  Symmetric<T> even{T(0), T(0), T(0), T(0), T(0), T(0)}, odd = even;
  add_square(b.linear[1], even);
  add_square(b.linear[2] + r * b.hourglass[0], even);
  add_square(b.linear[0] + r * b.hourglass[2], odd);
  add_square(r * b.hourglass[1], odd);
  return number<T>(0.75) * square + T(3) * even + T(-3) * odd;
}

}  // namespace pinball
