#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "cases.hpp"
#include "solver_run.hpp"

/// coarse_impact: energies of impacts of which one element has a large part.
namespace pinball {

namespace {

constexpr std::array speeds{100.0, 300.0, 500.0, 1000.0, 1500.0};

/// Cut into n x n x n elements, or 3n x 3n x n for the plate, of one of the materials, at a speed.
Scene impact_of(const Scene& given, int n, const std::string& material, double speed, bool wall) {
  Scene scene = given;
  for (Body& body : scene.bodies) {
    body.material = material;
    for (int& count : std::get<BlockMesh>(body.mesh).elements) count *= n;
  }
  scene.bodies[0].velocity = {0, 0, -speed};
  if (wall) {
    scene.bodies.pop_back();
    scene.rigid_walls = {{"wall", {{0, 0, 0}, {0, 0, 1}}, "", ""}};
  }
  return scene;
}

/// Largest error of the balance on the way, of all speeds.
double worst_balance(const Scene& given, int n, const std::string& material, bool wall) {
  double worst = 0;
  for (const double speed : speeds) {
    Solver<double> solver(impact_of(given, n, material, speed, wall));
    while (!solver.at_end()) solver.step();
    solver.finish();
    worst = std::max(worst, solver.ledger().balance_error_max());
  }
  return worst;
}

}  // namespace

std::vector<VerificationRow> verify_coarse_impact(const Scene& scene) {
  std::vector<VerificationRow> rows;
  for (const bool wall : {true, false}) {
    for (const Material& material : scene.materials) {
      for (const int n : {1, 2}) {
        rows.push_back(compare_with_zero("largest error of the balance, " + material.name +
                                             (wall ? ", wall" : ", plate") + ", n = " + std::to_string(n),
                                         worst_balance(scene, n, material.name, wall), 0.01,
                                         "conservation of energy, 100 to 1,500 m/s"));
      }
    }
  }
  return rows;
}

}  // namespace pinball
