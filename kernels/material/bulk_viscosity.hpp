#pragma once

#include "../simd.hpp"

/// Bulk viscosity: spreads a shock over a few elements (quadratic, in compression only) and damps the ringing behind it
/// (linear). Added to the mean stress in the forces, never to the stored stress, and not part of the yield condition:
///
///     q = (b1 rho c L + rho b2^2 L^2 |min(0, rate)|) rate ,      rate = tr D ,  tension positive.
///
/// b1 = 0.06, b2 = 1.2 are the customary values. L = V / sqrt(2/3 B:B) equals the edge of a cube.
namespace pinball {

template <class S>
struct ViscosityConstants {
  S linear;     ///< b1 [-]
  S quadratic;  ///< b2 [-]
};

/// Without coefficients there is none: nothing of it is read, written or computed. No kernel of its own for that, as
/// it takes a branch that goes one way in all packs of a part.
template <class S>
PINBALL_FUNCTION bool has_bulk_viscosity(const ViscosityConstants<S>& constants) {
  return constants.linear > S(0) || constants.quadratic > S(0);
}

/// The viscosity multiplying the volumetric strain rate [stress time].
/// length: characteristic length of the element; rate: volumetric strain rate [1/time].
template <class T>
PINBALL_FUNCTION T bulk_viscosity(const T& linear, const T& quadratic, const T& density, const T& sound_speed,
                                  const T& length, const T& rate) {
  const T compression = maximum(T(0), T(-1) * rate);  // if (rate < 0) compression = -rate; else 0
  return density * length * (linear * sound_speed + quadratic * quadratic * length * compression);
}

}  // namespace pinball
