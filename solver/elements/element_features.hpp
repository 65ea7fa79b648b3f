#pragma once

#include <kernels/element_data.hpp>
#include <solver/base/built_features.hpp>

/// From features that are known when a run begins to those of a kernel, each of which is compiled for itself: what is
/// returned is choice.template of<features>(). Features that the program is built without choose those with less.
///
/// Each kernel is seconds of compiling. Bulk viscosity has none of its own: without coefficients the kernel leaves it
/// out. Nor have elements without hourglass control: theirs is the viscous form, of which the coefficient is zero.
namespace pinball {

template <bool plastic, bool erosion, YieldLaw yield, class Choice>
auto choose_hourglass(const Choice& choice, [[maybe_unused]] HourglassKind kind) {
  using enum HourglassKind;
  constexpr bool viscosity = built::bulk_viscosity;
  if constexpr (built::hourglass) {
    if (kind == stiffness) {
      return choice.template of<ElementFeatures{plastic, erosion, viscosity, stiffness, yield}>();
    }
    if (kind == assumed_strain) {
      return choice.template of<ElementFeatures{plastic, erosion, viscosity, assumed_strain, yield}>();
    }
    return choice.template of<ElementFeatures{plastic, erosion, viscosity, viscous, yield}>();
  } else {
    return choice.template of<ElementFeatures{plastic, erosion, viscosity, none, yield}>();
  }
}

/// YieldLaw::general. Nor has erosion one there, which a limit that is never reached keeps away.
template <class Choice>
auto choose_general_features(const Choice& choice, const ElementFeatures& f) {
  return choose_hourglass<true, built::erosion, YieldLaw::general>(choice, f.hourglass);
}

/// Elastic, and YieldLaw::linear.
template <class Choice>
auto choose_linear_features(const Choice& choice, const ElementFeatures& f) {
  if constexpr (built::plasticity && built::erosion) {
    if (f.plastic && f.erosion) return choose_hourglass<true, true, YieldLaw::linear>(choice, f.hourglass);
  }
  if constexpr (built::plasticity) {
    if (f.plastic) return choose_hourglass<true, false, YieldLaw::linear>(choice, f.hourglass);
  }
  return choose_hourglass<false, false, YieldLaw::linear>(choice, f.hourglass);
}

inline bool is_general(const ElementFeatures& f) {
  return built::plasticity && f.plastic && f.yield == YieldLaw::general;
}

}  // namespace pinball
