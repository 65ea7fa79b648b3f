#include "known_solids.hpp"

#include <fmt/core.h>

#include <array>
#include <cmath>

namespace pinball {

namespace {

struct Solid {
  const char* name;
  double density, young;  ///< [kg/m^3], [Pa]
};

/// Round values at room temperature; alloys of one metal lie within a few per cent of them.
constexpr std::array solids{
    Solid{"steel", 7850, 207e9},       Solid{"aluminium", 2700, 70e9},  Solid{"copper", 8930, 120e9},
    Solid{"titanium", 4480, 114e9},    Solid{"tungsten", 19300, 400e9}, Solid{"tungsten alloy", 17600, 340e9},
    Solid{"lead", 11340, 16e9},        Solid{"tantalum", 16650, 186e9}, Solid{"nickel", 8900, 207e9},
    Solid{"brass", 8500, 105e9},       Solid{"zinc", 7140, 100e9},      Solid{"magnesium", 1760, 45e9},
    Solid{"molybdenum", 10240, 325e9}, Solid{"glass", 2500, 70e9},      Solid{"alumina", 3850, 370e9},
    Solid{"concrete", 2400, 30e9},     Solid{"ice", 917, 9.3e9},
};

/// Systems of units that people work in, in SI.
struct System {
  const char* name;
  double density, stress;  ///< [kg/m^3], [Pa]
};
constexpr std::array systems{
    System{"kg-m-s", 1, 1},
    System{"g-mm-ms", 1e6, 1e6},
    System{"tonne-mm-s", 1e12, 1e6},
    System{"kg-mm-ms", 1e9, 1e9},
    System{"g-cm-us", 1e3, 1e11},
    System{"kg-mm-s", 1e9, 1e3},
    System{"g-cm-s", 1e3, 0.1},
    System{"in-lbf-s", 1.06869e7, 6894.76},
    System{"mg-mm-ms", 1e3, 1e3},
    System{"g-mm-us", 1e6, 1e12},
    System{"ft-lbf-s", 515.379, 47.8803},
    System{"kN-mm-ms", 1e9, 1e9},
};
/// No system has these: densities in pounds, which are forces, per cubic inch.
constexpr System pounds_per_cubic_inch{"lb/in^3", 27679.9, 0};

/// What no solid is, even one that was made heavier or softer on purpose.
constexpr double lightest = 0.5, heaviest = 1e6, stiffest = 1e13, fastest = 5e4;

bool near(double a, double b, double tolerance) { return std::abs(a / b - 1) < tolerance; }
/// How far alloys of one name are from each other.
bool is_density_of(double density, const Solid& solid) { return near(density, solid.density, 0.05); }
bool is_stiffness_of(double young, const Solid& solid) { return near(young, solid.young, 0.15); }

double young_modulus(const Material& m) {
  return 9 * m.bulk_modulus * m.shear_modulus / (3 * m.bulk_modulus + m.shear_modulus);
}

/// "it would be that of steel in kg-m-s"
std::string where_it_would_be(double density, double young) {
  for (const Solid& solid : solids) {
    for (const System& system : systems) {
      const bool fits = is_density_of(density * system.density, solid) && is_stiffness_of(young * system.stress, solid);
      if (fits) return fmt::format("; both are those of {} in {}", solid.name, system.name);
    }
  }
  return "";
}

/// The power of 1000, but not the first, by which a number is off.
double thousands(double ratio, double tolerance) {
  const double power = std::pow(1000, std::round(std::log10(ratio) / 3));
  return power != 1 && near(ratio, power, tolerance) ? power : 0;
}

/// A density or a stiffness of a known solid beside the other one times a power of thousand.
std::string one_of_two(double density, double young) {
  for (const Solid& solid : solids) {
    const double stiffer = thousands(young / solid.young, 0.15), denser = thousands(density / solid.density, 0.05);
    if (is_density_of(density, solid) && stiffer > 0)
      return fmt::format("its density is that of {}, its Young's modulus {:.3g} times as large", solid.name, stiffer);
    if (is_stiffness_of(young, solid) && denser > 0)
      return fmt::format("its Young's modulus is that of {}, its density {:.3g} times as large", solid.name, denser);
  }
  return "";
}

std::string what_is_wrong(double density, double young) {
  const double wave = std::sqrt(young / density);
  const std::string known = one_of_two(density, young);
  if (!known.empty()) return known;
  if (density > heaviest || density < lightest)
    return fmt::format("its density is {:.3g} kg/m^3, beyond all solids", density);
  if (young > stiffest) return fmt::format("its Young's modulus is {:.3g} Pa, beyond all solids", young);
  if (wave > fastest) return fmt::format("waves run through it with {:.3g} m/s, beyond all solids", wave);
  return "";
}

/// Of a scene that names no units.
std::string two_systems(double density, double young) {
  if (!where_it_would_be(density, young).empty()) return "";
  for (const Solid& solid : solids) {
    const char *of_density = nullptr, *of_stress = nullptr;
    for (const System& system : systems) {
      if (of_density == nullptr && is_density_of(density * system.density, solid)) of_density = system.name;
      if (of_stress == nullptr && is_stiffness_of(young * system.stress, solid)) of_stress = system.name;
    }
    if (is_density_of(density * pounds_per_cubic_inch.density, solid)) of_density = pounds_per_cubic_inch.name;
    if (of_density != nullptr && of_stress != nullptr)
      return fmt::format("its density is that of {} in {}, its Young's modulus in {}", solid.name, of_density,
                         of_stress);
  }
  return "";
}

}  // namespace

double wave_speed(const Material& m) { return std::sqrt((m.bulk_modulus + 4.0 / 3.0 * m.shear_modulus) / m.density); }

std::string unlikely_material(const Material& material, const Units& units) {
  const double young = young_modulus(material), density = material.density;
  const std::string head =
      fmt::format("material {}: density {:.6g} and Young's modulus {:.6g}", material.name, density, young);
  if (!units.known()) {
    const std::string wrong = two_systems(density, young);
    return wrong.empty() ? "" : fmt::format("{} belong to different units: {}", head, wrong);
  }
  const std::string wrong = what_is_wrong(density * units.density_si(), young * units.stress_si());
  if (wrong.empty()) return "";
  return fmt::format("{} are {} and {}: {}{}", head, fmt::format("{:.3g} kg/m^3", density * units.density_si()),
                     fmt::format("{:.3g} Pa in the units of the scene", young * units.stress_si()), wrong,
                     where_it_would_be(density, young));
}

}  // namespace pinball
