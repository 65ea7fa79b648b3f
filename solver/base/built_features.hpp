#pragma once

#include <string_view>

#ifndef PINBALL_WITHOUT
#define PINBALL_WITHOUT ""  // names of features with commas between them, of CMake's option PINBALL_WITHOUT
#endif

/// What this program can do at all. PINBALL_WITHOUT leaves features out, to measure what they cost a scene that does
/// not use them (bench/without): nothing, where the choice is made once or by one branch in a step.
namespace pinball::built {

inline constexpr std::string_view left_out = "," PINBALL_WITHOUT ",";

/// name: with a comma before and after it.
constexpr bool with(std::string_view name) { return left_out.find(name) == std::string_view::npos; }

inline constexpr bool contact = with(",contact,");
inline constexpr bool boundary_conditions =
    with(",boundary_conditions,");                        ///< loads, damping, constraints, rigid walls
inline constexpr bool plasticity = with(",plasticity,");  ///< without it there is no erosion either
inline constexpr bool erosion = with(",erosion,");
inline constexpr bool bulk_viscosity = with(",bulk_viscosity,");
inline constexpr bool hourglass = with(",hourglass,");
inline constexpr bool resting = with(",resting,");  ///< leaving out tiles at rest, and keeping their stable step

}  // namespace pinball::built
