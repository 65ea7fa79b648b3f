#pragma once

#include <optional>
#include <string>

#include <solver/scene_rules.hpp>

namespace pinball {

/// Names of the units that follow from a scene's `units` string, and what they are in SI; nothing is ever converted.
///
/// The string names a length, a time and one of mass, force, stress and energy in any order ("in-lbf-s", "kg/mm/ms",
/// "tonne, mm, s"); what it names besides has to follow from these ("g-mm-ms-MPa"). Or a whole system: "SI", "MKS",
/// "CGS". All names are empty where it names none: "", "none".
struct Units {
  std::string length, time, velocity, mass, force, momentum, energy, stress, density;
  double metres = 0, seconds = 0, kilograms = 0;  ///< of length, time and mass; 0: no units are named

  bool known() const { return kilograms > 0; }
  double density_si() const { return kilograms / (metres * metres * metres); }   ///< [kg/m^3]
  double stress_si() const { return kilograms / (metres * seconds * seconds); }  ///< [Pa]
  double velocity_si() const { return metres / seconds; }                        ///< [m/s]
};

/// What is not understood gives no names.
Units parse_units(const std::string& units);

/// Why a string of units is refused.
std::optional<Problem> units_problem(const std::string& units);

/// The `units` string and the unit of every quantity in one line, for the head of an output file:
/// "units: in-lbf-s; time [s]; length [in]; velocity [in/s]; ...". Contains no comma and no line break.
std::string units_line(const std::string& units);

}  // namespace pinball
