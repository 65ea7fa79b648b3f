#pragma once

#include <kernels/element_data.hpp>
#include <solver/scene.hpp>

namespace pinball {

/// Johnson and Cook's law of a material that has it, and none used of others.
template <class S>
JohnsonCookConstants<S> johnson_cook_constants(const Material& material);

/// Johnson and Holmquist's, the same.
template <class S>
JohnsonHolmquistConstants<S> brittle_constants(const Material& material);

/// Drucker and Prager's, the same.
template <class S>
DruckerPragerConstants<S> granular_constants(const Material& material);

/// Of a foam, the same; its curve is in the place of those of hardening.
template <class S>
CrushableFoamConstants<S> foam_constants(const Material& material);

/// None used of a material that is none, here and below.
template <class S>
MooneyRivlinConstants<S> rubber_constants(const Material& material);
template <class S>
OgdenConstants<S> ogden_constants(const Material& material);
template <class S>
OrthotropicConstants<S> orthotropic_constants(const Material& material);
template <class S>
FluidConstants<S> fluid_constants(const Material& material);

/// The linear pressure of a material without an equation of state.
template <class S>
EquationOfState<S> pressure_constants(const Material& material);

/// The limits of `erosion` of a material, and none of others. smallest_step_at_start: of all elements [time].
template <class S>
FailureLimits<S> failure_limits(const Material& material, double smallest_step_at_start);

/// What the elements of a material keep beside stress and plastic strain, and where. Materials may use the same places,
/// as each element is of one.
MaterialPlaces material_places(const Material& material);

}  // namespace pinball
