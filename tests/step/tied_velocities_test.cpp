#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <tests/support/saved_state.hpp>
#include <tests/support/tied_case.hpp>

/// Velocities of tied nodes: those that they begin with, and those that a host gives them.
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

/// Spin and stretch about a point: a motion that obeys ties of flat faces with straight edges.
Point compatible(const Point& x) {
  return {3 - 20 * x[1] + 5 * x[0] + 2 * x[2], -7 + 20 * x[0] + 4 * x[2], 20 + 3 * x[0] - 6 * x[1] + x[2]};
}

double largest_change(const Solver<double>& solver) {
  double largest = 0;
  const ModelMesh& mesh = solver.mesh();
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    const double* const v = record(solver.model().nodes.velocity.data(), solver.model().node_of_scene_node[n]);
    for (std::size_t c = 0; c < 3; ++c) largest = std::max(largest, std::abs(v[c] - compatible(mesh.nodes[n])[c]));
  }
  return largest;
}

/// Steps so short that nothing but ties changes velocities.
Scene in_short_steps(int fine, int coarse, double start) {
  Scene scene = glued(fine, coarse, 1e-3);
  scene.tied_contacts[0].start = start;
  scene.time.cfl = 1e-3;
  return scene;
}

/// All nodes tied at a time shared the momentum of their faces' corners, whatever the motion: what spun was braked.
TEST(VelocitiesOfTiedBodies, ThatObeyTheTieStayAsTheyAre) {
  for (const int coarse : {1, 2, 3}) {
    for (const double start : {0.0, 1e-9}) {
      Scene scene = in_short_steps(5, coarse, start);
      for (std::size_t b = 0; b < 2; ++b) {
        Body& body = scene.bodies[b];
        body.velocity_gradient = {{{5, -20, 2}, {20, 0, 4}, {3, -6, 1}}};
        body.velocity = compatible({0.3, 0.3, b == 0 ? 0.3 : 0.9});
      }
      Solver<double> solver(scene);
      for (int step = 0; step < 4; ++step) solver.step();
      EXPECT_EQ(solver.tied().nodes().active(), 36);
      EXPECT_LT(largest_change(solver), 1e-3) << coarse << " " << start;
      EXPECT_LT(std::abs(solver.balance_error()), 1e-7) << coarse << " " << start;
      if (start == 0) {
        EXPECT_LT(std::abs(solver.energies().contact_damped), 1e-12 * solver.energies().kinetic) << coarse;
      }
    }
  }
}

TEST(VelocitiesOfTiedBodies, ThatAHostGivesAndThatObeyTheTieStayAsTheyAre) {
  for (const int steps : {0, 2}) {
    const Scene scene = in_short_steps(5, 2, 0);
    Solver<double> solver(scene);
    for (int step = 0; step < steps; ++step) solver.step();
    Array<double>& velocity = solver.change_velocities();
    for (std::size_t n = 0; n < solver.mesh().nodes.size(); ++n) {
      const Point v = compatible(solver.mesh().nodes[n]);
      std::copy_n(v.data(), 3, record(velocity.data(), solver.model().node_of_scene_node[n]));
    }
    solver.step();
    EXPECT_LT(largest_change(solver), 1e-3) << steps;
    EXPECT_LT(std::abs(solver.balance_error()), 1e-7) << steps;
  }
}

/// One block spins on another at rest: it takes that along. Both momenta go over, and energy is lost.
TEST(VelocitiesOfTiedBodies, ThatDifferGoOverWithBothMomentaAndLoseEnergy) {
  for (const double start : {0.0, 1e-9}) {
    Scene scene = in_short_steps(6, 2, start);
    scene.bodies[1].angular_velocity = {1, 2, 20};
    scene.bodies[1].velocity = {0.5, -0.2, 0.1};
    scene.bodies[1].velocity_noise = 3;
    Solver<double> solver(scene);
    const Point before = angular_momentum(solver), pushed = solver.momentum();
    for (int step = 0; step < 4; ++step) solver.step();
    const Model<double>& model = solver.model();
    Point after{};  // with the masses that move
    for (std::size_t n = 0; n < model.node_mass.size(); ++n) {
      const double *x = model.nodes.position_of(n), *v = model.nodes.velocity_of(n);
      const Point turning = cross(Point{x[0], x[1], x[2]}, Point{v[0], v[1], v[2]});
      for (std::size_t c = 0; c < 3; ++c) after[c] += model.node_mass[n] * turning[c];
    }
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(solver.momentum()[c], pushed[c], 1e-12 * std::abs(pushed[0])) << c;
      EXPECT_NEAR(after[c], before[c], 1e-6 * std::abs(before[2])) << c << " " << start;
    }
    EXPECT_GT(solver.energies().contact_damped, 0.05 * solver.energies().kinetic);
    EXPECT_LT(std::abs(solver.balance_error()), 1e-7);
  }
}

}  // namespace
}  // namespace pinball::test::tied_velocities_test
