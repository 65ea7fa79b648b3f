#include <gtest/gtest.h>

#include <numeric>

#include <tests/support/saved_state.hpp>
#include <tests/support/solver_case.hpp>

/// Energies, momentum and mass of each body (output.body_energies).
namespace pinball::body_energies_test {
namespace {

using namespace test;

/// Sums over the bodies of what each of them has are the totals of the run.
template <class S>
void expect_totals(const Solver<S>& solver, double tolerance = 1e-12) {
  BodyShare sum;
  for (const BodyShare& body : solver.body_shares()) {
    sum.kinetic += body.kinetic;
    sum.internal += body.internal;
    sum.hourglass += body.hourglass;
    sum.bulk_viscosity += body.bulk_viscosity;
    sum.mass += body.mass;
    for (std::size_t k = 0; k < 3; ++k) sum.momentum[k] += body.momentum[k];
  }
  const Energies& all = solver.energies();
  const double energy = tolerance * (all.kinetic + std::abs(all.internal));
  EXPECT_NEAR(sum.kinetic, all.kinetic, energy);
  EXPECT_NEAR(sum.internal, all.internal, energy);
  EXPECT_NEAR(sum.hourglass, all.hourglass, energy);
  EXPECT_NEAR(sum.bulk_viscosity, all.bulk_viscosity, energy);
  const std::vector<double>& masses = solver.model().node_mass;
  EXPECT_NEAR(sum.mass / std::accumulate(masses.begin(), masses.end(), 0.0), 1, 1e-12);
  const Point total = solver.momentum();
  const double size = std::sqrt(2 * sum.mass * all.kinetic);  // that of the energy, if all moved one way
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(sum.momentum[k], total[k], tolerance * size) << k;
}

template <class S>
void expect_totals_of_run(Scene scene, double tolerance = 1e-12) {
  scene.output.body_energies = true;
  Solver<S> solver(scene);
  while (!solver.at_end()) {
    solver.step();
    if (solver.steps() % 20 < 3) expect_totals(solver, tolerance);
  }
  solver.finish();
  expect_totals(solver, tolerance);
  for (const BodyShare& body : solver.body_shares()) EXPECT_GT(body.internal, 0);
}

TEST(BodyEnergies, OfBodiesOfOneMaterialAddUp) {
  Scene scene = pressed_blocks(3e-4);
  scene.element.bulk_viscosity = true;
  expect_totals_of_run<double>(scene);
  expect_totals_of_run<float>(scene, 1e-5);
}

TEST(BodyEnergies, AddUpWhereElementsErode) {
  Scene scene = read_scene(find_scene("rod_plate"));
  scene.time.end = 20e-6;
  expect_totals_of_run<double>(scene);
}

TEST(BodyEnergies, AddUpWhereElementsHaveStepsOfTheirOwn) {
  Scene scene =
      scene_of({block("coarse", {3, 3, 3}, 0.1, {0, 0, 0}), block("fine", {8, 8, 8}, 0.03, {0, 0, 1})}, 2e-4, false);
  for (Body& body : scene.bodies) body.velocity_gradient[0] = {50, 20, 0};
  scene.time.subcycling = true;
  expect_totals_of_run<double>(scene);
}

TEST(BodyEnergies, AddUpWhereNodesAreTied) {
  Scene scene =
      scene_of({block("low", {2, 2, 2}, 0.1, {0, 0, 0}), block("high", {3, 3, 2}, 0.06, {0.01, 0.01, 0.2}, {2, 0, -7})},
               2e-4, false);
  TiedContact tied;
  tied.name = "glue";
  tied.first.bodies = {"high"};
  tied.second.bodies = {"low"};
  tied.tolerance = 0.01;
  scene.tied_contacts = {tied};
  expect_totals_of_run<double>(scene);
}

/// Its own mass times its velocity at first, and then what its partner has given it; the partner has lost that.
TEST(BodyEnergies, MomentumOfABodyIsWhatImpactGivesIt) {
  Scene scene = scene_of(
      {block("low", {3, 3, 3}, 0.1, {0, 0, 0}), block("high", {2, 2, 2}, 0.1, {0.05, 0, 0.3}, {1, 0, -9})}, 2e-4);
  scene.contact.enforcement = Enforcement::lagrange;
  scene.contact.gap = ContactGap::face;
  ContactPair pair;
  pair.name = "pair";
  pair.first.bodies = {"high"};
  pair.second.bodies = {"low"};
  scene.contact_pairs = {pair};
  scene.output.body_energies = true;
  Solver<double> solver(scene);
  const double mass = 7850 * 0.008, size = 9 * mass;
  while (!solver.at_end()) {
    solver.step();
    const std::vector<BodyShare> bodies = solver.body_shares();
    const Point impulse = solver.contact_pairs()[0].impulse;
    EXPECT_NEAR(bodies[1].mass, mass, 1e-12 * mass);
    EXPECT_NEAR(bodies[1].momentum[0], mass + impulse[0], 1e-12 * size);
    EXPECT_NEAR(bodies[1].momentum[2], impulse[2] - size, 1e-12 * size);
    EXPECT_NEAR(bodies[0].momentum[2], -impulse[2], 1e-12 * size);
  }
  EXPECT_GT(solver.contact_pairs()[0].impulse[2], 0.5 * size);
}

/// Elements of one body only: tiles of bodies of one material are apart where they are asked for.
TEST(BodyEnergies, OfABodyAtRestAreNone) {
  Scene scene = scene_of(
      {block("rest", {3, 3, 3}, 0.1, {0, 0, 0}), block("moved", {2, 2, 2}, 0.1, {0, 0, 1}, {0, 0, 4})}, 1e-4, false);
  scene.bodies[1].velocity_gradient[0] = {50, 0, 0};
  scene.output.body_energies = true;
  Solver<double> solver(scene);
  run(solver);
  const std::vector<BodyShare> bodies = solver.body_shares();
  EXPECT_EQ(bodies[0].kinetic, 0);
  EXPECT_EQ(bodies[0].internal, 0);
  EXPECT_EQ(bodies[0].momentum, Point{});
  EXPECT_GT(bodies[1].internal, 0);
  EXPECT_NEAR(bodies[1].momentum[2], 4 * bodies[1].mass, 1e-9 * bodies[1].mass);
}

std::vector<std::vector<double>> rows_of(const Scene& scene, int threads) {
  DefaultExecutionSpace::set_concurrency(threads);
  Solver<double> solver(scene);
  std::vector<std::vector<double>> rows;
  while (!solver.at_end()) {
    solver.step();
    rows.push_back(history_row(solver).more);
  }
  DefaultExecutionSpace::set_concurrency(1);
  return rows;
}

TEST(BodyEnergies, AreTheSameBitsForAnyNumberOfThreads) {
  Scene scene = pressed_blocks(1e-4);
  scene.output.body_energies = true;
  EXPECT_EQ(rows_of(scene, 1), rows_of(scene, 3));
}

TEST(BodyEnergies, ColumnsComeLastAndNoneWithoutTheKey) {
  Scene scene = pressed_blocks(1e-5);
  const std::vector<std::string> before = more_columns(Solver<double>(scene));
  scene.output.body_energies = true;
  const Solver<double> solver(scene);
  const std::vector<std::string> after = more_columns(solver);
  ASSERT_EQ(after.size(), before.size() + 16);
  EXPECT_TRUE(std::equal(before.begin(), before.end(), after.begin()));
  EXPECT_EQ(after[before.size()], "a_kinetic");
  EXPECT_EQ(after.back(), "b_bulk_viscosity");
  EXPECT_EQ(history_row(solver).more.size(), after.size());
}

TEST(BodyEnergies, OfBodiesOfTheirOwnMaterialsChangeNothing) {
  Scene scene = read_scene(find_scene("rod_plate"));
  scene.time.end = 5e-6;
  Solver<double> without(scene);
  scene.output.body_energies = true;
  Solver<double> with(scene);
  run(without);
  run(with);
  EXPECT_EQ(state_hash(with.model()), state_hash(without.model()));
}

TEST(BodyEnergies, GoOnFromASavedState) {
  Scene scene = pressed_blocks(2e-4);
  scene.output.body_energies = true;
  Solver<double> whole(scene), rest(scene);
  while (whole.time() < 1e-4) whole.step();
  const StateBytes state = test::saved(whole);
  test::load(rest, state);
  for (int step = 0; step < 3; ++step) {
    EXPECT_EQ(history_row(whole).more, history_row(rest).more) << step;
    whole.step();
    rest.step();
  }
}

}  // namespace
}  // namespace pinball::body_energies_test
