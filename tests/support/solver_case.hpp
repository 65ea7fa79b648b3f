#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <kernels/exec.hpp>
#include <solver/base/error.hpp>
#include <solver/verification/solver_run.hpp>
#include <tests/support/error_of.hpp>

/// Scenes of a few blocks, made in code, for the tests of the solver.
namespace pinball::test {

/// These scenes are too small for threads: waiting for each other would take most of the time.
inline const bool one_thread = [] {
  DefaultExecutionSpace::set_concurrency(1);
  return true;
}();

/// Steel-like, in units of m, kg and s.
inline Material elastic_material(const std::string& name = "steel", double poisson_ratio = 0.3) {
  Material m;
  m.name = name;
  m.density = 7850;
  const double young = 2.1e11;
  m.bulk_modulus = young / (3 * (1 - 2 * poisson_ratio));
  m.shear_modulus = young / (2 * (1 + poisson_ratio));
  return m;
}

inline Material plastic_material(const std::string& name, double yield_stress, double erosion_strain) {
  Material m = elastic_material(name);
  m.plastic = true;
  m.yield_stress = yield_stress;
  m.plastic_modulus = 1e9;
  m.erosion_strain = erosion_strain;
  return m;
}

/// As dense and stiff as steel, so that what strikes it does so in the same time, but it crushes, and its strength
/// grows with the pressure.
inline Material soil_material(const std::string& name) {
  Material m = plastic_material(name, 0, 0);
  m.plastic_modulus = 0;
  m.bulk_modulus = 1.5e11;
  m.drucker_prager = DruckerPragerSettings{1e15, 2e7, 0.05};
  EquationOfStateSettings& pressure = m.equation_of_state.emplace();
  pressure.form = EquationOfStateForm::tabulated;
  pressure.volume_strain = {0, -0.001, -0.01, -0.3};
  pressure.pressure = {0, 1e8, 2e8, 4e10};
  pressure.unloading_modulus = {1.5e11, 1.6e11, 1.7e11, 2e11};
  return m;
}

/// As dense and stiff as steel, as above, but each of its principal stresses yields by itself, with air and a damping.
inline Material foam_material(const std::string& name) {
  Material m = plastic_material(name, 0, 0);
  m.plastic_modulus = 0;
  m.bulk_modulus = 8e10;
  m.shear_modulus = 9e10;
  m.crushable_foam = CrushableFoamSettings{{0, 0.005, 0.3, 0.6}, {3e8, 4e8, 6e8, 3e10}, 2e8, 0.02, 1e8, 0.2};
  return m;
}

/// A block of cubic elements of size h.
inline Body block(const std::string& name, const std::array<int, 3>& elements, double h, const Point& corner,
                  const Point& velocity = {}, const std::string& material = "steel") {
  Body body;
  body.name = name;
  body.material = material;
  body.mesh = BlockMesh{{elements[0] * h, elements[1] * h, elements[2] * h}, elements};
  body.position = corner;
  body.velocity = velocity;
  return body;
}

/// Everything else at its default, but for the bulk viscosity, which is off, and the report's own algorithm: penalty
/// contact between balls, hourglass control by stiffness.
inline Scene scene_of(const std::vector<Body>& bodies, double end, bool contact = true) {
  Scene scene;
  scene.name = "test";
  scene.units = "kg-m-s";
  scene.time.end = end;
  scene.element.bulk_viscosity = false;
  scene.element.hourglass = HourglassControl::stiffness;
  scene.contact.method = contact ? ContactMethod::pinball : ContactMethod::none;
  scene.contact.enforcement = Enforcement::penalty;
  scene.contact.gap = ContactGap::pinball;
  scene.materials = {elastic_material()};
  scene.bodies = bodies;
  return scene;
}

/// Two wide blocks whose meshes do not fit, pressed together and sliding, on a plane of symmetry: thousands of rows of
/// impulses in several colours, worked by more than one thread.
inline Scene wide_blocks(double end) {
  Scene scene = scene_of({block("a", {40, 36, 1}, 0.1, {0, 0, 0}, {0, 0, 10}),
                          block("b", {47, 43, 1}, 0.085, {0.05, 0, 0.1001}, {20, 0, -10})},
                         end);
  scene.contact.enforcement = Enforcement::lagrange;
  scene.contact.gap = ContactGap::face;
  scene.contact.friction = 0.1;
  scene.contact.static_friction = 0.1;
  scene.constraints = {{{0, 0, 0}, {0, 1, 0}, ""}};
  return scene;
}

/// Two blocks between a wall and a moved end, damped and loaded, in contact: every kind of boundary condition.
inline Scene pressed_blocks(double end) {
  Scene scene = scene_of(
      {block("a", {6, 5, 7}, 0.1, {0, 0, 0}, {0.5, 0, -20}), block("b", {4, 5, 4}, 0.1, {0.1, 0, 0.73}, {0, 0, -50})},
      end);
  scene.rigid_walls = {{"floor", {{0, 0, 0}, {0, 0, 1}}, "", "here"},
                       {"side", {{0.61, 0, 0}, {-1, 0, 0}}, "a", "here"}};
  scene.constraints = {{{0, 0, 0}, {0, 1, 0}, ""}};
  PrescribedVelocity push;
  push.nodes.plane = Plane{{0, 0, 1.13}, {0, 0, 1}};
  push.velocity = {0, 3, -50};
  scene.prescribed_velocities = {push};
  NodalLoad load;
  load.nodes.body = "a";
  load.force = {1e6, 2e5, 0};
  scene.loads = {load};
  scene.damping.mass = 100;
  return scene;
}

/// How far the ball of a cubic element of size 1 reaches out of its face, twice: the gap at which two faces touch.
inline const double touching_gap = 2 * std::cbrt(3 / (4 * M_PI)) - 1;

template <class S>
void run(Solver<S>& solver) {
  while (!solver.at_end()) solver.step();
  solver.finish();
}

/// Runs to the end; returns the largest error of the energy balance on the way.
inline double worst_balance_of_run(Solver<double>& solver) {
  double worst = 0;
  run_to_end(solver, [&] { worst = std::max(worst, std::abs(solver.balance_error())); });
  return worst;
}

/// Has elements of the scene eroded in the coming step, as if they had been strained too far.
template <class S>
void strain_to_failure(Solver<S>& solver, const std::vector<std::size_t>& elements) {
  for (const std::size_t e : elements) {
    solver.change_model().elements.plastic_strain[solver.model().slot_of_element[e]] = S(1e3);
  }
}

template <class S>
double kinetic_energy(const Solver<S>& solver) {
  double twice = 0;
  for (std::size_t n = 0; n < solver.model().node_mass.size(); ++n) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto v = static_cast<double>(solver.model().nodes.velocity[4 * n + k]);
      twice += solver.model().node_mass[n] * v * v;
    }
  }
  return 0.5 * twice;
}

/// The InputError of building the solver of a scene.
inline std::string input_error_of(const Scene& scene) {
  return error_of([&] { const Solver<double> solver(scene); });
}

}  // namespace pinball::test
