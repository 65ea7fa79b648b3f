#pragma once

#include "../simd.hpp"
#include "../tensor.hpp"

/// Isotropic hypoelasticity and von Mises plasticity with isotropic, piecewise-linear hardening up to the ultimate
/// stress (report section 4: linear hardening, then perfectly plastic).
namespace pinball {

/// Constants of one material. For an elastic material the plastic constants are not read.
template <class S>
struct MaterialConstants {
  S lambda;           ///< Lame's first constant, K - 2/3 mu [stress]
  S mu;               ///< shear modulus [stress]
  S yield_stress;     ///< at zero plastic strain [stress]
  S plastic_modulus;  ///< H = d(yield stress)/d(plastic strain) [stress]
  S ultimate_stress;  ///< largest yield stress; infinity: hardening without end [stress]
  S density;          ///< of the undeformed material [mass/length^3]
  S sound_speed;      ///< dilatational, sqrt((lambda + 2 mu)/density) [length/time]
};

/// Stress increment C : de. strain: tensor components (not engineering shears).
template <class T>
PINBALL_FUNCTION Symmetric<T> elastic_increment(const T& lambda, const T& mu, const Symmetric<T>& strain) {
  const T volumetric = lambda * trace(strain), two_mu = mu + mu;
  return {volumetric + two_mu * strain.xx,
          volumetric + two_mu * strain.yy,
          volumetric + two_mu * strain.zz,
          two_mu * strain.xy,
          two_mu * strain.yz,
          two_mu * strain.zx};
}

/// Increment dl of plastic strain that brings an effective trial stress q to the yield surface; exact for any strain
/// increment, also across the ultimate stress. It solves
///
///     3 mu dl = q - min(yield + H (e + dl), ultimate) = max(q - yield - H e - H dl, q - ultimate) .
///
/// The left side grows, the right side falls with dl: dl is the larger of the solutions of the two branches, so that
/// the switch at the ultimate stress needs no case distinction. Zero where q is inside the surface.
template <class T>
PINBALL_FUNCTION T plastic_increment(const MaterialConstants<ScalarOf<T>>& m, const T& q, const T& plastic_strain) {
  const ScalarOf<T> three_mu = 3 * m.mu;
  const T hardening = (q - T(m.yield_stress) - T(m.plastic_modulus) * plastic_strain) *
                      T(ScalarOf<T>(1) / (three_mu + m.plastic_modulus));
  const T perfect = (q - T(m.ultimate_stress)) * T(ScalarOf<T>(1) / three_mu);
  return maximum(T(0), maximum(hardening, perfect));
}

/// What an increment of plastic strain takes of the effective stress [stress].
template <class S>
PINBALL_FUNCTION S return_modulus(const MaterialConstants<S>& m) {
  return 3 * m.mu;
}
template <class S>
PINBALL_FUNCTION S half_return_modulus(const MaterialConstants<S>& m) {
  return S(1.5) * m.mu;
}

/// Yield stress at a plastic strain [stress].
template <class T>
PINBALL_FUNCTION T yield_stress(const MaterialConstants<ScalarOf<T>>& m, const T& plastic_strain) {
  return minimum(T(m.yield_stress) + T(m.plastic_modulus) * plastic_strain, T(m.ultimate_stress));
}

/// What of a stress has no mean.
template <class T>
PINBALL_FUNCTION Symmetric<T> deviator_of(const Symmetric<T>& stress) {
  const T mean = number<T>(1.0 / 3.0) * trace(stress);  // tension positive
  return {stress.xx - mean, stress.yy - mean, stress.zz - mean, stress.xy, stress.yz, stress.zx};
}

/// Square of the effective stress q of a deviator [stress^2].
template <class T>
PINBALL_FUNCTION T effective_square(const Symmetric<T>& deviator) {
  return number<T>(1.5) * contract(deviator, deviator);
}

/// stress -= part times deviator.
template <class T>
PINBALL_FUNCTION void reduce(Symmetric<T>& stress, const T& part, const Symmetric<T>& deviator) {
  stress.xx -= part * deviator.xx;
  stress.yy -= part * deviator.yy;
  stress.zz -= part * deviator.zz;
  stress.xy -= part * deviator.xy;
  stress.yz -= part * deviator.yz;
  stress.zx -= part * deviator.zx;
}

/// Returns the trial stress to the yield surface along the radius.
template <class T>
PINBALL_FUNCTION void radial_return(const MaterialConstants<ScalarOf<T>>& m, Symmetric<T>& stress, T& plastic_strain) {
  const Symmetric<T> deviator = deviator_of(stress);
  const T q = square_root(effective_square(deviator));
  const T dl = plastic_increment(m, q, plastic_strain);
  // if (dl > 0) reduction = 3 mu dl / q; else reduction = 0 (q may be zero then): elastic stress stays to the bit
  const auto yields = dl > T(0);
  reduce(stress, select(yields, T(3 * m.mu) * dl / select(yields, q, T(1)), T(0)), deviator);
  plastic_strain += dl;
}

}  // namespace pinball
