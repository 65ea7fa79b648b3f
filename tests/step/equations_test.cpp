#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <solver/scene_rules.hpp>
#include <tests/support/run_hash.hpp>
#include <tests/support/saved_state.hpp>

#include "equations_case.hpp"

/// [[equation]]: displacements that add up to zero.
namespace pinball::test::equations_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// A wave, and bending, through two bars in series and through one.
TEST(Equation, OfTheEndsOfTwoBarsMakesOneOfThem) {
  constexpr int half = 10;
  const double h = 0.05;
  Scene one = scene_of({block("a", {2, 2, 2 * half}, h, {0, 0, 0})}, 4e-4, false);
  Scene two =
      scene_of({block("a", {2, 2, half}, h, {0, 0, 0}), block("b", {2, 2, half}, h, {0, 0, half * h})}, 4e-4, false);
  two.equation_terms = of_pair(1, -1, Plane{{0, 0, half * h}, {0, 0, 1}});
  for (Scene* scene : {&one, &two}) {
    NodalLoad blow;
    blow.nodes.body = "a";
    blow.nodes.plane = Plane{{0, 0, 0}, {0, 0, 1}};
    blow.force = {2e5, 0, 1e6};
    scene->loads = {blow};
  }
  Solver<double> whole(one), joined(two);
  const double worst = worst_balance_of_run(joined);
  EXPECT_NEAR(worst, worst_balance_of_run(whole), 1e-12);
  EXPECT_EQ(whole.steps(), joined.steps());
  const std::size_t layer = 9, ends = layer * half;
  for (std::size_t n = 0; n < whole.mesh().nodes.size(); ++n) {
    const Point expected = position_of(whole, n), other = position_of(joined, n < ends + layer ? n : n + layer);
    EXPECT_LT(norm(minus(other, expected)), 1e-13) << n;
    if (n >= ends && n < ends + layer) {
      EXPECT_LT(norm(minus(position_of(joined, n + layer), expected)), 1e-13) << n;
    }
  }
  EXPECT_GT(norm(minus(position_of(joined, 0), joined.mesh().nodes[0])), 1e-4) << "it has moved";
}

/// u_b = 2 u_a: what pulls a has the mass m_a + 4 m_b.
TEST(Equation, IsALever) {
  Scene scene = two_cubes(1e-3);
  scene.equation_terms = of_pair(2, -1);
  NodalLoad pull;
  pull.nodes.body = "a";
  pull.force = {3e4, 0, 6e4};
  scene.loads = {pull};
  Solver<double> solver(scene);
  EXPECT_LT(worst_balance_of_run(solver), 1e-13);
  const double time = solver.time(), half = 0.5 * time * time / (5 * cube_mass);
  for (std::size_t n = 0; n < 8; ++n) {
    const Point a = minus(position_of(solver, n), solver.mesh().nodes[n]),
                b = minus(position_of(solver, n + 8), solver.mesh().nodes[n + 8]);
    EXPECT_NEAR(a[0], 3e4 * half, 1e-14);
    EXPECT_NEAR(a[2], 6e4 * half, 1e-14);
    EXPECT_LT(norm(minus(b, {2 * a[0], 2 * a[1], 2 * a[2]})), 1e-14);
  }
}

/// A ring of elements: each wave that fits into it is a mode, wherever its nodes are, and moves as the oscillator of
/// w^2 = 4 c^2/h^2 sin^2(k h/2).
TEST(Equation, OfOppositeFacesMakesACellPeriodic) {
  constexpr int count = 12;
  const double h = 0.1, length = count * h, k = 2 * std::numbers::pi / length, phase = 0.7;
  Scene scene = scene_of({block("a", {1, 1, count}, h, {0, 0, 0})}, 5e-4, false);
  scene.materials = {elastic_material("steel", 0.0)};
  for (int i = 0; i <= count; ++i) {
    InitialVelocity of_layer;
    of_layer.nodes.plane = Plane{{0, 0, i * h}, {0, 0, 1}};
    of_layer.velocity = {0, 0, 1e-6 * std::cos(k * i * h + phase)};
    scene.initial_velocities.push_back(of_layer);
  }
  scene.equation_terms = {term("period", axes[2], 1, "a", Plane{{0, 0, 0}, {0, 0, 1}}),
                          term("period", axes[2], -1, "a", Plane{{0, 0, length}, {0, 0, 1}})};
  Solver<double> solver(scene);
  const double c2 = 2.1e11 / 7850, frequency2 = 4 * c2 / (h * h) * std::pow(std::sin(0.5 * k * h), 2);
  double u = 0, v = 1e-6, before = 0, least = v;
  while (!solver.at_end()) {
    solver.step();
    const double dt = solver.dt();
    v -= 0.5 * (before + dt) * frequency2 * u;
    u += dt * v;
    before = dt;
    least = std::min(least, v);
    for (int i = 0; i <= count; ++i)
      ASSERT_NEAR(velocity_of(solver, 4 * i)[2], v * std::cos(k * i * h + phase), 1e-13) << i;
  }
  EXPECT_LT(least, -0.99e-6) << "more than half a period";
}

/// What is held or moves as given leads the rest, and takes what the equation asks of it.
TEST(Equation, BesideWhatHoldsAndMovesItsNodes) {
  Scene scene = two_cubes(1e-3);
  scene.equation_terms = of_pair(1, -1);
  NodalLoad pull;
  pull.nodes.body = "a";
  pull.force = {3e4, 0, 0};
  scene.loads = {pull};
  FixedConstraint held;
  held.nodes.body = "b";
  held.directions = {{0.6, 0.8, 0}};
  held.name = "hand";
  scene.fixed_constraints = {held};
  Solver<double> fixed(scene);
  EXPECT_LT(worst_balance_of_run(fixed), 1e-13);
  const double way = 0.5 * fixed.time() * fixed.time() * 0.8 * 3e4 / (2 * cube_mass);
  const Point a = minus(position_of(fixed, 3), fixed.mesh().nodes[3]);
  EXPECT_NEAR(a[0], 0.8 * way, 1e-14);
  EXPECT_NEAR(a[1], -0.6 * way, 1e-14);
  const Point force = fixed.boundary().forces(fixed.model()).at(0).force;
  EXPECT_NEAR(force[0], -0.36 * 3e4, 1e-6);
  EXPECT_NEAR(force[1], -0.48 * 3e4, 1e-6);

  scene.fixed_constraints.clear();
  PrescribedVelocity given;
  given.nodes.body = "b";
  given.velocity = {0, 2, 0};
  scene.prescribed_velocities = {given};
  scene.equation_terms = of_pair(1, -3);
  Solver<double> led(scene);
  EXPECT_LT(worst_balance_of_run(led), 1e-12);
  EXPECT_NEAR(position_of(led, 5)[1] - led.mesh().nodes[5][1], 6 * led.time(), 1e-12);
  EXPECT_NEAR(position_of(led, 5)[0], led.mesh().nodes[5][0], 1e-15) << "b is held across its motion";
}

TEST(Equation, ThatCannotHoldStopsTheRun) {
  Scene scene = two_cubes(1e-4);
  scene.equation_terms = of_pair(1, -1);
  PrescribedVelocity a, b;
  a.nodes.body = "a";
  b.nodes.body = "b";
  a.velocity = b.velocity = {1, 2, 3};
  scene.prescribed_velocities = {a, b};
  Solver<double> agreed(scene);
  run(agreed);
  scene.prescribed_velocities[1].velocity = {1, 2, 3.01};
  Solver<double> opposed(scene);
  EXPECT_THAT(error_of<RunError>([&] { run(opposed); }), HasSubstr("the equation cannot hold"));
}

/// Edges and corners of a cell have equations that follow from others, and move by what has cancelled at first.
TEST(Equation, OfAllFacesOfACellThatIsPushedInItsMiddle) {
  Scene scene = scene_of({block("a", {4, 4, 4}, 0.1, {0, 0, 0})}, 4e-4, false);
  for (std::size_t side = 0; side < 3; ++side) {
    const Point far{side == 0 ? 0.4 : 0, side == 1 ? 0.4 : 0, side == 2 ? 0.4 : 0};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::string name = fmt::format("{} {}", side, k);
      scene.equation_terms.push_back(term(name, axes[k], 1, "a", Plane{far, axes[side]}));
      scene.equation_terms.push_back(term(name, axes[k], -1, "a", Plane{{0, 0, 0}, axes[side]}));
    }
  }
  NodalLoad push;
  push.nodes.nearest = Point{0.2, 0.2, 0.2};
  push.force = {1e3, 0, 0};
  scene.loads = {push};
  Solver<double> solver(scene);
  EXPECT_LT(worst_balance_of_run(solver), 1e-10);
  const double mass = 0.4 * 0.4 * 0.4 * 7850;
  EXPECT_NEAR(velocity_of(solver, 0)[0] / (1e3 * solver.time() / mass), 1, 0.5) << "it goes as one";
}

/// Those that say what others say, or nothing, change nothing.
TEST(Equation, MayBeThereTwice) {
  Scene scene = two_cubes(5e-4);
  scene.bodies[0].velocity = scene.bodies[1].velocity = {1, 2, 3};
  scene.equation_terms = of_pair(1, -1);
  NodalLoad pull;
  pull.nodes.body = "a";
  pull.nodes.nearest = Point{0, 0, 0};
  pull.force = {3e4, 0, 5e4};
  scene.loads = {pull};
  Solver<double> once(scene);
  run(once);
  for (EquationTerm again : of_pair(-2, 2)) {
    again.name += "_again";
    scene.equation_terms.push_back(again);
  }
  Solver<double> twice(scene);
  run(twice);
  for (std::size_t n = 0; n < 16; ++n) EXPECT_LT(norm(minus(position_of(twice, n), position_of(once, n))), 1e-15);
}

/// One node that all nodes of a body follow: equations with a node in common are solved together.
TEST(Equation, OfOneNodeWithManyMovesThemAlike) {
  Scene scene = scene_of({block("a", {3, 3, 3}, 0.1, {0, 0, 0}), block("b", {1, 1, 1}, 0.1, {1, 0, 0})}, 3e-4, false);
  EquationTerm top = term("lid", axes[2], 1, "a", Plane{{0, 0, 0.3}, {0, 0, 1}}), one = top;
  one.factor = -1;
  one.nodes = {};
  one.nodes.nearest = Point{1, 0, 0};
  scene.equation_terms = {top, one};
  NodalLoad pull;
  pull.nodes = one.nodes;
  pull.force = {0, 0, 4e4};
  scene.loads = {pull};
  Solver<double> solver(scene);
  EXPECT_LT(worst_balance_of_run(solver), 1e-7) << "as elements keep it";
  double lowest = 1, highest = 0;
  for (std::size_t n = 0; n < 64; ++n) {
    if (solver.mesh().nodes[n][2] < 0.25) continue;
    lowest = std::min(lowest, position_of(solver, n)[2]);
    highest = std::max(highest, position_of(solver, n)[2]);
  }
  EXPECT_LT(highest - lowest, 1e-15);
  EXPECT_GT(lowest, 0.3 + 1e-6);
  EXPECT_NEAR(solver.momentum()[2], 4e4 * solver.time(), 1e-10 * 4e4 * solver.time()) << "it has no part outside";
}

/// As a plastic impact.
TEST(Equation, JoinsWhatBeginsToMoveOtherwise) {
  Scene scene = two_cubes(2e-4);
  scene.bodies[0].velocity = {2, 0, 0};
  scene.equation_terms = of_pair(1, -1);
  Solver<double> solver(scene);
  solver.step();
  for (const std::size_t n : {0, 15}) EXPECT_NEAR(velocity_of(solver, n)[0], 1, 1e-14);
  EXPECT_LT(worst_balance_of_run(solver), 1e-13);
  EXPECT_NEAR(solver.energies().external, -0.25 * cube_mass * 4, 1e-12);
  EXPECT_NEAR(solver.momentum()[0], 2 * cube_mass, 1e-12);
}

/// c follows a node of the face on which a is tied.
TEST(Equation, OfCornersOfFacesThatOthersAreTiedTo) {
  Scene scene = glued(3, 2, 3e-4);
  scene.bodies.push_back(block("c", {1, 1, 1}, 0.1, {2, 0, 0}));
  EquationTerm corner = term("follow", axes[0], 1, "low"), c = term("follow", axes[0], -1, "c");
  corner.nodes.nearest = Point{0, 0, 0.6};
  c.nodes.nearest = Point{2, 0, 0};
  scene.equation_terms = {corner, c};
  scene.bodies[1].velocity = scene.bodies[0].velocity = scene.bodies[2].velocity = {3, 0, 0};
  NodalLoad pull;
  pull.nodes = c.nodes;
  pull.force = {5e4, 0, 0};
  scene.loads = {pull};
  Solver<double> solver(scene);
  EXPECT_LT(worst_balance_of_run(solver), 1e-9);
  EXPECT_GT(solver.tied().nodes().active(), 0);
  const auto way = [&](const Point& place) {
    for (std::size_t n = 0; n < solver.mesh().nodes.size(); ++n) {
      if (norm(minus(solver.mesh().nodes[n], place)) < 1e-9) return position_of(solver, n)[0] - place[0];
    }
    return 0.0;
  };
  EXPECT_NEAR(way({0, 0, 0.6}), way({2, 0, 0}), 1e-14);
  EXPECT_GT(way({0, 0, 0.6}), 3 * solver.time() * 1.003);
  scene.equation_terms[0].nodes = {};
  scene.equation_terms[0].nodes.body = "high";
  scene.equation_terms[0].nodes.plane = Plane{{0, 0, 0.6}, {0, 0, 1}};
  EXPECT_THAT(error_of([&] { Solver<double> refused(scene); }), HasSubstr("is tied to a face"));
}

TEST(Equation, OfWhatMovesOtherwiseIsRefused) {
  const Scene good = [] {
    Scene scene = two_cubes(1e-4);
    scene.equation_terms = of_pair(1, -1);
    return scene;
  }();
  EXPECT_EQ(error_of([&] { Solver<double> taken(good); }), no_error);
  const auto error = [&](const auto& change) {
    Scene scene = good;
    change(scene);
    return error_of([&] { Solver<double> refused(checked_scene(scene)); });
  };
  EXPECT_THAT(error([](Scene& s) { s.equation_terms[1].factor = 0; }),
              AllOf(HasSubstr("equation.1"), HasSubstr("factor")));
  EXPECT_THAT(error([](Scene& s) {
                s.equation_terms[1].nodes.plane = Plane{{1, 0, 0}, {1, 0, 0}};
              }),
              HasSubstr("expected 8 nodes"));
  EXPECT_THAT(error([](Scene& s) {
                RigidBody rigid;
                rigid.bodies = {"b"};
                s.rigid_bodies = {rigid};
              }),
              HasSubstr("is of a rigid body"));
}

TEST(Equation, HasTheSameBitsOnThreadsDevicesAndAfterARestart) {
  Scene scene =
      scene_of({block("a", {6, 4, 4}, 0.1, {0, 0, 0}, {0, 0, 30}), block("b", {6, 4, 4}, 0.1, {1, 0, 0})}, 3e-4, false);
  scene.equation_terms = of_pair(1, -2, Plane{{0, 0, 0.4}, {0, 0, 1}});
  FixedConstraint held;
  held.nodes.body = "b";
  held.nodes.plane = Plane{{0, 0, 0.4}, {0, 0, 1}};
  held.directions = {{1, 0, 0}};
  held.when = {1e-4, 2e-4};
  scene.fixed_constraints = {held};
  scene.rigid_walls = {{"floor", {{0, 0, 0}, {0, 0, 1}}, "", "here"}};  // whose nodes have no equation
  const std::uint64_t alone = hash_of<double>(scene);
  EXPECT_EQ(hash_of<double>(scene, 3), alone);
  Scene on_device = scene;
  on_device.device = Device::mock;
  EXPECT_EQ(hash_of<double>(on_device), alone);
  for (const int steps : {0, 5, 12}) {
    Solver<double> half(scene), rest(scene);
    while (half.steps() < steps) half.step();
    EXPECT_EQ(load(rest, saved(half)), 0U);
    run(rest);
    EXPECT_EQ(state_hash(std::as_const(rest).model()), alone) << steps;
  }
  Solver<float> single(scene);
  run(single);
  for (std::size_t n = 0; n < 35; ++n) {
    const std::size_t a = 4 * 35 + n, b = a + 5 * 35;
    EXPECT_NEAR(velocity_of(single, a)[2], 2 * velocity_of(single, b)[2], 1e-5) << "u_a = 2 u_b";
  }
}

}  // namespace
}  // namespace pinball::test::equations_test
