#pragma once

#include <string>

#include <solver/scene.hpp>
#include <solver/scene/units/units.hpp>

namespace pinball {

/// A number as `pinball info` shows it; unit: may be empty.
std::string with_unit(double value, const std::string& unit);

/// Lines of `pinball info` on how a plastic material yields.
void print_hardening(const Material& material, const Units& units);
/// A line with the limits beyond which its elements are eroded.
void print_limits(const ErosionSettings& erosion, const Units& units);

}  // namespace pinball
