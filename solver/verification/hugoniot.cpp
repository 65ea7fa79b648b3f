#include <fmt/core.h>

#include <cmath>

#include "cases.hpp"
#include "solver_run.hpp"

/// Verification of equations of state: plane shocks into a material at rest, against the jump conditions.
namespace pinball {

namespace {

struct Metal {
  const char* name;
  double density, sound_speed;  ///< [mass/length^3], c [length/time], as the scene has it
  Point slopes;                 ///< s1, s2, s3 of the equation of state [-]
  double linear, quadratic;     ///< of the Hugoniot u_s = c + linear u_p + quadratic u_p^2 [-], [time/length]
  double gamma, shear_modulus;  ///< [-], [stress]
  double tolerance;             ///< of the pressure
  const char* source;
};

// Copper and aluminium have straight Hugoniots, and the equation of state is made from them. That of iron is bent as
// u_p^2, where the equation of state has (u_p/u_s) u_p: s_2 is such that both meet at 2,000 m/s.
constexpr const char* straight = "rho_0 u_s u_p, u_s = c + s u_p: Marsh 1980";
constexpr Metal metals[] = {{"copper", 8.93e-3, 3940, {1.489, 0, 0}, 1.489, 0, 2.0, 47.7e3, 1e-3, straight},
                            {"aluminium", 2.703e-3, 5350, {1.34, 0, 0}, 1.34, 0, 2.0, 27.6e3, 1e-3, straight},
                            {"iron",
                             7.85e-3,
                             3574,
                             {1.92, -0.485, 0},
                             1.92,
                             -0.068e-3,
                             1.8,
                             80e3,
                             1e-2,
                             "rho_0 u_s u_p, u_s = c + s u_p - 0.068 u_p^2 (km/s): Marsh 1980"}};

Scene struck_by(const Scene& scene, const Metal& metal, double speed, double end) {
  Scene column = scene;
  Material& m = column.materials[0];
  m.density = metal.density;
  m.shear_modulus = metal.shear_modulus;
  m.equation_of_state.value().sound_speed = metal.sound_speed;
  m.equation_of_state.value().slopes = metal.slopes;
  m.equation_of_state.value().gamma = metal.gamma;
  column.bodies[0].velocity = {0, 0, -speed};
  column.time.end = end;
  column.probes.clear();
  return column;
}

/// What is behind the front, between an eighth and a quarter of the length: nearer to the wall is what the shock's
/// start has heated too much.
struct Behind {
  double pressure, volume;  ///< [stress], over that at rest [-]
};

Behind behind_shock(const Scene& scene) {
  Solver<double> solver(scene);
  run_to_end(solver);
  const BlockMesh& mesh = std::get<BlockMesh>(scene.bodies[0].mesh);
  const std::size_t layers = mesh.elements[2], first = layers / 8, last = layers / 4;
  Behind behind{0, 0};
  for (std::size_t e = first; e < last; ++e) {
    const std::array<double, 6> s = stress_of(solver, e);
    behind.pressure -= (s[0] + s[1] + s[2]) / 3 / (last - first);
  }
  const double height = position_of(solver, 4 * last)[2] - position_of(solver, 4 * first)[2];
  behind.volume = height / (mesh.size[2] * static_cast<double>(last - first) / static_cast<double>(layers));
  return behind;
}

/// A table of p = A + B e with A = K ln(rho/rho_0), and K, B that are the same everywhere.
struct Table {
  double density = 8.93e-3, modulus = 140e3, factor = 2;

  /// u_s: with x = u_p/u_s = 1 - V/V_0 and e = p x/2 behind the front, rho_0 u_s u_p = -K ln(1 - x) / (1 - B x/2).
  double shock_speed(double speed) const {
    double low = 0, high = 1;
    for (int i = 0; i < 200; ++i) {
      const double x = 0.5 * (low + high), pressure = -modulus * std::log1p(-x) / (1 - 0.5 * factor * x);
      (pressure < density * speed * speed / x ? low : high) = x;
    }
    return speed / low;
  }
};

Scene struck_by(const Scene& scene, const Table& table, double speed, double end) {
  Scene column = struck_by(scene, metals[0], speed, end);
  EquationOfStateSettings& eos = column.materials[0].equation_of_state.value();
  eos = {};
  eos.form = EquationOfStateForm::tabulated;
  for (const double strain : {0.1, 0.0, -0.05, -0.5}) {
    eos.volume_strain.push_back(strain);
    eos.pressure.push_back(-table.modulus * strain);
    eos.energy_factor.push_back(table.factor);
  }
  column.materials[0].bulk_modulus = table.modulus;
  return column;
}

}  // namespace

std::vector<VerificationRow> verify_hugoniot(const Scene& scene) {
  const double length = std::get<BlockMesh>(scene.bodies[0].mesh).size[2];
  std::vector<VerificationRow> rows;
  for (const Metal& metal : metals) {
    for (const double speed : {200.0, 1000.0, 2000.0}) {
      const double shock = metal.sound_speed + metal.linear * speed + metal.quadratic * speed * speed;
      const Behind found = behind_shock(struck_by(scene, metal, speed, 0.6 * length / shock));
      rows.push_back(compare(fmt::format("pressure behind the shock [MPa], {}, {:g} m/s", metal.name, speed),
                             found.pressure, metal.density * shock * speed, metal.tolerance, metal.source));
      rows.push_back(compare(fmt::format("volume behind the shock / before it, {}, {:g} m/s", metal.name, speed),
                             found.volume, 1 - speed / shock, metal.tolerance, "1 - u_p/u_s"));
    }
  }
  const Table table;
  const double speed = 1000, shock = table.shock_speed(speed);
  const Behind found = behind_shock(struck_by(scene, table, speed, 0.6 * length / shock));
  rows.push_back(compare("pressure behind the shock [MPa], a table, 1000 m/s", found.pressure,
                         table.density * shock * speed, 1e-3, "jump conditions of p = A + B e, A = K ln(rho/rho_0)"));
  rows.push_back(compare("volume behind the shock / before it, a table, 1000 m/s", found.volume, 1 - speed / shock,
                         1e-3, "1 - u_p/u_s"));
  return rows;
}

}  // namespace pinball
