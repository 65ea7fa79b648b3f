#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "cases.hpp"
#include "solver_run.hpp"

/// Verification of yield in bending: the limit load of a cantilever.
namespace pinball {

namespace {

struct LimitLoad {
  double force;                   ///< at the end, over the last three tenths of its way
  double hourglass_energy;        ///< at the end, over the internal energy
  double least_hourglass_energy;  ///< over the largest
  double balance_error;           ///< largest
};

LimitLoad limit_load(const Scene& cantilever, int layers, HourglassControl hourglass) {
  Scene scene = cantilever;
  BlockMesh& mesh = std::get<BlockMesh>(scene.bodies[0].mesh);
  mesh.elements = {10 * layers, layers, 1};
  scene.element.hourglass = hourglass;
  scene.element.hourglass_coefficient = default_hourglass_coefficient(hourglass);
  Solver<double> solver(scene);
  const std::vector<Point>& nodes = solver.mesh().nodes;
  const std::size_t end =
      std::find_if(nodes.begin(), nodes.end(), [&](const Point& p) { return p[0] > mesh.size[0] * (1 - 1e-9); }) -
      nodes.begin();
  const PrescribedVelocity& moved = scene.prescribed_velocities.at(0);
  const double start = nodes[end][1], last = moved.velocity[1] * (scene.time.end - 0.5 * moved.table.times.back());
  LimitLoad load{};
  double way = 0, work = 0, least = 0, largest = 0;
  run_to_end(solver, [&] {
    const double displacement = position_of(solver, end)[1] - start;
    if (displacement < 0.7 * last) way = displacement, work = solver.energies().external;
    least = std::min(least, solver.energies().hourglass);
    largest = std::max(largest, solver.energies().hourglass);
    load.balance_error = std::max(load.balance_error, std::abs(solver.balance_error()));
  });
  load.force = (solver.energies().external - work) / (position_of(solver, end)[1] - start - way);
  load.hourglass_energy = solver.energies().hourglass / solver.energies().internal;
  load.least_hourglass_energy = least / largest;
  return load;
}

}  // namespace

std::vector<VerificationRow> verify_plastic_cantilever(const Scene& scene) {
  const Point& size = std::get<BlockMesh>(scene.bodies[0].mesh).size;
  const double exact = scene.materials[0].yield_stress * size[2] * size[1] * size[1] / (4 * size[0]);
  const struct {
    HourglassControl hourglass;
    const char* name;
    int layers;
    double tolerance;
  } beams[] = {{HourglassControl::assumed_strain, "assumed strains", 1, 0.12},
               {HourglassControl::assumed_strain, "assumed strains", 2, 0.06},
               {HourglassControl::assumed_strain, "assumed strains", 4, 0.05},
               {HourglassControl::stiffness, "hourglass stiffness", 2, 0.16},
               {HourglassControl::stiffness, "hourglass stiffness", 4, 0.13}};
  std::vector<VerificationRow> rows;
  double least = 0, balance_error = 0;
  for (const auto& beam : beams) {
    const LimitLoad load = limit_load(scene, beam.layers, beam.hourglass);
    rows.push_back(
        compare(fmt::format("limit load / exact, {} layer{}, {}", beam.layers, beam.layers == 1 ? "" : "s", beam.name),
                load.force / exact, 1.0, beam.tolerance, "plastic moment at the root, Y b h^2/(4 L)"));
    if (beam.layers == 1) {
      rows.push_back(compare_with_zero("hourglass energy / internal energy, 1 layer", load.hourglass_energy, 0.2,
                                       "of the beam, 1/2 M^2 L/(3 E I), over the work of the load"));
    }
    least = std::min(least, load.least_hourglass_energy);
    balance_error = std::max(balance_error, load.balance_error);
  }
  rows.push_back(compare_with_zero("least hourglass energy / largest", least, 1e-12, "nothing comes from nothing"));
  rows.push_back(compare_with_zero("largest error of the energy balance", balance_error, 1e-3, "conservation"));
  return rows;
}

}  // namespace pinball
