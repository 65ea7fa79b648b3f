#pragma once

#include "../tetrahedron.hpp"
#include "element_pack.hpp"
#include "stability.hpp"
#include "step_geometry.hpp"
#include "step_motion.hpp"

/// The shapes of a pack's tetrahedra in a step, and the volumes that the laws of their materials see: those that are
/// averaged over nodes (Bonet and Burton, Commun. Numer. Meth. Engng 14, 437-449, 1998).
///
/// A mesh of linear tetrahedra has far more elements than nodes. Were each to keep its volume, as what flows has to,
/// the nodes could hardly move: it would lock. So the volumes are kept of nodes. With V the undeformed volumes, v the
/// present ones, and sums over the elements around a node a,
///
///     J_a = sum v / sum V ,     J = 1/4 (J_A + J_B + J_C + J_D) ,
///
/// and an element's strain is its own but for its volume, which is that of J. Its forces are those of the stress that
/// follows, over its own shape: with a linear bulk modulus they are the gradient of sum_a K/2 (J_a - 1)^2 sum V, and no
/// stiffer than without averages, so that the stable step of the element holds.
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

/// What the laws of materials see of a step.
template <class T, ElementFeatures features>
struct AveragedStep {
  /// own: whose arrays have the ratios J; specific_volume: of the undeformed material [length^3/mass]; dt: [time].
  template <int L>
  PINBALL_FUNCTION AveragedStep(const ElementPack<T, L>& own, ScalarOf<T> specific_volume, const EndSize<T>& end_size,
                                const MiddleSize<T>& middle_size, const StepMotion<T, features>& own_motion,
                                ScalarOf<T> dt)
      : end(end_size), middle(middle_size), motion(own_motion) {
    using S = ScalarOf<T>;
    const ElementNumbers<T, L> ratios = own.numbers(own.arrays.volume_ratio, 2);
    const T now = select(middle.whole, ratios.get(0), T(1)), before = select(middle.whole, ratios.get(1), T(1));
    const T undeformed = own.mass * T(specific_volume), sum = now + before;
    end.volume = select(middle.whole, undeformed * now, end.volume);
    middle.volume = select(middle.whole, number<T>(0.5) * undeformed * sum, middle.volume);
    middle.inverse_end_volume = select(middle.whole, T(1) / end.volume, T(0));
    middle.inverse_volume = select(middle.whole, T(1) / middle.volume, T(0));
    // Strain of the mean volume, in the place of its own.
    const T volumetric = T(2) * (now - before) / sum;
    const T third = select(middle.whole, number<T>(1.0 / 3.0) * (volumetric - motion.volumetric), T(0));
    const T rate = T(dt > S(0) ? S(1) / dt : S(0)) * third;
    motion.volumetric += T(3) * third;
    motion.gradient.row_x.x += rate;
    motion.gradient.row_y.y += rate;
    motion.gradient.row_z.z += rate;
    motion.strain.xx += third;
    motion.strain.yy += third;
    motion.strain.zz += third;
    if constexpr (!features.plastic) {
      const T half = number<T>(0.5) * third;
      motion.half_gradient.row_x.x += half;
      motion.half_gradient.row_y.y += half;
      motion.half_gradient.row_z.z += half;
    }
  }

  EndSize<T> end;
  MiddleSize<T> middle;
  StepMotion<T, features> motion;
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
