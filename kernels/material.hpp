#pragma once

#include "simd.hpp"
#include "tensor.hpp"

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
  S erosion_strain;   ///< plastic strain at which the element is eroded; infinity: never [-]
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

/// Returns the trial stress to the yield surface along the radius; exact for any strain increment, also across the
/// ultimate stress. With q the effective trial stress, the increment dl of plastic strain solves
///
///     3 mu dl = q - min(yield + H (e + dl), ultimate) = max(q - yield - H e - H dl, q - ultimate) .
///
/// The left side grows, the right side falls with dl: dl is the larger of the solutions of the two branches, so that
/// the switch at the ultimate stress needs no case distinction.
/// Returns the part of the deviator that is left, 1 while elastic.
template <class T>
PINBALL_FUNCTION T radial_return(const MaterialConstants<ScalarOf<T>>& m, Symmetric<T>& stress, T& plastic_strain) {
  const T pressure = number<T>(1.0 / 3.0) * trace(stress);  // mean stress, tension positive
  const T sxx = stress.xx - pressure, syy = stress.yy - pressure, szz = stress.zz - pressure;
  const T ss = sxx * sxx + syy * syy + szz * szz +
               T(2) * (stress.xy * stress.xy + stress.yz * stress.yz + stress.zx * stress.zx);
  const T q = square_root(number<T>(1.5) * ss);
  const ScalarOf<T> three_mu = 3 * m.mu;
  const T hardening = (q - T(m.yield_stress) - T(m.plastic_modulus) * plastic_strain) *
                      T(ScalarOf<T>(1) / (three_mu + m.plastic_modulus));
  const T perfect = (q - T(m.ultimate_stress)) * T(ScalarOf<T>(1) / three_mu);
  const T dl = maximum(T(0), maximum(hardening, perfect));
  // if (dl > 0) reduction = 3 mu dl / q; else reduction = 0 (q may be zero then): elastic stress stays to the bit
  const auto yields = dl > T(0);
  const T reduction = select(yields, T(three_mu) * dl / select(yields, q, T(1)), T(0));
  stress.xx -= reduction * sxx;
  stress.yy -= reduction * syy;
  stress.zz -= reduction * szz;
  stress.xy -= reduction * stress.xy;
  stress.yz -= reduction * stress.yz;
  stress.zx -= reduction * stress.zx;
  plastic_strain += dl;
  return T(1) - reduction;
}

}  // namespace pinball
