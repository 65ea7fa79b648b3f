#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include <tests/support/cube_text.hpp>
#include <tests/support/folder_case.hpp>

#include "rigid_case.hpp"

/// Bodies that deform and have nodes in common with a rigid one: a bar on z >= 0 at whose end a rigid block sits.
namespace pinball::rigid_shared_test {
namespace {

using namespace test;

class RigidShared : public FolderTest {
 protected:
  static constexpr int of_bar = 200, of_block = 8;
  static constexpr double h = 0.01, density = 7850, young = 2.1e11;
  static constexpr double block_mass = density * h * h * h * of_block;

  /// Cubes of h in a row, those of the block last.
  Scene bar_and_block(double end) const {
    const std::string path = folder_ / "bar.k";
    std::string nodes, solids;
    for (int i = 0; i <= of_bar + of_block; ++i) nodes += square_lines(4 * i + 1, i);
    for (int i = 0; i < of_bar + of_block; ++i) {
      solids += fmt::format("{},{}", i + 1, i < of_bar ? 1 : 2);
      for (int corner = 1; corner <= 8; ++corner) solids += fmt::format(",{}", 4 * i + corner);
      solids += '\n';
    }
    std::ofstream(path) << "*KEYWORD\n*PART\nbar\n1,1,1\n*PART\nblock\n2,1,1\n*NODE\n"
                        << nodes << "*ELEMENT_SOLID\n"
                        << solids << "*END\n";
    Scene scene = scene_of({Body(), Body()}, end, false);
    scene.materials = {elastic_material("steel", 0.0)};
    scene.element.bulk_viscosity = true;
    for (std::size_t b = 0; b < 2; ++b) {
      scene.bodies[b].name = b == 0 ? "bar" : "block";
      scene.bodies[b].material = "steel";
      scene.bodies[b].mesh = FileMesh{MeshFormat::keyword, path, b == 0 ? "1" : "2", h};
    }
    scene.rigid_bodies = {rigid("block")};
    return scene;
  }
  static double impedance() { return h * h * std::sqrt(young * density); }  ///< rho c A
};

/// A wave of the stress rho c v goes into the bar from the middle of its last element: half of that begins with the
/// block.
TEST_F(RigidShared, ABarSlowsABlockDownAsThePressureOfTheWaveHasIt) {
  Scene scene = bar_and_block(6e-5);
  scene.bodies[1].velocity = {0, 0, -1};
  Solver<double> solver(scene);
  const Point before = momentum(solver);
  EXPECT_NEAR(solver.rigid().results()[0].velocity[2], -1, 1e-15);
  EXPECT_EQ(solver.model().rigid.at(0).nodes.size(), 4U * (of_block + 1));
  EXPECT_NEAR(solver.rigid().results()[0].mass, block_mass + density * h * h * h / 2, 1e-12);
  double most = 0;
  while (solver.time() < scene.time.end) {
    solver.step();
    const double since = solver.time() - 0.5 * solver.dt() - 0.5 * h / std::sqrt(young / density);
    const double expected = std::exp(-impedance() * std::max(since, 0.0) / block_mass);
    most = std::max(most, std::abs(-solver.rigid().results()[0].velocity[2] - expected));
  }
  EXPECT_LT(most, 0.005);
  EXPECT_NEAR(std::exp(-impedance() * scene.time.end / block_mass), 0.02, 0.01) << "most of it is in the wave";
  EXPECT_NEAR(momentum(solver)[2], before[2], 1e-12 * std::abs(before[2]));
  EXPECT_LT(solver.ledger().balance_error_in_motion_max(), 5e-4);
  const FieldSnapshot now = snapshot(solver);
  for (std::size_t n = 4 * of_bar; n < now.position.size(); ++n) {
    const std::size_t below = 4 * of_bar + n % 4;
    EXPECT_NEAR(now.position[n][2] - now.position[below][2], h * static_cast<double>(n / 4 - of_bar), 1e-14) << n;
  }
}

/// The reaction of what moves the block is the force at the end of the bar.
TEST_F(RigidShared, ABlockThatIsMovedPressesOnItsBar) {
  Scene scene = bar_and_block(1e-4);
  scene.bodies[1].velocity = {0, 0, -1};
  RigidMotion motion;
  motion.rigid_body = "block";
  motion.direction = {0, 0, -1};
  motion.speed = 1;
  scene.rigid_motions = {motion};
  Solver<double> solver(scene);
  const double before = momentum(solver)[2];
  run(solver);
  EXPECT_NEAR(-solver.rigid().results()[0].force[2] / impedance(), 1, 0.01);
  EXPECT_NEAR((before - momentum(solver)[2]) / (impedance() * scene.time.end), 1, 0.01);
}

}  // namespace
}  // namespace pinball::rigid_shared_test
