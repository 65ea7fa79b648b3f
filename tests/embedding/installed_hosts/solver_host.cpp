// A host of the solver library, shown in docs/solver_library.md.
// [host]
#include <algorithm>
#include <cstdio>
#include <pinball/solver/simulation.hpp>
#include <vector>

int main() {
  // Two elements on top of each other: the host's own mesh.
  const std::vector<double> x{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1,
                              1, 1, 1, 0, 1, 1, 0, 0, 2, 1, 0, 2, 1, 1, 2, 0, 1, 2};
  const std::vector<std::int64_t> corners{0, 1, 2, 3, 4, 5, 6, 7, 4, 5, 6, 7, 8, 9, 10, 11};

  pinball::Scene scene;  // everything that is not set has the default of a scene file
  scene.time.end = 2e-3;
  pinball::Material& steel = scene.materials.emplace_back();
  steel.name = "steel";
  steel.density = 7850;
  steel.bulk_modulus = 1.75e11;
  steel.shear_modulus = 8.08e10;
  pinball::Body& block = scene.bodies.emplace_back();
  block.name = "block";
  block.material = "steel";
  block.mesh = pinball::ArrayMesh{pinball::view_records(x.data(), 12, 3), pinball::view_records(corners.data(), 2, 8)};
  block.velocity = {0, 0, -10};
  scene.rigid_walls.emplace_back().plane.normal = {0, 0, 1};

  pinball::Simulation simulation(scene);
  const pinball::ConstArrayView positions = simulation.positions();  // the solver's memory, in its own order
  const std::int64_t top = simulation.place_of_node()[8];            // where the ninth node of the host is in it
  double lowest = 2;
  simulation.on_step([&](pinball::Simulation&) {
    lowest = std::min(lowest, positions.number(top, 2));
    return pinball::AfterStep::go_on;
  });
  simulation.run();
  std::printf("lowest top %.5f m, velocity after the rebound %.3f m/s\n", lowest, simulation.bodies()[0].velocity[2]);
}
// [host]
