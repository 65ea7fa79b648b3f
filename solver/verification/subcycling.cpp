#include <fmt/core.h>

#include <cmath>
#include <utility>

#include "cases.hpp"
#include "solver_run.hpp"

/// Verification of subcycling, on an elastic wave with an exact solution.
namespace pinball {

namespace {

struct LayerRun {
  double velocity_error = 0;  ///< mean over the mass of |v - v_exact| / impact velocity
  double stress = 0;          ///< mean axial stress between the fronts, compressive
  double energy_error = 0;
  double momentum_drift = 0;  ///< over the momentum of one half
  double element_steps = 0;   ///< computed
};

LayerRun run_layer(const Scene& scene, bool subcycling) {
  Scene s = scene;
  s.time.subcycling = subcycling;
  Solver<double> solver(s);
  const Point before = solver.momentum();
  run_to_end(solver);

  const Material& m = s.materials[0];
  const double speed = std::sqrt((m.bulk_modulus + 4.0 / 3.0 * m.shear_modulus) / m.density);
  const double impact = s.bodies[0].velocity[2], middle = 0.5 * std::get<BlockMesh>(s.bodies[0].mesh).size[2];
  const double front = speed * solver.time();
  const Model<double>& model = std::as_const(solver).model();
  LayerRun run;
  double mass = 0;
  for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n) {
    const double height = model.mesh.nodes[n][2] - middle;
    const double exact = std::abs(height) < front ? 0 : -std::copysign(impact, height);
    const double of_node = model.node_mass[model.node_of_scene_node[n]];
    run.velocity_error += of_node * std::abs(velocity_of(solver, n)[2] - exact) / impact;
    mass += of_node;
  }
  run.velocity_error /= mass;
  double mass_between = 0;
  for (std::size_t e = 0; e < model.mesh.hexahedra.size(); ++e) {
    if (std::abs(element_centre(model.mesh, e)[2] - middle) > 0.9 * front) continue;
    run.stress -= model.element_mass[e] * stress_of(solver, e)[2];
    mass_between += model.element_mass[e];
  }
  run.stress /= mass_between;
  RunSummary summary;
  fill_summary(solver, summary);
  run.energy_error = summary.balance_error_max;
  run.momentum_drift = std::abs(solver.momentum()[2] - before[2]) / (0.5 * mass * impact);
  run.element_steps = summary.element_steps;
  return run;
}

}  // namespace

std::vector<VerificationRow> verify_refined_layer(const Scene& scene) {
  const LayerRun with = run_layer(scene, true), without = run_layer(scene, false);
  const Material& m = scene.materials[0];
  const double modulus = m.bulk_modulus + 4.0 / 3.0 * m.shear_modulus;
  const double stress = std::sqrt(m.density * modulus) * scene.bodies[0].velocity[2];
  const std::string wave = "exact: two waves at the speed sqrt((K + 4G/3) / density)";
  std::vector<VerificationRow> rows;
  // Error levels of a one-dimensional program of the same layers, steps and viscosity, an independent one: 0.0278 and
  // 0.0338.
  const struct {
    const LayerRun& run;
    const char* text;
    double velocity_error;
  } variants[] = {{with, "subcycling", 0.028}, {without, "one step for all", 0.034}};
  for (const auto& [run, text, velocity_error] : variants) {
    rows.push_back(compare_with_zero(fmt::format("mean error of velocities / impact velocity, {}", text),
                                     run.velocity_error, velocity_error, wave));
    rows.push_back(compare(fmt::format("mean stress behind the fronts [Pa], {}", text), run.stress, stress, 2e-3,
                           "density times wave speed times velocity"));
    rows.push_back(
        compare_with_zero(fmt::format("drift of the momentum, {}", text), run.momentum_drift, 1e-12, "conservation"));
    rows.push_back(compare_with_zero(fmt::format("largest error of the energy balance, {}", text), run.energy_error,
                                     3e-3, "conservation"));
  }
  rows.push_back(compare_with_zero("mean error of velocities, subcycling / one step for all",
                                   with.velocity_error / without.velocity_error, 1.05, "to be below 1.05"));
  rows.push_back(compare_with_zero("element steps, subcycling / one step for all",
                                   with.element_steps / without.element_steps, 1.0 / 3, "to be below 1/3"));
  return rows;
}

}  // namespace pinball
