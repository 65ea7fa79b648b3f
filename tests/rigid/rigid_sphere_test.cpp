#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "rigid_case.hpp"

/// An elastic sphere strikes a rigid block that is free, slowly: after Hertz (1882), with the mass m M/(m + M), of the
/// mass m that the mesh has.
namespace pinball::rigid_sphere_test {
namespace {

using namespace test;

constexpr double radius = 5, speed = 0.02, young = 1000, poisson = 0.3, density = 0.01;

/// A quarter of both between two planes of symmetry; mass_ratio: of the block to the sphere.
Scene sphere_on_block(double mass_ratio) {
  Material soft = elastic_material("soft");
  soft.density = density;
  soft.bulk_modulus = young / (3 * (1 - 2 * poisson));
  soft.shear_modulus = young / (2 * (1 + poisson));
  Body sphere = block("sphere", {1, 1, 1}, 1, {0, 0, radius + 1e-5}, {0, 0, -speed}, "soft"), floor = sphere;
  SphereMesh mesh;
  mesh.radius = radius;
  mesh.section = Section::quarter;
  mesh.core = {12, 12};
  mesh.ring = 3;
  mesh.grading = 0.05;  // elements of a third of the contact's radius
  sphere.mesh = mesh;
  floor.name = "block";
  floor.mesh = BlockMesh{{2, 2, 1}, {3, 3, 1}};
  floor.position = {0, 0, -1};
  floor.velocity = {};
  Scene scene = scene_of({sphere, floor}, 0.62);
  scene.materials = {soft};
  scene.contact.enforcement = Enforcement::lagrange;
  scene.contact.gap = ContactGap::face;
  scene.constraints = {{{0, 0, 0}, {1, 0, 0}, ""}, {{0, 0, 0}, {0, 1, 0}, ""}};
  scene.rigid_bodies = {rigid("block")};
  scene.rigid_bodies[0].mass = mass_ratio * density * std::numbers::pi * radius * radius * radius / 3;
  return scene;
}

TEST(RigidContact, OfASphereAndABlockIsThatOfHertz) {
  Solver<double> solver(sphere_on_block(2));
  const Model<double>& model = std::as_const(solver).model();
  std::vector<std::size_t> of_sphere;
  double mass = 0;
  for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n) {
    if (model.mesh.body_of_node[n] != 0) continue;
    of_sphere.push_back(model.node_of_scene_node[n]);
    mass += model.node_mass[of_sphere.back()];
  }
  const auto velocity = [&] {
    double sum = 0;
    for (const std::size_t n : of_sphere) sum += model.node_mass[n] * model.nodes.velocity[4 * n + 2] / mass;
    return sum;
  };
  const double block_mass = solver.rigid().results()[0].mass, reduced = 4 * mass * block_mass / (mass + block_mass);
  const double k = 4.0 / 3 * young / (1 - poisson * poisson) * std::sqrt(radius);
  const double approach = std::pow(5 * reduced * speed * speed / (4 * k), 0.4);
  double turn = 0, way = 0, most = 0;
  while (solver.time() < solver.scene().time.end) {
    solver.step();
    const double closing = solver.rigid().results()[0].velocity[2] - velocity();
    if (turn == 0 && closing < 0) turn = solver.time();
    if (solver.counts().pairs() > 0 || way > 0) way += solver.dt() * closing;
    most = std::max(most, way);
  }
  EXPECT_NEAR(most / approach, 1, 0.015);
  EXPECT_NEAR(turn / (0.5 * 2.94328 * approach / speed), 1, 0.015);
  EXPECT_NEAR(velocity() / (speed * (block_mass - mass) / (mass + block_mass)), 1, 1e-3);
  EXPECT_NEAR(solver.rigid().results()[0].velocity[2] / (-2 * speed * mass / (mass + block_mass)), 1, 1e-3);
  EXPECT_LT(solver.ledger().balance_error_in_motion_max(), 1e-3);
}

}  // namespace
}  // namespace pinball::rigid_sphere_test
