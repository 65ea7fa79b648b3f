#pragma once

#include "neo_hookean.hpp"

/// Elasticity that differs with the direction in the material, for small strains and any rotation: the energy of Saint
/// Venant and Kirchhoff per initial volume (Bonet and Wood, Nonlinear Continuum Mechanics for Finite Element Analysis,
/// section 6.5; LS-DYNA Theory Manual, material model 2), with the moduli C of the axes of the undeformed material,
///
///     W = 1/2 E : C : E ,   E = 1/2 (F^T F - I) ,   sigma = 1/J F (C : E) F^T .
///
/// The axes go with the material, since E is that of the undeformed one: a rotation turns sigma with it and changes
/// nothing else. Elements keep H = F - I. With f = I + g of neo_hookean.hpp a step is H <- H + g (I + H), exact for any
/// strain and rotation. A pressed bar of such a material loses its stiffness at a stretch of 1/sqrt(3).
namespace pinball {

template <class S>
struct OrthotropicConstants {
  bool used = false;
  /// C by rows of its upper half, of xx yy zz xy yz zx, the last three with engineering shear strains [stress]
  S moduli[21] = {};
  S lambda = S(0), mu = S(0);  ///< of an isotropic material that is at least as stiff in any strain [stress]
};

/// H after a step.
template <class T>
PINBALL_FUNCTION Tensor<T> displacement_gradient_after(const Tensor<T>& half, const Tensor<T>& before) {
  const Tensor<T> g = gradient_of_step(half);
  const auto row = [&](const Vec3<T>& old, const Vec3<T>& of_g) __attribute__((always_inline)) {
    return old + (of_g + (of_g.x * before.row_x + of_g.y * before.row_y + of_g.z * before.row_z));
  };
  return {row(before.row_x, g.row_x), row(before.row_y, g.row_y), row(before.row_z, g.row_z)};
}

/// Green's strain, 1/2 (H + H^T + H^T H).
template <class T>
PINBALL_FUNCTION Symmetric<T> green_strain(const Tensor<T>& h) {
  const Vec3<T>&a = h.row_x, &b = h.row_y, &c = h.row_z;
  const T half = number<T>(0.5);
  return {a.x + half * (a.x * a.x + b.x * b.x + c.x * c.x),
          b.y + half * (a.y * a.y + b.y * b.y + c.y * c.y),
          c.z + half * (a.z * a.z + b.z * b.z + c.z * c.z),
          half * ((a.y + b.x) + (a.x * a.y + b.x * b.y + c.x * c.y)),
          half * ((b.z + c.y) + (a.y * a.z + b.y * b.z + c.y * c.z)),
          half * ((c.x + a.z) + (a.z * a.x + b.z * b.x + c.z * c.x))};
}

/// C : E.
template <class T>
PINBALL_FUNCTION Symmetric<T> product_of_moduli(const ScalarOf<T> (&moduli)[21], const Symmetric<T>& e) {
  const T strain[6] = {e.xx, e.yy, e.zz, T(2) * e.xy, T(2) * e.yz, T(2) * e.zx};
  T stress[6] = {T(0), T(0), T(0), T(0), T(0), T(0)};
  int k = 0;
  PINBALL_UNROLL
  for (int i = 0; i < 6; ++i) {
    stress[i] += T(moduli[k++]) * strain[i];
    PINBALL_UNROLL
    for (int j = i + 1; j < 6; ++j, ++k) {
      stress[i] += T(moduli[k]) * strain[j];
      stress[j] += T(moduli[k]) * strain[i];
    }
  }
  return {stress[0], stress[1], stress[2], stress[3], stress[4], stress[5]};
}

/// F s F^T of F = I + h.
template <class T>
PINBALL_FUNCTION Symmetric<T> pushed_forward(const Tensor<T>& h, const Symmetric<T>& s) {
  const Vec3<T> fa{T(1) + h.row_x.x, h.row_x.y, h.row_x.z}, fb{h.row_y.x, T(1) + h.row_y.y, h.row_y.z},
      fc{h.row_z.x, h.row_z.y, T(1) + h.row_z.z};
  const Vec3<T> sa = s * fa, sb = s * fb, sc = s * fc;
  return {dot(sa, fa), dot(sb, fb), dot(sc, fc), dot(sa, fb), dot(sb, fc), dot(sc, fa)};
}

/// Stress of F = I + h, and moduli of a linear material that is at least as stiff.
///
/// Twice the energy of a small motion of gradient G, D its symmetric part, per volume is
///
///     1/J (F^T D F) : C : (F^T D F) + sigma : G^T G  <=  1/J (lambda (b : D)^2 + 2 mu |F^T D F|^2) + sigma_1 G : G
///
/// with lambda and mu of OrthotropicConstants. With m = tr b/3 and q = |dev b|, (b : D)^2 is no more than
/// (m^2 + m q) (tr D)^2 + (q^2 + m q) |D|^2, and |F^T D F| no more than the largest principal value of b times |D|.
template <class T>
PINBALL_FUNCTION NeoHookeanState<T> orthotropic_state(const OrthotropicConstants<ScalarOf<T>>& law,
                                                      const Tensor<T>& h) {
  using S = ScalarOf<T>;
  const T third = number<T>(1.0 / 3.0), root = number<T>(0.81649658092772603273);  // sqrt(2/3)
  const Symmetric<T> e = green_strain(h);
  const Vec3<T> fa{T(1) + h.row_x.x, h.row_x.y, h.row_x.z}, fb{h.row_y.x, T(1) + h.row_y.y, h.row_y.z},
      fc{h.row_z.x, h.row_z.y, T(1) + h.row_z.z};
  // What is pressed to a thousandth of its volume is as stiff as that.
  const T inverse = T(1) / maximum(dot(fa, cross(fb, fc)), number<T>(1e-3));
  NeoHookeanState<T> now;
  now.stress = inverse * pushed_forward(h, product_of_moduli<T>(law.moduli, e));

  const Symmetric<T> of_e = deviator_of(e), of_stress = deviator_of(now.stress);
  const T mean = T(1) + T(2) * third * trace(e), deviation = T(2) * square_root(contract(of_e, of_e));
  const T largest = mean + root * deviation, mixed = mean * deviation;
  const T tension = maximum(T(0), third * trace(now.stress) + root * square_root(contract(of_stress, of_stress)));
  now.lambda = T(law.lambda) * inverse * (mean * mean + mixed);
  now.mu = inverse * (T(law.mu) * largest * largest + T(S(0.5) * law.lambda) * (deviation * deviation + mixed)) +
           T(S(0.5)) * tension;
  return now;
}

/// Over a step. gradient: H, of the old state and then of the new; where `whole` is not set, half must be zero, and
/// gradient and stress stay.
template <class T>
PINBALL_OUTLINED void update_orthotropic(const OrthotropicConstants<ScalarOf<T>>& law, const Tensor<T>& half,
                                         const MaskOf<T>& whole, const Symmetric<T>& old, Tensor<T>& gradient,
                                         NeoHookeanState<T>& now) {
  const Tensor<T> after = displacement_gradient_after(half, gradient);
  gradient = {select(whole, after.row_x, gradient.row_x), select(whole, after.row_y, gradient.row_y),
              select(whole, after.row_z, gradient.row_z)};
  now = orthotropic_state(law, gradient);
  now.stress = select(whole, now.stress, old);
}

}  // namespace pinball
