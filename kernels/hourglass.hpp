#pragma once

#include <pinball/kernels/hexahedron.hpp>

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
/// In modes (hexahedron.hpp) neither gamma nor the corner sums are formed: qdot_a = v_Ga - L x_Ga, and the forces are
/// the modes Q_a themselves plus a stress-like tensor -1/V Q_a (x) x_Ga that acts through B.
namespace pinball {

template <class T>
struct HourglassForce {
  Vec3<T> q[4];  ///< Q_a [force]
};

/// Hourglass rate of mode a. x, v: hourglass modes [a] of coordinates and velocities; L: velocity gradient of the same
/// geometry.
template <class T>
PINBALL_FUNCTION Vec3<T> hourglass_rate(const Tensor<T>& L, const HexahedronModes<T>& x, const HexahedronModes<T>& v,
                                        int a) {
  return v.hourglass[a] - L * x.hourglass[a];
}

/// Factor of the stiffness form, d Q_a / d (integral of qdot_a) [force/length]; modulus = kappa (lambda + 2 mu).
template <class T>
PINBALL_FUNCTION T hourglass_stiffness(const T& modulus, const UniformGradient<T>& b, const T& inverse_volume) {
  return modulus * number<T>(1.0 / 24.0) * gradient_norm_squared(b) * inverse_volume;
}

/// Factor of the viscous form, Q_a / qdot_a [force time/length]; impedance = k rho c.
template <class T>
PINBALL_FUNCTION T hourglass_viscosity(const T& impedance, const UniformGradient<T>& b) {
  return impedance * square_root(number<T>(2.0 / 3.0) * gradient_norm_squared(b));
}

/// Adds the hourglass forces to the modal forces (linear, hourglass) of an element: f_I = sum_a Q_a gamma_aI.
template <class T>
PINBALL_FUNCTION void add_hourglass_forces(const HourglassForce<T>& force, const HexahedronModes<T>& x,
                                           const UniformGradient<T>& b, const T& inverse_volume, Vec3<T> (&linear)[3],
                                           Vec3<T> (&hourglass)[4]) {
  // t_ij = -1/V sum_a Q_ai x_Gaj: its product with the modes of B is the part of gamma along B.
  Tensor<T> t;
#define PINBALL_ROW(c)                                                                          \
  (T(-1) * inverse_volume) * (force.q[0].c * x.hourglass[0] + force.q[1].c * x.hourglass[1] + \
                              force.q[2].c * x.hourglass[2] + force.q[3].c * x.hourglass[3])
  t.row_x = PINBALL_ROW(x);
  t.row_y = PINBALL_ROW(y);
  t.row_z = PINBALL_ROW(z);
#undef PINBALL_ROW
  PINBALL_UNROLL
  for (int m = 0; m < 3; ++m) {
    linear[m] = linear[m] + t * b.linear[m];
    hourglass[m] = hourglass[m] + t * b.hourglass[m] + force.q[m];
  }
  hourglass[3] = hourglass[3] + force.q[3];
}

}  // namespace pinball
