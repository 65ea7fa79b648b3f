#pragma once

#include <string>

namespace pinball {

/// Names of the units that follow from a scene's `units` string; nothing is ever converted.
///
/// The string has three parts, the last one time: "LENGTH-FORCE-TIME" ("in-lbf-s") or "LENGTH-MASS-TIME" ("m-kg-s",
/// known by the name of the mass unit). Any other string names at most the time; the other names are then empty.
struct Units {
  std::string length, time, velocity, mass, force, momentum, energy, stress;
};

Units parse_units(const std::string& units);

/// The `units` string and the unit of every quantity in one line, for the head of an output file:
/// "units: in-lbf-s; time [s]; length [in]; velocity [in/s]; ...". Contains no comma and no line break.
std::string units_line(const std::string& units);

}  // namespace pinball
