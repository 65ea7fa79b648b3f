#pragma once

#include "hexahedron.hpp"

/// Orthogonal hourglass control of Flanagan and Belytschko (1981).
///
///     gamma_aI = G_aI - 1/V B_jI (x_jJ G_aJ)       hourglass shape vectors, orthogonal to linear fields,  a = 1..4
///     qdot_a   = sum_I v_I gamma_aI                hourglass rates [length/time]
///     f_I      = sum_a Q_a gamma_aI                hourglass forces
///
/// Stiffness form: Qdot_a = kappa M (B_jJ B_jJ) / (24 V) qdot_a, Q_a turning with the material. The paper's
/// M = lambda + 2 mu, with which kappa = 1 puts the hourglass frequency of a cube at its highest material frequency,
/// locks the bending of materials that hardly change their volume; here lambda counts up to 2 mu, a Poisson ratio of
/// 1/3. Viscous form: Q_a = k rho c A qdot_a with A = sqrt(2/3 B_jJ B_jJ), the face area of a cube (no cube root as in
/// V^(2/3)).
///
/// In modes (hexahedron.hpp) neither gamma nor the corner sums are formed. With V_a, H_a the coefficients of hourglass
/// mode a of velocities and coordinates,
///
///     qdot_a = 8 sqrt3 h_a ,  h_a = V_a - L H_a ,
///
/// and with the force P_a = sqrt3 Q_a that is conjugate to it (f.v = 8 sum_a P_a.h_a) the nodal forces are the modal
/// forces P_a together with a stress-like tensor -8/V sum_a P_a (x) H_a that acts through B. Then
/// P_a = 24 k rho c A h_a (viscous) or Pdot_a = kappa M (B:B)/V h_a (stiffness).
///
/// The stiffness kappa M (B:B)/V = 3/2 kappa M A^2/V changes with the shape of the element. Kept from step to step is
/// therefore, with the volume V_0 of the undeformed element in the place of V,
///
///     Z_a = P_a / A ,   Zdot_a = 3/2 kappa M A/V_0 h_a ,   of the energy   8/3 V_0/(kappa M) sum_a Z_a.Z_a ,
///
/// which is never negative, and of which the forces take back what they gave: 8 P_a.h_a is its rate. A P_a that were
/// kept itself would change its energy with the shape, without work.
namespace pinball {

enum class HourglassKind { none, viscous, stiffness, assumed_strain };

/// Whether the hourglass modes have a state that is kept from step to step.
PINBALL_FUNCTION constexpr bool keeps_hourglass_state(HourglassKind kind) {
  return kind == HourglassKind::stiffness || kind == HourglassKind::assumed_strain;
}
/// Whether twelve numbers of the modes are stored from step to step: that state, or the forces P_a of the viscous form,
/// half of whose work is still to be counted.
PINBALL_FUNCTION constexpr bool stores_hourglass_modes(HourglassKind kind) { return kind != HourglassKind::none; }

template <class T>
struct HourglassForce {
  Vec3<T> p[4];  ///< P_a [force]
};

/// h_a [length/time]. x, v: modes of coordinates and velocities; L: velocity gradient of the same geometry.
template <class T>
PINBALL_FUNCTION Vec3<T> hourglass_rate(const Tensor<T>& L, const HexahedronModes<T>& x, const HexahedronModes<T>& v,
                                        int a) {
  return v.hourglass[a] - L * x.hourglass[a];
}

/// Stiffness form: M [stress].
template <class S>
PINBALL_FUNCTION S hourglass_modulus(S lambda, S mu) {
  return 2 * mu + minimum(lambda, 2 * mu);
}

/// Stiffness form: face_area half a step earlier, up to the square of the step's strain: B_I changes by
/// (tr L) B_I - L^T B_I. square: sum_I B_I (x) B_I, and its trace [length^4]. Zero where the area is.
template <class T>
PINBALL_FUNCTION T half_a_step_earlier(const T& area, const Symmetric<T>& square, const T& trace_square,
                                       const Symmetric<T>& strain) {
  const auto there = area > T(0);
  const T along = contract(square, strain) / select(there, trace_square, T(1));
  return select(there, area * (T(1) + number<T>(0.5) * (along - trace(strain))), T(0));
}

/// Viscous form: P_a / h_a [force time/length]; impedance = k rho c; area: face_area of B_jJ B_jJ [length^2].
template <class T>
PINBALL_FUNCTION T hourglass_viscosity(const T& impedance, const T& area) {
  return T(24) * impedance * area;
}

/// The tensor -8/V sum_a P_a (x) H_a, to be added to the stress where it acts through B.
template <class T>
PINBALL_FUNCTION Tensor<T> hourglass_stress(const HourglassForce<T>& force, const HexahedronModes<T>& x,
                                            const T& inverse_volume) {
  const T scale = T(-8) * inverse_volume;
#define PINBALL_ROW(c)                                                                                      \
  (scale * (force.p[0].c * x.hourglass[0] + force.p[1].c * x.hourglass[1] + force.p[2].c * x.hourglass[2] + \
            force.p[3].c * x.hourglass[3]))
  return {PINBALL_ROW(x), PINBALL_ROW(y), PINBALL_ROW(z)};
#undef PINBALL_ROW
}

}  // namespace pinball
