#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>
#include <numeric>

#include <solver/scene_rules.hpp>
#include <solver/summary.hpp>
#include <tests/support/run_hash.hpp>
#include <tests/support/saved_state.hpp>

/// [[point_mass]]: mass at nodes beside that of their elements.
namespace pinball::point_mass_test {
namespace {

using namespace test;
using testing::AllOf;
using testing::HasSubstr;

constexpr double cube_mass = 7850 * 0.2 * 0.2 * 0.2;

PointMass nearest_to(const Point& place, double mass) {
  PointMass point;
  point.nodes.nearest = place;
  point.mass = mass;
  return point;
}

/// Eight elements with a mass at one corner.
Scene weighted_cube(double mass, double end = 2e-3) {
  Scene scene = scene_of({block("cube", {2, 2, 2}, 0.1, {0, 0, 0})}, end, false);
  scene.point_masses = {nearest_to({0.2, 0.2, 0.2}, mass)};
  return scene;
}

double mass_of(const Solver<double>& solver) {
  const std::vector<double>& masses = solver.model().node_mass;
  return std::accumulate(masses.begin(), masses.end(), 0.0);
}

RunSummary summary_of(const Solver<double>& solver) {
  RunSummary summary;
  fill_summary(solver, summary);
  return summary;
}

TEST(PointMass, IsBesideThatOfTheElementsOfItsNode) {
  const Solver<double> solver(weighted_cube(30));
  const Model<double>& model = solver.model();
  for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n) {
    const std::size_t node = model.node_of_scene_node[n];
    const bool heavy = norm(minus(model.mesh.nodes[n], {0.2, 0.2, 0.2})) < 1e-9;
    EXPECT_EQ(model.point_mass[node], heavy ? 30 : 0);
    if (heavy) {
      EXPECT_NEAR(model.node_mass[node], 30 + cube_mass / 64, 1e-12);
    }
    EXPECT_EQ(model.nodes.inverse_mass[node], 1 / model.node_mass[node]);
  }
  EXPECT_NEAR(mass_of(solver), cube_mass + 30, 1e-12);
  EXPECT_EQ(summary_of(solver).point_mass, 30);
  EXPECT_NEAR(summary_of(solver).bodies[0].mass_initial, cube_mass, 1e-12) << "of its elements";
}

TEST(PointMass, OfSeveralNodesIsSharedInProportionToTheirElementsOrThatOfEach) {
  PointMass face;
  face.nodes.plane = Plane{{0, 0, 0}, {0, 0, 1}};
  face.mass = 16;
  Scene scene = weighted_cube(1);
  scene.point_masses = {face, nearest_to({0, 0, 0}, 3), nearest_to({0.1, 0.1, 0}, 5), nearest_to({0, 0, 0}, 2)};
  const auto mass_at = [&](const Point& place) {
    const Model<double> model = build_model<double>(scene);
    for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n) {
      if (norm(minus(model.mesh.nodes[n], place)) < 1e-9) return model.point_mass[model.node_of_scene_node[n]];
    }
    return -1.0;
  };
  EXPECT_NEAR(mass_at({0, 0, 0}), 16.0 / 16 + 3 + 2, 1e-13) << "masses at one node add up";
  EXPECT_NEAR(mass_at({0.1, 0.1, 0}), 16.0 / 4 + 5, 1e-13) << "four elements of sixteen eighths";
  EXPECT_NEAR(mass_at({0.1, 0, 0}), 16.0 / 8, 1e-13);
  scene.point_masses[0].each = true;
  EXPECT_EQ(mass_at({0.1, 0, 0}), 16);
  EXPECT_EQ(mass_at({0, 0, 0}), 16 + 3 + 2);
}

/// Nothing deforms where all falls alike, so that velocities are those without the mass.
TEST(PointMass, FallsAsAllElse) {
  for (const std::vector<std::string>& bodies : {std::vector<std::string>{}, {"cube"}}) {
    Scene scene = weighted_cube(30);
    scene.output.body_energies = true;
    scene.gravities = {{{0, 3, -10}, {}, bodies}};
    scene.bodies[0].velocity = {1, 0, 2};
    Solver<double> solver(scene);
    run(solver);
    scene.point_masses.clear();
    Solver<double> without(scene);
    run(without);
    for (std::size_t n = 0; n < solver.mesh().nodes.size(); ++n) {
      for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(velocity_of(solver, n)[k], velocity_of(without, n)[k], 1e-9) << n;
    }
    const double ratio = (cube_mass + 30) / cube_mass;
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(solver.momentum()[k], ratio * without.momentum()[k], 1e-9 * mass_of(solver));
    EXPECT_NEAR(solver.energies().external / without.energies().external, ratio, 1e-9);
    const std::vector<BodyShare> shares = solver.body_shares();
    EXPECT_NEAR(shares.at(0).mass, cube_mass + 30, 1e-11);
    EXPECT_NEAR(shares[0].kinetic / solver.energies().kinetic, 1, 1e-12);
  }
}

TEST(PointMass, OfANodeThatIsStruckCarriesItsMomentumIntoTheCube) {
  Scene scene = weighted_cube(30);
  InitialVelocity struck;
  struck.nodes.nearest = Point{0.2, 0.2, 0.2};
  struck.velocity = {0, 0, -2};
  scene.initial_velocities = {struck};
  Solver<double> solver(scene);
  const double mass = 30 + cube_mass / 64;
  EXPECT_NEAR(solver.momentum()[2], -2 * mass, 1e-12 * mass);
  solver.step();
  EXPECT_NEAR(solver.initial_energy(), 0.5 * mass * 4, 1e-9);
  const double worst = worst_balance_of_run(solver);
  EXPECT_LT(worst, 1e-5);
  EXPECT_NEAR(solver.momentum()[0], 0, 1e-11 * mass);
  EXPECT_NEAR(solver.momentum()[2], -2 * mass, 1e-11 * mass);
}

/// A bar of density rho, held at one end, with the mass M at the other: w L/c tan(w L/c) = rho A L / M.
TEST(PointMass, AtTheEndOfABarGivesItsFrequency) {
  constexpr int count = 20;
  const double length = 1, h = length / count, bar = 7850 * h * h * length, c = std::sqrt(2.1e11 / 7850);
  for (const double ratio : {0.1, 1.0}) {  // of the bar to the mass
    double low = 0, high = std::numbers::pi / 2;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      (middle * std::tan(middle) < ratio ? low : high) = middle;
    }
    const double half_period = std::numbers::pi * length / (c * low);
    Scene scene = scene_of({block("bar", {1, 1, count}, h, {0, 0, 0})}, 1.5 * half_period, false);
    scene.materials = {elastic_material("steel", 0.0)};
    FixedConstraint held;
    held.nodes.plane = Plane{{0, 0, 0}, {0, 0, 1}};
    held.directions = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    scene.fixed_constraints = {held};
    PointMass end;
    end.nodes.plane = Plane{{0, 0, length}, {0, 0, 1}};
    end.mass = bar / ratio;
    scene.point_masses = {end};
    // The mode of this frequency, sin(w z / c), and no other.
    for (int layer = 1; layer <= count; ++layer) {
      InitialVelocity of_layer;
      of_layer.nodes.plane = Plane{{0, 0, layer * h}, {0, 0, 1}};
      of_layer.velocity = {0, 0, 0.01 * std::sin(low * layer / count)};
      scene.initial_velocities.push_back(of_layer);
    }
    Solver<double> solver(scene);
    const std::size_t tip = solver.mesh().nodes.size() - 1;
    double before = 0, at = 0, returned = 0;
    while (returned == 0 && !solver.at_end()) {
      solver.step();
      const double now = position_of(solver, tip)[2] - length;
      if (before > 0 && now <= 0) returned = at + (solver.time() - at) * before / (before - now);
      before = now;
      at = solver.time();
    }
    EXPECT_NEAR(returned / half_period, 1, 1e-3) << ratio;
  }
}

TEST(PointMass, MakesNoStepSmaller) {
  const auto steps_of = [](Scene scene, bool has_some) {
    if (!has_some) scene.point_masses.clear();
    Solver<double> solver(scene);
    solver.step();
    return solver.clock().dt_min();
  };
  for (const double mass : {1e-6, 30.0, 1e6})
    EXPECT_EQ(steps_of(weighted_cube(mass), true), steps_of(weighted_cube(mass), false)) << mass;
}

/// A cube with masses falls onto another one by each kind of contact: momentum stays.
Scene impact(ContactMethod method, Enforcement enforcement) {
  Scene scene = scene_of(
      {block("low", {3, 3, 2}, 0.1, {0, 0, 0}), block("high", {2, 2, 2}, 0.1, {0.05, 0.05, 0.2001}, {0, 0, -20})},
      1e-4);
  scene.contact.method = method;
  scene.contact.enforcement = enforcement;
  if (enforcement == Enforcement::lagrange) scene.contact.gap = ContactGap::face;
  PointMass under;
  under.nodes.body = "high";
  under.nodes.plane = Plane{{0, 0, 0.2001}, {0, 0, 1}};
  under.mass = 40;
  scene.point_masses = {under, nearest_to({0.3, 0.3, 0.2}, 25)};
  return scene;
}

TEST(PointMass, KeepsMomentumInContact) {
  for (const auto& [method, enforcement] : {std::pair{ContactMethod::pinball, Enforcement::lagrange},
                                            {ContactMethod::pinball, Enforcement::penalty},
                                            {ContactMethod::slideline, Enforcement::penalty}}) {
    Solver<double> solver(impact(method, enforcement));
    const Point before = solver.momentum();
    EXPECT_NEAR(before[2], -20 * (cube_mass + 40), 1e-9);
    run(solver);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(solver.momentum()[k], before[k], 1e-9 * std::abs(before[2]));
    EXPECT_LT(history_row(solver).bodies[0].velocity[2], -0.1) << "they have met";
  }
}

TEST(PointMass, IsInTheMassAndTheCentreOfARigidBody) {
  Scene scene = weighted_cube(30);
  RigidBody rigid;
  rigid.name = "r";
  rigid.bodies = {"cube"};
  scene.rigid_bodies = {rigid};
  const Solver<double> solver(scene);
  const RigidBodyResult found = solver.rigid().results().at(0);
  EXPECT_NEAR(found.mass, cube_mass + 30, 1e-12);
  EXPECT_NEAR(found.centre[0], (0.1 * cube_mass + 0.2 * 30) / (cube_mass + 30), 1e-14);
  for (const auto& give : {+[](RigidBody& r) { r.mass = 100; },
                           +[](RigidBody& r) {
                             r.centre = Point{0.1, 0.1, 0.1};
                           },
                           +[](RigidBody& r) {
                             r.inertia = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
                           }}) {
    Scene given = scene;
    give(given.rigid_bodies[0]);
    EXPECT_THAT(input_error_of(given), AllOf(HasSubstr(": nodes of the rigid body r, whose mass"),
                                             HasSubstr("put the mass into what is given")));
  }
}

TEST(PointMass, OfNoMassOrNoNodeIsRefused) {
  Scene scene = weighted_cube(-1);
  EXPECT_THAT(error_of([&] { checked_scene(scene); }), AllOf(HasSubstr("point_mass.0"), HasSubstr("mass")));
  scene = weighted_cube(0);
  EXPECT_THAT(error_of([&] { checked_scene(scene); }), HasSubstr("a number > 0"));
  scene = weighted_cube(1);
  scene.point_masses[0].nodes = {};
  EXPECT_THAT(error_of([&] { checked_scene(scene); }), HasSubstr("point_mass.0"));
}

TEST(PointMass, HasTheSameBitsOnThreadsDevicesAndAfterARestart) {
  for (const Scene& scene : {impact(ContactMethod::pinball, Enforcement::lagrange), weighted_cube(30, 2e-4)}) {
    const std::uint64_t alone = hash_of<double>(scene);
    EXPECT_EQ(hash_of<double>(scene, 3), alone);
    Scene on_device = scene;
    on_device.device = Device::mock;
    EXPECT_EQ(hash_of<double>(on_device), alone);
    Solver<double> half(scene), rest(scene);
    for (int i = 0; i < 5; ++i) half.step();
    EXPECT_EQ(load(rest, saved(half)), 0U);
    run(rest);
    EXPECT_EQ(state_hash(std::as_const(rest).model()), alone);
    Scene heavier = scene;
    heavier.point_masses[0].mass *= 2;
    EXPECT_NE(fingerprint(build_model<double>(heavier)), fingerprint(build_model<double>(scene)));
  }
}

}  // namespace
}  // namespace pinball::point_mass_test
