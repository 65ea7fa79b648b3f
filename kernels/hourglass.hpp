#pragma once

#include "hexahedron.hpp"

/// Orthogonal hourglass control of Flanagan and Belytschko (1981).
///
///     gamma_aI = G_aI - 1/V B_jI (x_jJ G_aJ)       hourglass shape vectors, orthogonal to linear fields,  a = 1..4
///     qdot_a   = sum_I v_I gamma_aI                hourglass rates [length/time]
///     f_I      = sum_a Q_a gamma_aI                hourglass forces
///
/// Stiffness form: Qdot_a = kappa (lambda + 2 mu) (B_jJ B_jJ) / (24 V) qdot_a, Q_a turning with the material; kappa = 1
/// puts the hourglass frequency of a cube at its highest material frequency. Viscous form:
/// Q_a = k rho c A qdot_a with A = sqrt(2/3 B_jJ B_jJ), the face area of a cube (no cube root as in V^(2/3)).
///
/// In modes (hexahedron.hpp) neither gamma nor the corner sums are formed. With V_a, H_a the coefficients of hourglass
/// mode a of velocities and coordinates,
///
///     qdot_a = 8 sqrt3 h_a ,  h_a = V_a - L H_a ,
///
/// and with the force P_a = sqrt3 Q_a that is conjugate to it (f.v = 8 sum_a P_a.h_a) the nodal forces are the modal
/// forces P_a together with a stress-like tensor -8/V sum_a P_a (x) H_a that acts through B. Then
/// Pdot_a = kappa (lambda + 2 mu) (B:B)/V h_a (stiffness) and P_a = 24 k rho c A h_a (viscous).
namespace pinball {

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

/// Stiffness form: Pdot_a / h_a [force/length]; modulus = kappa (lambda + 2 mu); b_b = B_jJ B_jJ [length^4].
template <class T>
PINBALL_FUNCTION T hourglass_stiffness(const T& modulus, const T& b_b, const T& inverse_volume) {
  return modulus * b_b * inverse_volume;
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
