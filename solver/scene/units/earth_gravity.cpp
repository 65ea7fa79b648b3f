#include "earth_gravity.hpp"

#include <fmt/core.h>

#include <array>
#include <cmath>

namespace pinball {

namespace {

constexpr double earth = 9.80665;  ///< [m/s^2]

struct Acceleration {
  const char* name;
  double si;  ///< [m/s^2]
};
/// Of the systems that people work in (known_solids.cpp).
constexpr std::array accelerations{
    Acceleration{"m/s^2", 1},       Acceleration{"mm/s^2", 1e-3},   Acceleration{"cm/s^2", 1e-2},
    Acceleration{"in/s^2", 0.0254}, Acceleration{"ft/s^2", 0.3048}, Acceleration{"mm/ms^2", 1e3},
    Acceleration{"m/ms^2", 1e6},    Acceleration{"mm/us^2", 1e9},   Acceleration{"cm/us^2", 1e10},
};

/// 9.8 and 9.81, 386 and 386.4, 32.2: as people round them.
bool is_earth(double si) { return std::abs(si / earth - 1) < 1.5e-3; }

/// Ten or a hundred times the earth's, and what else is a load by intention.
bool may_be_meant(double share) {
  return share > 1.5 && share < 500 && std::abs(share - std::round(share)) < 2e-3 * share;
}

}  // namespace

std::string unlikely_gravity(double acceleration, const Units& units) {
  if (!units.known() || !(acceleration > 0)) return "";
  const double si = acceleration * units.metres / (units.seconds * units.seconds), share = si / earth;
  if (is_earth(si) || may_be_meant(share)) return "";
  for (const Acceleration& unit : accelerations) {
    if (!is_earth(acceleration * unit.si)) continue;
    return fmt::format("{:.6g} {}/{}^2 is {:.4g} times the acceleration on earth, which has this number in {}",
                       acceleration, units.length, units.time, share, unit.name);
  }
  return "";
}

}  // namespace pinball
