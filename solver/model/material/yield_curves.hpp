#pragma once

#include <vector>

#include <kernels/material/yield_curve.hpp>
#include <solver/scene.hpp>

namespace pinball {

/// The arrays of HardeningConstants.
template <class S>
struct YieldCurves {
  std::vector<S> strain, stress, slope, rate;
};

/// Whether a material needs more than MaterialConstants say (YieldLaw::general).
bool has_general_yield(const Material& material);

StrainRateMeasure strain_rate_measure(StrainRate rate);

/// The curves of a material, all of them at the plastic strains of any; linear hardening is a curve, too.
template <class S>
YieldCurves<S> yield_curves(const Material& material);

/// curves: of the material; they have to outlive the constants.
template <class S>
HardeningConstants<S> hardening_constants(const Material& material, const YieldCurves<S>& curves);

}  // namespace pinball
