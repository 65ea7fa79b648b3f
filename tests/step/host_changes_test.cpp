#include <gtest/gtest.h>

#include <tests/support/saved_state.hpp>
#include <tests/support/solver_case.hpp>

/// What a host does to a solver between two steps: changes velocities, saves the state, looks at the model.
namespace pinball::host_changes_test {
namespace {

using namespace test;

/// A small block flying at another one, far below the speed at which bodies could jump over each other's surfaces.
Scene slow_impact() {
  Scene scene = scene_of({block("a", {3, 3, 3}, 0.1, {0, 0, 0}), block("b", {3, 3, 3}, 0.1, {0.45, 0, 0})}, 2e-4);
  scene.bodies[0].velocity = {10, 0, 0};
  scene.contact.method = ContactMethod::pinball;
  return scene;
}

/// Throws the first body at the second, faster than elements can tell: the speed of impact sets the step.
void throw_first_body(Solver<double>& solver) {
  Array<double>& velocity = solver.change_velocities();
  const ModelMesh& mesh = solver.mesh();
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    if (mesh.body_of_node[n] == 0) velocity[4 * static_cast<std::size_t>(solver.model().node_of_scene_node[n])] = 2e5;
  }
}

void expect_same_run(Solver<double>& a, Solver<double>& b, int steps) {
  for (int step = 0; step < steps; ++step) {
    a.step();
    b.step();
    ASSERT_EQ(a.dt(), b.dt()) << "step " << step;
    ASSERT_EQ(a.energies().external, b.energies().external) << "step " << step;
  }
  EXPECT_EQ(a.balance_error(), b.balance_error());
  for (std::size_t n = 0; n < a.model().nodes.position.size(); ++n) {
    ASSERT_EQ(a.model().nodes.position[n], b.model().nodes.position[n]);
    ASSERT_EQ(a.model().nodes.velocity[n], b.model().nodes.velocity[n]);
  }
}

TEST(ChangedVelocities, LimitTheStepAlsoAfterARestart) {
  const Scene scene = slow_impact();
  Solver<double> whole(scene);
  for (int step = 0; step < 3; ++step) whole.step();
  const double before = whole.dt();
  throw_first_body(whole);
  whole.step();
  ASSERT_LT(whole.dt(), 0.5 * before);
  Solver<double> restarted(scene);
  EXPECT_EQ(load(restarted, saved(whole)), 0U);
  expect_same_run(whole, restarted, 3);
}

TEST(ChangedVelocities, AreTakenFromAStateThatIsSavedBeforeTheNextStep) {
  const Scene scene = slow_impact();
  Solver<double> whole(scene);
  for (int step = 0; step < 3; ++step) whole.step();
  throw_first_body(whole);
  Solver<double> restarted(scene);
  EXPECT_EQ(load(restarted, saved(whole)), 0U);
  expect_same_run(whole, restarted, 3);
  EXPECT_GT(whole.energies().external, 0);  // what the host's change has brought
}

/// The momentum that a run begins with is the one that the host has given it, also for who goes on from there.
TEST(ChangedVelocities, BeforeTheFirstStepAreWhatTheRunBeginsWith) {
  const Scene scene = slow_impact();
  Solver<double> whole(scene);
  throw_first_body(whole);
  const Point thrown = whole.momentum();
  EXPECT_NEAR(thrown[0], 7850 * 0.027 * 2e5, 1e-9 * thrown[0]);
  whole.step();
  EXPECT_EQ(whole.initial_momentum(), thrown);
  Solver<double> restarted(scene);
  EXPECT_EQ(load(restarted, saved(whole)), 0U);
  EXPECT_EQ(restarted.initial_momentum(), thrown);
}

/// The number of element steps left out because their tiles rest.
template <class Look>
std::int64_t resting_steps(const Look& look) {
  Scene scene = scene_of({block("bar", {64, 2, 2}, 0.1, {0, 0, 0})}, 1e-2, false);
  InitialVelocity struck;
  struck.nodes.plane = Plane{{0, 0, 0}, {1, 0, 0}};
  struck.velocity = {10, 0, 0};
  scene.initial_velocities = {struck};
  Solver<double> solver(scene);
  for (int step = 0; step < 20; ++step) {
    solver.step();
    look(solver);
  }
  return solver.counts().work().resting_element_steps;
}

TEST(LookingAtTheModel, CostsNothing) {
  const std::int64_t unseen = resting_steps([](Solver<double>&) {});
  EXPECT_GT(unseen, 0);
  double sum = 0;
  EXPECT_EQ(resting_steps([&](Solver<double>& solver) { sum += solver.model().nodes.velocity[0]; }), unseen);
  EXPECT_GT(sum, 0);
  EXPECT_EQ(resting_steps([](Solver<double>& solver) { solver.change_model(); }), 0);  // asks to work all
}

}  // namespace
}  // namespace pinball::host_changes_test
