#pragma once

#include "hexahedron.hpp"

/// The tetrahedron of four nodes A, B, C, D: its field of displacements is linear, so that its gradient is one.
///
/// In meshes and stores it is a hexahedron of which four edges are collapsed, {A, A, B, B, C, D, D, C}: two corners at
/// each node, so that nodes get a quarter of the mass. All that is said of hexahedra holds for it.
///
/// With the edges e_1 = B - A, e_2 = C - A, e_3 = D - A its volume is e_1 . (e_2 x e_3)/6, and the gradients of the
/// nodes' shape functions over it
///
///     B_B = e_2 x e_3 / 6 ,   B_C = e_3 x e_1 / 6 ,   B_D = e_1 x e_2 / 6 ,   B_A = -(B_B + B_C + B_D)
///
/// (times the volume, as B_I of hexahedron.hpp).
namespace pinball {

/// The corner of the collapsed hexahedron at which node 0 to 3 (A to D) is, the lower of the two: 0, 2, 4, 5.
PINBALL_FUNCTION constexpr int tetrahedron_corner(int node) { return node < 2 ? 2 * node : node + 2; }

/// Differences of what B, C and D have from what A has.
template <class T>
struct TetrahedronEdges {
  Vec3<T> from_a[3];
};

/// value: of the corners of the collapsed hexahedron.
template <class T>
PINBALL_FUNCTION TetrahedronEdges<T> tetrahedron_edges(const Vec3<T> (&value)[8]) {
  const Vec3<T>& a = value[tetrahedron_corner(0)];
  return {{value[tetrahedron_corner(1)] - a, value[tetrahedron_corner(2)] - a, value[tetrahedron_corner(3)] - a}};
}

/// B_B, B_C, B_D [length^2].
template <class T>
struct TetrahedronGradient {
  Vec3<T> of[3];
};

/// x: of the coordinates [length].
template <class T>
PINBALL_FUNCTION TetrahedronGradient<T> uniform_gradient(const TetrahedronEdges<T>& x) {
  const T sixth = number<T>(1.0 / 6.0);
  return {{sixth * cross(x.from_a[1], x.from_a[2]), sixth * cross(x.from_a[2], x.from_a[0]),
           sixth * cross(x.from_a[0], x.from_a[1])}};
}

/// Of any sign [length^3].
template <class T>
PINBALL_FUNCTION T tetrahedron_volume(const TetrahedronGradient<T>& b, const TetrahedronEdges<T>& x) {
  return dot(b.of[0], x.from_a[0]);
}

/// L_ij = 1/V sum_I v_iI B_jI [1/time]; v: of the velocities.
template <class T>
PINBALL_FUNCTION Tensor<T> velocity_gradient(const TetrahedronGradient<T>& b, const TetrahedronEdges<T>& v,
                                             const T& inverse_volume) {
#define PINBALL_ROW(c) (inverse_volume * (v.from_a[0].c * b.of[0] + v.from_a[1].c * b.of[1] + v.from_a[2].c * b.of[2]))
  return {PINBALL_ROW(x), PINBALL_ROW(y), PINBALL_ROW(z)};
#undef PINBALL_ROW
}

/// Half of sum_I B_iI B_jI over the four nodes: what eight corners with an eighth of the mass each have in its place in
/// the bound on the stable step (stable_time_step.hpp) [length^4].
template <class T>
PINBALL_FUNCTION Symmetric<T> gradient_square(const TetrahedronGradient<T>& b) {
  Symmetric<T> s{T(0), T(0), T(0), T(0), T(0), T(0)};
  add_square(b.of[0] + b.of[1] + b.of[2], s);  // of A, but for its sign
  PINBALL_UNROLL
  for (int i = 0; i < 3; ++i) add_square(b.of[i], s);
  return number<T>(0.5) * s;
}

}  // namespace pinball
