#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <solver/scene_rules.hpp>

#include "equations_case.hpp"

/// [[equation]] beside contact, walls and subcycling.
namespace pinball::test::equations_beside_test {
namespace {

using testing::HasSubstr;

/// Springs of contact are forces as all others.
TEST(EquationBeside, ContactByPenalty) {
  Scene scene = scene_of({block("a", {2, 2, 2}, 0.1, {0, 0, 0}, {0, 0, 20}), block("b", {2, 2, 2}, 0.1, {0, 0, 0.23}),
                          block("c", {2, 2, 2}, 0.1, {1, 0, 0.23})},
                         1e-3);
  Solver<double> alone(scene);
  const double without = worst_balance_of_run(alone);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::string name = std::string(1, "xyz"[k]);
    scene.equation_terms.push_back(term(name, axes[k], 1, "b"));
    scene.equation_terms.push_back(term(name, axes[k], -1, "c"));
  }
  Solver<double> solver(scene);
  EXPECT_LT(worst_balance_of_run(solver), 1.1 * without) << "that of contact";
  EXPECT_NEAR(solver.momentum()[2], 8 * cube_mass * 20, 1e-9);
  EXPECT_GT(velocity_of(solver, 80)[2], 5) << "c moves with what a has struck";
}

/// a strikes b along z; c follows nodes of b that nothing touches, or follows along x.
TEST(EquationBeside, ImpulsesThatLeaveItAsItIs) {
  for (const Enforcement enforcement : {Enforcement::lagrange, Enforcement::projection}) {
    Scene scene = scene_of({block("a", {2, 2, 2}, 0.1, {0, 0, 0}, {0, 0, 20}),
                            block("b", {2, 2, 3}, 0.1, {0, 0, 0.201}), block("c", {2, 2, 3}, 0.1, {1, 0, 0.201})},
                           4e-4);
    scene.contact.enforcement = enforcement;
    scene.contact.gap = ContactGap::face;
    scene.materials = {elastic_material("steel", 0.0)};  // without contraction faces stay flat
    Solver<double> alone(scene);
    const double without = worst_balance_of_run(alone);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::string name = std::string(1, "xyz"[k]);
      scene.equation_terms.push_back(term(name, axes[k], 1, "b", Plane{{0, 0, 0.501}, {0, 0, 1}}));
      scene.equation_terms.push_back(term(name, axes[k], -1, "c", Plane{{0, 0, 0.501}, {0, 0, 1}}));
    }
    Solver<double> behind(scene);
    EXPECT_LT(worst_balance_of_run(behind), 3 * without);
    EXPECT_NEAR(behind.momentum()[2], 8 * cube_mass * 20, 1e-9);
    const std::size_t b = 27 + 27, c = 27 + 36 + 27;  // their last layers
    for (std::size_t n = 0; n < 9; ++n) {
      EXPECT_NEAR(velocity_of(behind, b + n)[2], velocity_of(behind, c + n)[2], 1e-12);
    }
    EXPECT_GT(velocity_of(behind, c)[2], 0.1) << "c moves with what a has struck";

    scene.equation_terms = {term("x", axes[0], 1, "b"), term("x", axes[0], -1, "c")};
    Solver<double> across(scene);
    run(across);
    EXPECT_GT(velocity_of(across, 27)[2], 1) << "b has been struck";
  }
}

/// Where they do not, at the time when they do not.
TEST(EquationBeside, ImpulsesThatBreakItEndTheRun) {
  Scene scene = scene_of({block("a", {2, 2, 2}, 0.1, {0, 0, 0}, {0, 0, 20}), block("b", {2, 2, 2}, 0.1, {0, 0, 0.204}),
                          block("c", {2, 2, 2}, 0.1, {1, 0, 0.204})},
                         1e-3);
  scene.contact.enforcement = Enforcement::lagrange;
  scene.contact.gap = ContactGap::face;
  scene.equation_terms = {term("z", axes[2], 1, "b"), term("z", axes[2], -1, "c")};
  Solver<double> struck(scene);
  EXPECT_THAT(error_of<RunError>([&] { run(struck); }), HasSubstr("pushes nodes of the equation"));
  EXPECT_GT(struck.time(), 1.5e-4);
  EXPECT_LT(struck.time(), 2.5e-4);
}

/// b slides along a wall, and c follows it; then along the normal of the wall.
TEST(EquationBeside, RigidWalls) {
  Scene scene = two_cubes(1e-3);
  scene.bodies[0].velocity = scene.bodies[1].velocity = {3, 0, -1};
  scene.equation_terms = {term("x", axes[0], 1, "a"), term("x", axes[0], -1, "b")};
  scene.rigid_walls = {{"floor", {{0, 0, 0}, {0, 0, 1}}, "", "here"}};
  NodalLoad pull;
  pull.nodes.body = "a";
  pull.force = {3e4, 0, 0};
  scene.loads = {pull};
  Scene apart = scene;
  apart.equation_terms.clear();
  Solver<double> slides(scene), without(apart);
  EXPECT_LT(worst_balance_of_run(slides), 2 * worst_balance_of_run(without));
  EXPECT_NEAR(slides.momentum()[0], 2 * cube_mass * 3 + slides.time() * 3e4, 1e-10);
  EXPECT_GT(slides.momentum()[2], -1.5 * cube_mass) << "they have met the wall";
  for (std::size_t n = 0; n < 8; ++n) EXPECT_NEAR(velocity_of(slides, n)[0], velocity_of(slides, n + 8)[0], 1e-12) << n;

  scene.rigid_walls[0].plane.point[2] = -5e-4;
  scene.rigid_walls[0].body = "b";
  scene.equation_terms = {term("z", axes[2], 1, "a"), term("z", axes[2], -1, "b")};
  Solver<double> meets(scene);
  EXPECT_THAT(error_of<RunError>([&] { run(meets); }), HasSubstr("pushes nodes of the equation"));
  EXPECT_NEAR(meets.time(), 5e-4, 5e-5);
  scene.rigid_walls[0].plane.point[2] = -1;
  Solver<double> far(scene);
  EXPECT_LT(worst_balance_of_run(far), 1e-9);
}

/// Nodes of equations, of large elements, make the smallest steps.
TEST(EquationBeside, Subcycling) {
  Scene scene = scene_of({block("a", {2, 2, 8}, 0.1, {0, 0, 0}), block("b", {2, 2, 8}, 0.1, {1, 0, 0}),
                          block("fine", {2, 2, 2}, 0.0125, {3, 0, 0})},
                         6e-4, false);
  scene.equation_terms = of_pair(1, -1, Plane{{0, 0, 0.8}, {0, 0, 1}});
  NodalLoad blow;
  blow.nodes.body = "a";
  blow.nodes.plane = Plane{{0, 0, 0}, {0, 0, 1}};
  blow.force = {0, 0, 1e6};
  scene.loads = {blow};
  Solver<double> one(scene);
  run(one);
  scene.time.subcycling = true;
  Scene apart = scene;
  apart.equation_terms.clear();
  Solver<double> several(scene), without(apart);
  const double worst = worst_balance_of_run(without);
  EXPECT_LT(worst_balance_of_run(several), 1.5 * worst + 1e-4);
  ASSERT_GT(several.subcycling()->levels(), 1);
  for (std::size_t n = 0; n < 9; ++n) {
    const std::size_t a = 9 * 8 + n, b = a + 81;
    EXPECT_LT(norm(minus(velocity_of(several, a), velocity_of(several, b))), 1e-12 * 100);
    EXPECT_NEAR(position_of(several, b)[2] - 0.8, position_of(one, b)[2] - 0.8, 1e-2 * (position_of(one, b)[2] - 0.8));
  }
  EXPECT_NEAR(several.momentum()[2], 1e6 * several.time(), 1e-9 * 1e6 * several.time());
}

/// Faces that equations join lie on each other, and touch: contact finds nothing to do.
TEST(EquationBeside, ContactOfTheFacesThatItJoins) {
  constexpr int half = 5;
  Scene scene = scene_of({block("a", {2, 2, half}, 0.1, {0, 0, 0}), block("b", {2, 2, half}, 0.1, {0, 0, half * 0.1})},
                         4e-4, false);
  scene.equation_terms = of_pair(1, -1, Plane{{0, 0, half * 0.1}, {0, 0, 1}});
  NodalLoad blow;
  blow.nodes.body = "a";
  blow.nodes.plane = Plane{{0, 0, 0}, {0, 0, 1}};
  blow.force = {2e5, 0, 1e6};
  scene.loads = {blow};
  Solver<double> alone(scene);
  run(alone);
  for (const Enforcement enforcement : {Enforcement::lagrange, Enforcement::projection}) {
    Scene touching = scene;
    touching.contact.method = ContactMethod::pinball;
    touching.contact.enforcement = enforcement;
    touching.contact.gap = ContactGap::face;
    Solver<double> solver(touching);
    run(solver);
    for (std::size_t n = 0; n < solver.mesh().nodes.size(); ++n)
      EXPECT_LT(norm(minus(position_of(solver, n), position_of(alone, n))), 1e-13) << n;
  }
}

}  // namespace
}  // namespace pinball::test::equations_beside_test
