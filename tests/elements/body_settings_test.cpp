#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tests/support/solver_case.hpp>

/// Hourglass control and bulk viscosity of a body in the place of those of the scene.
namespace pinball::body_settings_test {
namespace {

using namespace test;
using testing::HasSubstr;
using testing::IsEmpty;

ElementSettings viscous(double coefficient) {
  ElementSettings settings;
  settings.hourglass = HourglassControl::viscous;
  settings.hourglass_coefficient = coefficient;
  settings.bulk_viscosity = false;
  return settings;
}

/// Two blocks of one material that fly apart, each bent and pressed on its way, and a small one whose step all make.
Scene two_flying_blocks() {
  Scene scene =
      scene_of({block("a", {3, 3, 9}, 0.1, {0, 0, 0}, {5, 0, 0}), block("b", {3, 3, 9}, 0.1, {2, 0, 0})}, 1e-3, false);
  for (Body& body : scene.bodies) body.velocity_gradient = {{{-20, 0, 30}, {0, 10, 0}, {40, 0, -10}}};
  scene.bodies.push_back(block("clock", {1, 1, 1}, 0.02, {5, 0, 0}));
  scene.time.steps = 300;
  return scene;
}

/// Places of the nodes of a body after the run.
std::vector<Point> places_of(const Scene& scene, const std::string& body) {
  Solver<double> solver(scene);
  run(solver);
  std::vector<Point> places;
  const Model<double>& model = solver.model();
  for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n) {
    if (model.mesh.body_names[model.mesh.body_of_node[n]] != body) continue;
    const double* x = model.nodes.position_of(model.node_of_scene_node[n]);
    places.push_back({x[0], x[1], x[2]});
  }
  return places;
}

double largest_difference(const std::vector<Point>& a, const std::vector<Point>& b) {
  double largest = 0;
  for (std::size_t n = 0; n < a.size(); ++n) {
    for (std::size_t k = 0; k < 3; ++k) largest = std::max(largest, std::abs(a[n][k] - b[n][k]));
  }
  return largest;
}

TEST(BodySettings, AreThoseOfTheBodyAndOfNoOther) {
  Scene both = two_flying_blocks();
  both.bodies[1].element = viscous(0.02);
  Scene first = both, second = both;
  second.element = *both.bodies[1].element;
  second.bodies[1].element.reset();
  first.bodies[1].element.reset();
  constexpr double rounding = 1e-12;  // elements lie in other tiles
  EXPECT_LT(largest_difference(places_of(both, "a"), places_of(first, "a")), rounding);
  EXPECT_LT(largest_difference(places_of(both, "b"), places_of(second, "b")), rounding);
  EXPECT_GT(largest_difference(places_of(first, "a"), places_of(second, "a")), 1e-7);
  EXPECT_GT(largest_difference(places_of(first, "b"), places_of(second, "b")), 1e-7);
}

TEST(BodySettings, ThatAreThoseOfTheSceneMakeNoPart) {
  Scene scene = two_flying_blocks();
  Solver<double> without(scene);
  scene.bodies[0].element = scene.element;
  Solver<double> with(scene);
  EXPECT_EQ(with.model().parts.size(), 1U);
  run(without);
  run(with);
  EXPECT_EQ(state_hash(with.model()), state_hash(without.model()));
}

TEST(BodySettings, TurnBulkViscosityOnAndOff) {
  Scene scene = two_flying_blocks();
  scene.bodies[0].element = scene.element;
  scene.bodies[0].element->bulk_viscosity = true;
  Solver<double> solver(scene);
  ASSERT_EQ(solver.model().parts.size(), 2U);
  EXPECT_TRUE(solver.model().parts[0].features.bulk_viscosity);
  EXPECT_FALSE(solver.model().parts[1].features.bulk_viscosity);
  run(solver);
  EXPECT_GT(solver.energies().bulk_viscosity, 0);
  EXPECT_LT(std::abs(solver.balance_error()), 1e-3);
}

TEST(BodySettings, AreKeptApartByMaterial) {
  Scene scene = two_flying_blocks();
  scene.materials.push_back(elastic_material("softer", 0.1));
  scene.bodies[1].material = "softer";
  scene.bodies[1].element = viscous(0.02);
  scene.bodies.push_back(block("c", {1, 1, 1}, 0.1, {4, 0, 0}, {}, "softer"));
  const Solver<double> solver(scene);
  const auto& parts = solver.model().parts;
  ASSERT_EQ(parts.size(), 3U);
  EXPECT_EQ(parts[0].material, 0);
  EXPECT_EQ(parts[1].material, 1);
  EXPECT_EQ(parts[2].material, 1);
  EXPECT_EQ(parts[1].settings.hourglass, HourglassControl::viscous);
  EXPECT_EQ(parts[2].settings.hourglass, HourglassControl::stiffness);
}

TEST(BodySettings, ThatAreUnstableAreToldWithTheBody) {
  Scene scene = two_flying_blocks();
  scene.bodies.pop_back();
  scene.bodies[1].element = viscous(0.1);
  EXPECT_THAT(Solver<double>(scene).unstable_hourglass(), HasSubstr("body.b.element.hourglass_coefficient = 0.1 is"));
  EXPECT_THAT(Solver<double>(scene).unstable_hourglass(), HasSubstr("QH/4"));
  scene.bodies[1].element = viscous(0.02);
  EXPECT_THAT(Solver<double>(scene).unstable_hourglass(), IsEmpty());
  scene.bodies[1].element->hourglass = HourglassControl::stiffness;
  scene.bodies[1].element->hourglass_coefficient = 10;
  EXPECT_THAT(Solver<double>(scene).unstable_hourglass(), HasSubstr("body.b.element.hourglass_coefficient = 10 is"));
}

}  // namespace
}  // namespace pinball::body_settings_test
