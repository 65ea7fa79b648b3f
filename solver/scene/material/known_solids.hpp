#pragma once

#include <string>

#include <solver/scene.hpp>
#include <solver/scene/units/units.hpp>

namespace pinball {

/// Why the density and the stiffness of a material are those of no solid in these units, as a sentence; empty: they may
/// be. Where no units are named, whether they are those of one solid in two systems of units.
std::string unlikely_material(const Material& material, const Units& units);

/// Velocity of longitudinal waves [length/time].
double wave_speed(const Material& material);

}  // namespace pinball
