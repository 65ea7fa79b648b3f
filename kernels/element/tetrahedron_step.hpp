#pragma once

#include "../tetrahedron.hpp"
#include "element_pack.hpp"
#include "step_geometry.hpp"

/// The shapes of a pack's tetrahedra in a step, and their forces.
namespace pinball {

/// Of what the nodes of a pack's elements have in their records.
template <class T, int L, class N>
PINBALL_FUNCTION TetrahedronEdges<T> gather_edges(const N* record, const std::int32_t* corner) {
  Vec3<T> value[8];
  gather_corners<T, L>(record, corner, value);
  return tetrahedron_edges(value);
}

/// At the end of the step just made, x_n.
template <class T>
struct TetrahedronEnd : EndSize<T> {
  PINBALL_FUNCTION TetrahedronEnd(const TetrahedronEdges<T>& x, const T& mass, const MaskOf<T>& alive)
      : b(uniform_gradient(x)) {
    this->volume = tetrahedron_volume(b, x);
    const Symmetric<T> square = gradient_square(b);
    this->trace_square = trace(square);
    this->largest_square = largest_principal_value(square);
    this->inverse_mass = T(1) / select(alive, mass, T(1));
    this->area = face_area(T(2) * this->trace_square);
    this->length = this->volume / this->area;
  }

  TetrahedronGradient<T> b;
};

/// In its middle, x_(n-1/2).
template <class T>
struct TetrahedronMiddle : MiddleSize<T> {
  PINBALL_FUNCTION TetrahedronMiddle(const TetrahedronEdges<T>& x_end, const TetrahedronEdges<T>& v, ScalarOf<T> dt,
                                     const T& end_volume, const MaskOf<T>& alive) {
    const T back(ScalarOf<T>(-0.5) * dt);
    TetrahedronEdges<T> x;
    for (int i = 0; i < 3; ++i) x.from_a[i] = x_end.from_a[i] + back * v.from_a[i];
    b = uniform_gradient(x);
    this->set(tetrahedron_volume(b, x), end_volume, alive);
  }

  TetrahedronGradient<T> b;
};

/// Forces of the nodes, at the corners of the collapsed hexahedron; at the others zero. stress: with bulk viscosity;
/// weight: of ElementStep.
template <class T>
PINBALL_FUNCTION void forces_of_nodes(const Symmetric<T>& stress, const TetrahedronGradient<T>& b,
                                      ScalarOf<T> step_weight, Vec3<T> (&value)[8]) {
  const Tensor<T> acting = T(-step_weight) * to_tensor(stress);
  const Vec3<T> zero{T(0), T(0), T(0)};
  PINBALL_UNROLL
  for (int i = 0; i < 8; ++i) value[i] = zero;
  Vec3<T> sum = zero;
  PINBALL_UNROLL
  for (int i = 0; i < 3; ++i) {
    const Vec3<T> force = acting * b.of[i];
    value[tetrahedron_corner(i + 1)] = force;
    sum = sum + force;
  }
  value[tetrahedron_corner(0)] = T(-1) * sum;
}

}  // namespace pinball
