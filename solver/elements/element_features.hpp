#pragma once

#include <kernels/element_data.hpp>
#include <solver/base/built_features.hpp>

/// From features that are known when a run begins to those of a kernel, each of which is compiled for itself: what is
/// returned is choice.template of<features>(). Features that the program is built without choose those with less.
namespace pinball {

template <bool plastic, bool erosion, bool viscosity, YieldLaw yield, class Choice>
auto choose_hourglass(const Choice& choice, [[maybe_unused]] HourglassKind kind) {
  using enum HourglassKind;
  if constexpr (built::hourglass) {
    if (kind == stiffness) {
      return choice.template of<ElementFeatures{plastic, erosion, viscosity, stiffness, yield}>();
    }
    if (kind == assumed_strain) {
      return choice.template of<ElementFeatures{plastic, erosion, viscosity, assumed_strain, yield}>();
    }
    if (kind == viscous) return choice.template of<ElementFeatures{plastic, erosion, viscosity, viscous, yield}>();
  }
  return choice.template of<ElementFeatures{plastic, erosion, viscosity, none, yield}>();
}

template <bool plastic, bool erosion, YieldLaw yield, class Choice>
auto choose_viscosity(const Choice& choice, const ElementFeatures& f) {
  if constexpr (built::bulk_viscosity) {
    if (f.bulk_viscosity) return choose_hourglass<plastic, erosion, true, yield>(choice, f.hourglass);
  }
  return choose_hourglass<plastic, erosion, false, yield>(choice, f.hourglass);
}

/// YieldLaw::general.
template <class Choice>
auto choose_general_features(const Choice& choice, const ElementFeatures& f) {
  if constexpr (built::plasticity && built::erosion) {
    if (f.erosion) return choose_viscosity<true, true, YieldLaw::general>(choice, f);
  }
  return choose_viscosity<true, false, YieldLaw::general>(choice, f);
}

/// Elastic, and YieldLaw::linear.
template <class Choice>
auto choose_linear_features(const Choice& choice, const ElementFeatures& f) {
  if constexpr (built::plasticity && built::erosion) {
    if (f.plastic && f.erosion) return choose_viscosity<true, true, YieldLaw::linear>(choice, f);
  }
  if constexpr (built::plasticity) {
    if (f.plastic) return choose_viscosity<true, false, YieldLaw::linear>(choice, f);
  }
  return choose_viscosity<false, false, YieldLaw::linear>(choice, f);
}

inline bool is_general(const ElementFeatures& f) {
  return built::plasticity && f.plastic && f.yield == YieldLaw::general;
}

}  // namespace pinball
