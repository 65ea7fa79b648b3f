#pragma once

#include <array>
#include <string_view>

namespace pinball {

/// What output.fields may name. `velocity` brings `displacement`, `stress` the pressure.
inline constexpr std::array<std::string_view, 12> field_names = {
    "velocity",     "contact_force", "stress",       "plastic_strain", "pinball_radius", "alive",
    "displacement", "pressure",      "corner_share", "triaxiality",    "temperature",    "damage"};

}  // namespace pinball
