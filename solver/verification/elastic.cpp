#include <cmath>
#include <numbers>

#include <solver/base/point.hpp>

#include "cases.hpp"
#include "solver_run.hpp"

/// elastic_cycles: elasticity that gives back what it took, along closed paths of large strain.
namespace pinball {

namespace {

using Matrix = std::array<Point, 3>;

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix c{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) c[i][j] += a[i][k] * b[k][j];
    }
  }
  return c;
}

double determinant(const Matrix& a) { return dot(a[0], cross(a[1], a[2])); }

/// Deformation gradient of the cube after a part s of its way, 0 to 1: its top goes twice in a circle while the cube is
/// stretched to 1.5, narrowed and turned about z, and all comes back.
Matrix way_of_cube(double s) {
  const double turn = 2 * std::numbers::pi * s, swell = std::sin(std::numbers::pi * s) * std::sin(std::numbers::pi * s);
  const double x = 0.4 * (1 - std::cos(2 * turn)), y = 0.4 * std::sin(2 * turn);
  const Matrix sheared{{{1 + 0.5 * swell, 0, x}, {0, 1 - 0.3 * swell, y}, {0, 0, 1 + 0.2 * std::sin(turn)}}};
  const double c = std::cos(turn), n = std::sin(turn);
  return product({{{c, -n, 0}, {n, c, 0}, {0, 0, 1}}}, sheared);
}

/// The compressible neo-Hookean solid (kernels/material/neo_hookean.hpp) after a deformation gradient.
struct NeoHookean {
  std::array<double, 6> stress;  ///< xx yy zz xy yz zx
  double energy;                 ///< per initial volume

  NeoHookean(const Material& m, const Matrix& f) {
    const double lambda = m.bulk_modulus - 2 * m.shear_modulus / 3, mu = m.shear_modulus, j = determinant(f);
    const auto b = [&f](std::size_t i, std::size_t k) { return dot(f[i], f[k]); };
    const double u = 0.5 * lambda * (j - 1 / j);
    const auto direct = [&](std::size_t i) { return mu / j * (b(i, i) - 1) + u; };
    stress = {direct(0), direct(1), direct(2), mu / j * b(0, 1), mu / j * b(1, 2), mu / j * b(2, 0)};
    energy = 0.5 * mu * (b(0, 0) + b(1, 1) + b(2, 2) - 3) - mu * std::log(j) +
             0.5 * lambda * (0.5 * (j * j - 1) - std::log(j));
  }
};

}  // namespace

std::vector<VerificationRow> verify_elastic_cycles(const Scene& scene) {
  const Material& m = scene.materials[0];
  const BlockMesh& cube = std::get<BlockMesh>(scene.bodies[0].mesh);
  const BlockMesh& bar = std::get<BlockMesh>(scene.bodies[1].mesh);
  const Point centre{scene.bodies[1].position[0] + 0.5 * bar.size[0], scene.bodies[1].position[1] + 0.5 * bar.size[1],
                     0.0};
  const double cube_volume = cube.size[0] * cube.size[1] * cube.size[2];
  const double end = scene.time.end, largest_twist = 1.0 / bar.size[2];
  const auto twist = [&](double t) { return largest_twist * std::pow(std::sin(std::numbers::pi * t / end), 2); };
  Solver<double> solver(scene);
  PrescribedMotion motion(solver, [&](const Point& x, double t) {
    Point to{};
    if (x[0] < 1.5 * cube.size[0]) {
      const Matrix f = way_of_cube(t / end);
      for (std::size_t i = 0; i < 3; ++i) to[i] = dot(f[i], x);
      return to;
    }
    const double angle = twist(t) * x[2], dx = x[0] - centre[0], dy = x[1] - centre[1];
    return Point{centre[0] + std::cos(angle) * dx - std::sin(angle) * dy,
                 centre[1] + std::sin(angle) * dx + std::cos(angle) * dy, x[2]};
  });

  // The twist keeps volumes and lengths along the bar: strains are shears of twist times radius, and the energy that of
  // mu/2 (twist r)^2 over the square, whose polar second moment is a^4/6.
  const double a = bar.size[0], moment = a * a * a * a / 6;
  const auto energy_of_bar = [&](double t) {
    return 0.5 * m.shear_modulus * twist(t) * twist(t) * moment * bar.size[2];
  };
  double stress_error = 0, energy_error = 0, largest_energy = 0, smallest_energy = 0;
  const auto check = [&] {
    const double t = solver.force_time();
    const NeoHookean exact(m, way_of_cube(t / end));
    const std::array<double, 6> stress = stress_of(solver, 0);
    for (std::size_t c = 0; c < 6; ++c) stress_error = std::max(stress_error, std::abs(stress[c] - exact.stress[c]));
    const double energy = exact.energy * cube_volume + energy_of_bar(t);
    largest_energy = std::max(largest_energy, energy);
    // What hourglass modes of the bar store is part of its elastic energy.
    const double stored = solver.energies().internal + solver.energies().hourglass;
    energy_error = std::max(energy_error, std::abs(stored - energy));
    smallest_energy = std::min(smallest_energy, solver.energies().internal);
  };
  while (!solver.at_end()) {
    motion.step();
    check();
  }
  motion.step();  // of no length
  check();

  // Work is summed by the trapezoidal rule: its error is of the second order in the strain of a step, below 0.01 here.
  const double left = solver.energies().internal + solver.energies().hourglass;
  const std::string source = "closed form, neo-Hookean";
  return {
      compare_with_zero("largest deviation of stress of the cube / shear modulus", stress_error / m.shear_modulus,
                        1e-11, source),
      compare_with_zero("largest deviation of the energy of both / largest energy", energy_error / largest_energy, 0.01,
                        source + "; torsion"),
      compare_with_zero("energy left after the cycle / largest energy", std::abs(left) / largest_energy, 1e-3,
                        "a closed path"),
      compare_with_zero("energy below zero / largest energy", -smallest_energy / largest_energy, 1e-4, "a closed path"),
  };
}

}  // namespace pinball
