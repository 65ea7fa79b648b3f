#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include <solver/scene_rules.hpp>
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
  const Point before = solver.momentum();
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
  EXPECT_NEAR(solver.momentum()[2], before[2], 1e-12 * std::abs(before[2]));
  EXPECT_LT(solver.ledger().balance_error_in_motion_max(), 5e-4);
  const FieldSnapshot now = snapshot(solver);
  for (std::size_t n = 4 * of_bar; n < now.position.size(); ++n) {
    const std::size_t below = 4 * of_bar + n % 4;
    EXPECT_NEAR(now.position[n][2] - now.position[below][2], h * static_cast<double>(n / 4 - of_bar), 1e-14) << n;
  }
}

/// A bar whose last nodes are attached to a block is one that shares nodes of the same places with it.
TEST_F(RigidShared, ABarIsAttachedToABlockByNodes) {
  Scene shared = bar_and_block(2e-5);
  shared.bodies[1].velocity = {0, 0, -1};
  Scene attached = scene_of(
      {block("bar", {1, 1, of_bar}, h, {0, 0, 0}), block("block", {1, 1, of_block}, h, {0, 0, of_bar * h}, {0, 0, -1})},
      2e-5, false);
  attached.materials = shared.materials;
  attached.element = shared.element;
  attached.rigid_bodies = shared.rigid_bodies;
  attached.attached_nodes = {attached_at("block", "bar", of_bar * h)};
  Solver<double> one(shared), other(attached);
  EXPECT_EQ(other.model().rigid.at(0).nodes.size(), one.model().rigid.at(0).nodes.size() + 4);
  run(one);
  run(other);
  const RigidBodyResult expected = one.rigid().results()[0], found = other.rigid().results()[0];
  EXPECT_LT(expected.velocity[2], -0.2);
  EXPECT_GT(expected.velocity[2], -0.8);
  EXPECT_NEAR(found.velocity[2], expected.velocity[2], 1e-12);
  EXPECT_NEAR(found.mass, expected.mass, 1e-12 * expected.mass);
  EXPECT_NEAR(other.momentum()[2], one.momentum()[2], 1e-12);
}

TEST_F(RigidShared, NodesAreAttachedToOneRigidBody) {
  const auto refused = [](const Scene& scene) {
    return error_of([&] { const Solver<double> solver(checked_scene(scene)); });
  };
  Scene scene = scene_of({block("bar", {1, 1, 2}, h, {0, 0, 0}), block("a", {1, 1, 1}, h, {0, 0, 2 * h}),
                          block("b", {1, 1, 1}, h, {0, 0, -h})},
                         1e-5, false);
  scene.rigid_bodies = {rigid("a"), rigid("b")};
  AttachedNodes nodes;
  nodes.rigid_body = "a";
  nodes.nodes.body = "bar";
  scene.attached_nodes = {nodes, nodes};
  EXPECT_EQ(Solver<double>(scene).model().rigid.at(0).nodes.size(), 8U + 12U);
  scene.attached_nodes[1].rigid_body = "b";
  EXPECT_THAT(refused(scene), testing::HasSubstr("rigid_nodes.1: expected rigid bodies without common nodes"));
  scene.attached_nodes[1].rigid_body = "c";
  EXPECT_THAT(refused(scene), testing::HasSubstr("rigid_nodes.1.rigid_body: "));
  scene.attached_nodes = {{"a", {}}};
  EXPECT_THAT(refused(scene), testing::HasSubstr("rigid_nodes.0.body: missing"));
  scene.attached_nodes = {attached_at("a", "bar", 7)};
  EXPECT_THAT(refused(scene), testing::HasSubstr("rigid_nodes.0"));
}

/// A bar without lateral strains hits a plane: that its free end is a rigid body of its own nodes changes nothing.
TEST_F(RigidShared, NodesAloneMakeARigidBody) {
  Scene plain = scene_of({block("bar", {1, 1, of_bar}, h, {0, 0, 0}, {0, 0, -1})}, 2e-4, false);
  plain.materials = bar_and_block(1).materials;
  plain.constraints = {{{0, 0, 0}, {0, 0, 1}, ""}};
  Scene capped = plain;
  capped.rigid_bodies = {RigidBody{.name = "cap"}};
  capped.attached_nodes = {attached_at("cap", "bar", of_bar * h)};
  Solver<double> one(plain), other(checked_scene(capped));
  const RigidBodyResult start = other.rigid().results()[0];
  EXPECT_NEAR(start.mass, density * h * h * h / 2, 1e-12 * start.mass);
  EXPECT_NEAR(start.velocity[2], -1, 1e-15);
  EXPECT_NEAR(start.centre[2], of_bar * h, 1e-14);
  run(one);
  run(other);
  EXPECT_NEAR(other.momentum()[2], one.momentum()[2], 1e-12 * density * h * h * h * of_bar);
  EXPECT_NEAR(other.rigid().results()[0].centre[2], snapshot(one).position.back()[2], 1e-14);
}

TEST_F(RigidShared, ARigidBodyHasBodiesOrNodes) {
  const auto refused = [](const Scene& scene) {
    return error_of([&] { const Solver<double> solver(checked_scene(scene)); });
  };
  Scene scene = scene_of({block("bar", {1, 1, 2}, h, {0, 0, 0})}, 1e-5, false);
  scene.rigid_bodies = {RigidBody{.name = "cap"}};
  EXPECT_THAT(refused(scene), testing::HasSubstr("rigid body cap: expected bodies, or nodes of [[rigid_nodes]]"));
  scene.rigid_bodies[0].mass = 1;
  EXPECT_THAT(refused(scene), testing::HasSubstr("rigid_body.0.mass: expected none without bodies"));
  scene.rigid_bodies = {RigidBody{}};
  EXPECT_THAT(refused(scene), testing::HasSubstr("rigid_body.0.name: missing"));
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
  const double before = solver.momentum()[2];
  run(solver);
  EXPECT_NEAR(-solver.rigid().results()[0].force[2] / impedance(), 1, 0.01);
  EXPECT_NEAR((before - solver.momentum()[2]) / (impedance() * scene.time.end), 1, 0.01);
}

/// Blocks in a row along z: the first one deforms, the second one is rigid; nodes of the first above a height are of
/// it.
Scene turning_blocks(double above, double end) {
  constexpr double size = 0.01;
  Scene scene = scene_of({block("bar", {2, 2, 4}, size, {0, 0, 0}), block("block", {2, 2, 2}, size, {0, 0, 4 * size})},
                         end, false);
  scene.materials = {elastic_material("steel", 0.3)};
  scene.rigid_bodies = {rigid("block")};
  AttachedNodes attached{"block", {}};
  attached.nodes.body = "bar";
  attached.nodes.box = Box{{-1, -1, above * size}, {1, 1, 1}};
  scene.attached_nodes = {attached};
  return scene;
}

/// What turns as a rigid body is not strained, over any time.
TEST(RigidTurning, ElementsWhoseNodesAllTurnWithARigidBodyHaveNoStress) {
  Scene scene = turning_blocks(-1, 2e-3);
  scene.rigid_bodies[0].velocity = {3, 0, 0};
  scene.rigid_bodies[0].angular_velocity = {900, 400, 700};
  Solver<double> solver(scene);
  run(solver);
  EXPECT_GT(solver.steps(), 300);
  for (const std::array<double, 6>& stress : snapshot(solver).stress) {
    for (const double s : stress) EXPECT_LT(std::abs(s), 1e-11 * 2.1e11);
  }
}

TEST(RigidTurning, ABarThatSpinsWithARigidBodyKeepsItsEnergy) {
  Scene scene = turning_blocks(4, 5e-3);  // about a turn
  InitialVelocity spin;
  spin.nodes.box = Box{{-1, -1, -1}, {1, 1, 1}};
  spin.angular_velocity = {1000, 300, 0};
  spin.centre = {0.01, 0.01, 0.03};
  scene.initial_velocities = {spin};
  Solver<double> solver(scene);
  run(solver);
  EXPECT_LT(solver.ledger().balance_error_in_motion_max(), 2e-5);
  double most = 0;  // of centrifugal forces, which come at once: twice rho w^2 l^2/2
  for (const std::array<double, 6>& stress : snapshot(solver).stress) {
    for (const double s : stress) most = std::max(most, std::abs(s));
  }
  EXPECT_LT(most, 3 * 7850 * 1.09e6 * 0.03 * 0.03);
}

/// Elements see no jump where a host has given one spin to all.
TEST(RigidTurning, AHostTurnsARigidBodyAndWhatIsAttachedToIt) {
  Solver<double> solver(turning_blocks(4, 1e-3));
  for (int i = 0; i < 5; ++i) solver.step();
  constexpr double spin = 100;
  Array<double>& velocities = solver.change_velocities();
  for (std::int64_t n = 0; n < solver.model().nodes.count; ++n) {
    const double* const x = solver.model().nodes.position_of(n);
    record(velocities.data(), n)[0] = spin * (x[2] - 0.03);
    record(velocities.data(), n)[2] = -spin * (x[0] - 0.01);
  }
  solver.step();
  EXPECT_NEAR(solver.rigid().results()[0].angular_velocity[1], spin, 1e-3 * spin);
  for (const std::array<double, 6>& stress : snapshot(solver).stress) {
    for (const double s : stress) EXPECT_LT(std::abs(s), 0.01 * 2.1e11 * spin * solver.dt());
  }
}

}  // namespace
}  // namespace pinball::rigid_shared_test
