#include <gtest/gtest.h>

#include <cmath>

#include <tests/support/saved_state.hpp>
#include <tests/support/tied_case.hpp>

/// Velocities of tied nodes that a host changes.
namespace pinball::test::tied_velocities_test {
namespace {

/// Velocity along x of all nodes of a body [length/time].
void push(Solver<double>& solver, std::int32_t body, double speed) {
  Array<double>& velocity = solver.change_velocities();
  const ModelMesh& mesh = solver.mesh();
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    if (mesh.body_of_node[n] == body)
      velocity[4 * static_cast<std::size_t>(solver.model().node_of_scene_node[n])] += speed;
  }
}

/// Tied nodes have no mass of their own while they are tied: what a host gave them was lost.
TEST(ChangedVelocitiesOfTiedNodes, GiveTheirMomentumToTheirFaces) {
  const Scene scene = glued(3, 2, 2e-4);
  for (const int steps : {0, 5}) {
    Solver<double> solver(scene);
    for (int step = 0; step < steps; ++step) solver.step();
    push(solver, 1, 10);
    solver.step();
    const double mass = 0.6 * 0.6 * 0.6 * scene.materials[0].density;
    EXPECT_NEAR(solver.momentum()[0], 10 * mass, 1e-10 * mass) << steps;
    run(solver);
    EXPECT_NEAR(solver.momentum()[0], 10 * mass, 1e-9 * mass) << steps;
    EXPECT_LT(std::abs(solver.balance_error()), 1e-3) << steps;
  }
}

TEST(ChangedVelocitiesOfTiedNodes, ThatAreChangedByNothingStayAsTheyWere) {
  const Scene scene = glued(3, 2, 2e-4);
  Solver<double> solver(scene);
  push(solver, 1, 10);
  for (int step = 0; step < 5; ++step) solver.step();
  push(solver, 0, 0);
  const Point momentum = solver.momentum();
  Solver<double> restarted(scene);
  EXPECT_EQ(load(restarted, saved(solver)), 0U) << "before the next step";
  solver.step();
  restarted.step();
  EXPECT_NEAR(solver.momentum()[0], momentum[0], 1e-9 * momentum[0]);
  const Array<double>&one = solver.model().nodes.velocity, &other = restarted.model().nodes.velocity;
  for (std::size_t i = 0; i < one.size(); ++i) ASSERT_EQ(one[i], other[i]);
}

}  // namespace
}  // namespace pinball::test::tied_velocities_test
