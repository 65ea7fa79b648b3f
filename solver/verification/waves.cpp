#include <fmt/core.h>

#include <cmath>

#include <solver/base/interpolation.hpp>

#include "cases.hpp"
#include "reference_table.hpp"
#include "solver_run.hpp"

/// Verification of elastic-plastic waves in uniaxial strain, with a rigid wall.
namespace pinball {

namespace {

constexpr const char* stations[] = {"0.0001", "0.25", "0.5", "0.75", "0.9999"};  // X in the columns of the reference

/// The column of the scene in n cubic elements.
Scene column_of(const Scene& scene, int n, bool bulk_viscosity) {
  Scene column = scene;
  BlockMesh& mesh = std::get<BlockMesh>(column.bodies[0].mesh);
  const double h = mesh.size[2] / n;
  mesh = BlockMesh{{h, h, mesh.size[2]}, {1, 1, n}};
  column.element.bulk_viscosity = bulk_viscosity;
  column.probes.clear();
  return column;
}

/// Speeds and states behind the fronts, in closed form for small strains.
struct ExactWaves {
  double elastic_speed, plastic_speed;    ///< [length/time]
  double elastic_velocity;                ///< jump of the velocity in the elastic wave [length/time]
  double elastic_stress, plateau_stress;  ///< compressive, behind the elastic and behind the plastic wave [stress]
};

ExactWaves exact_waves(const Material& m, double impact_velocity) {
  ExactWaves w{};
  w.elastic_speed = std::sqrt((m.bulk_modulus + 4.0 / 3.0 * m.shear_modulus) / m.density);
  const double tangent = m.shear_modulus * m.plastic_modulus / (3 * m.shear_modulus + m.plastic_modulus);
  w.plastic_speed = std::sqrt((m.bulk_modulus + 4.0 / 3.0 * tangent) / m.density);
  const double modulus = m.bulk_modulus + 4.0 / 3.0 * m.shear_modulus;
  w.elastic_stress = m.yield_stress * modulus / (2 * m.shear_modulus);
  w.elastic_velocity = w.elastic_stress / (m.density * w.elastic_speed);
  w.plateau_stress = w.elastic_stress + m.density * w.plastic_speed * (impact_velocity - w.elastic_velocity);
  return w;
}

/// What one run is compared by.
struct ColumnRun {
  std::vector<double> times;                  ///< of the velocities: middles of steps
  std::vector<std::vector<double>> velocity;  ///< per station, per time
  std::vector<double> stress_times, plateau;  ///< mean axial stress of the elements below a quarter of the length
};

ColumnRun run_column(const Scene& scene) {
  Solver<double> solver(scene);
  const std::size_t n = std::get<BlockMesh>(scene.bodies[0].mesh).elements[2];
  const double length = std::get<BlockMesh>(scene.bodies[0].mesh).size[2];
  ColumnRun run;
  run.velocity.resize(std::size(stations));
  const auto after_step = [&] {
    run.times.push_back(solver.time() - 0.5 * solver.dt());
    for (std::size_t s = 0; s < std::size(stations); ++s) {
      // Between the two nodes around the station, along one edge of the column: four nodes per layer.
      const double place = std::stod(stations[s]) / length * n;
      const auto layer = static_cast<std::size_t>(place);
      const double part = place - layer;
      const double below = velocity_of(solver, 4 * layer)[2], above = velocity_of(solver, 4 * (layer + 1))[2];
      run.velocity[s].push_back((1 - part) * below + part * above);
    }
    run.stress_times.push_back(solver.force_time());
    double sum = 0;
    const std::size_t quarter = n / 4;
    for (std::size_t e = 0; e < quarter; ++e) sum -= stress_of(solver, e)[2];
    run.plateau.push_back(sum / quarter);
  };
  run_to_end(solver, after_step);
  return run;
}

/// Mean over the stations and over the times of the reference of |v - v_exact| / v_impact.
double velocity_error(const ColumnRun& run, const ReferenceTable& exact, double end, double impact_velocity) {
  const std::vector<double>& times = exact.column("t");
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t s = 0; s < std::size(stations); ++s) {
    const std::vector<double>& v = exact.column(fmt::format("v_X{}", stations[s]));
    for (std::size_t i = 1; i < times.size() && times[i] <= end; ++i, ++count) {
      sum += std::abs(interpolate(run.times, run.velocity[s], times[i]) - v[i]) / impact_velocity;
    }
  }
  return sum / count;
}

/// First time at which the velocity at a station passes a value.
double arrival(const ColumnRun& run, std::size_t station, double velocity) {
  const std::vector<double>& v = run.velocity[station];
  for (std::size_t i = 1; i < v.size(); ++i) {
    if (v[i] < velocity) continue;
    const double part = (velocity - v[i - 1]) / (v[i] - v[i - 1]);
    return run.times[i - 1] + part * (run.times[i] - run.times[i - 1]);
  }
  return std::nan("");
}

}  // namespace

std::vector<VerificationRow> verify_plate_impact(const Scene& scene) {
  const double impact = -scene.bodies[0].velocity[2];
  const ExactWaves exact = exact_waves(scene.materials[0], impact);
  const ReferenceTable reference(scene.path, "plate_impact_copper_exact.csv");
  std::vector<VerificationRow> rows;

  // Speeds from the times at which the middles of the two jumps pass X = 0.25 and X = 0.75, before anything has come
  // back: a front that is spread alike at both places does not err.
  const ColumnRun fine = run_column(column_of(scene, 200, true));
  const auto speed = [&](double velocity) { return 0.5 / (arrival(fine, 3, velocity) - arrival(fine, 1, velocity)); };
  const std::string closed = "sqrt((K + 4 G'/3) / density), G' of the branch";
  rows.push_back(compare("speed of the elastic wave [in/s], 200 elements",
                         speed(-impact + 0.5 * exact.elastic_velocity), exact.elastic_speed, 1e-2, closed));
  rows.push_back(compare("speed of the plastic wave [in/s], 200 elements",
                         speed(0.5 * (-impact + exact.elastic_velocity)), exact.plastic_speed, 1e-2, closed));
  // When the plastic wave has reached X = 0.6, the quarter next to the wall is at rest.
  const double rest = 0.6 / exact.plastic_speed;
  rows.push_back(compare("stress behind the plastic wave [lbf/in^2], 200 elements",
                         interpolate(fine.stress_times, fine.plateau, rest), exact.plateau_stress, 1e-2,
                         "jump conditions of both waves"));

  // Error levels of a one-dimensional program of the same element and viscosity, an independent one.
  const struct {
    int elements;
    double viscous, plain;
  } levels[] = {{25, .035, .055}, {50, .024, .039}, {100, .017, .027}, {200, .012, .018}, {400, .008, .012}};
  for (const auto& level : levels) {
    for (const bool viscous : {true, false}) {
      const ColumnRun run = run_column(column_of(scene, level.elements, viscous));
      const double error = velocity_error(run, reference, scene.time.end, impact);
      rows.push_back(compare_with_zero(fmt::format("mean error of velocities / impact velocity, {} elements, {}",
                                                   level.elements, viscous ? "bulk viscosity" : "no viscosity"),
                                       error, viscous ? level.viscous : level.plain,
                                       "exact, by front tracking: plate_impact_copper_exact.csv"));
    }
  }
  return rows;
}

}  // namespace pinball
