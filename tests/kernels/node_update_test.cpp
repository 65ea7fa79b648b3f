#include <kernels/node_update.hpp>
#include <tests/support/support.hpp>

namespace pinball::node_update_test {
namespace {

using namespace test;

struct Node {
  alignas(32) double position[4] = {0, 0, 0, 7};  // a record is aligned to itself
  alignas(32) double velocity[4] = {0, 0, 0, 8};
  alignas(32) double force[4] = {0, 0, 0, 9};
};

TEST(IntegrateNode, IsTheCentralDifferenceStep) {
  Node n;
  n.position[0] = 1, n.velocity[0] = 2, n.force[0] = 3;
  n.position[1] = -1, n.velocity[1] = -2, n.force[1] = 0.5;
  const NodeMotion<double> motion = integrate_node(n.position, n.velocity, n.force, 0.5, 0.2, 0.3, 0.1);
  EXPECT_DOUBLE_EQ(n.velocity[0], 2 + 0.2 * 1.5);
  EXPECT_DOUBLE_EQ(n.position[0], 1 + 0.3 * 2.3);
  EXPECT_DOUBLE_EQ(n.velocity[1], -2 + 0.2 * 0.25);
  EXPECT_DOUBLE_EQ(n.position[1], -1 - 0.3 * 1.95);
  EXPECT_EQ(n.velocity[2], 0);
  EXPECT_DOUBLE_EQ(motion.kinetic, 2 * (2 + 0.1 * 1.5) + 2 * (2 - 0.1 * 0.25));  // with the step before
  EXPECT_NEAR(motion.change, 0.3 * 0.3 + 0.05 * 0.05, 1e-15);  // of differences of numbers of the size of 2
  for (const double f : n.force) EXPECT_EQ(f, 0);              // cleared for the next step, spare included
  EXPECT_EQ(n.position[3], 7);
  EXPECT_EQ(n.velocity[3], 8);
}

TEST(IntegrateNode, LeavesANodeAtRestToTheBit) {
  Node n;
  n.position[0] = 0.1, n.position[1] = -0.2, n.position[2] = 0.3;
  EXPECT_EQ(integrate_node(n.position, n.velocity, n.force, 3.0, 0.2, 0.3, 0.2).kinetic, 0);
  EXPECT_EQ(n.position[0], 0.1);
  EXPECT_EQ(n.position[1], -0.2);
  EXPECT_EQ(n.position[2], 0.3);
}

// x_(n+1) - (2 - omega^2 dt^2) x_n + x_(n-1) = 0 has the solution A cos(n phi), sin(phi/2) = omega dt / 2.
TEST(IntegrateNode, FollowsTheExactDiscreteOscillator) {
  const double mass = 2, stiffness = 3, omega = std::sqrt(stiffness / mass);
  for (const double courant : {0.01, 0.5, 0.99}) {
    const double dt = courant * 2 / omega, phi = 2 * std::asin(0.5 * omega * dt);
    Node n;
    n.position[1] = 1;                         // n = 0
    n.velocity[1] = (1 - std::cos(phi)) / dt;  // of step -1/2: x_(-1) = cos(phi)
    for (int i = 1; i <= 1000; ++i) {
      n.force[1] = -stiffness * n.position[1];
      integrate_node(n.position, n.velocity, n.force, 1 / mass, dt, dt, dt);
      ASSERT_NEAR(n.position[1], std::cos(i * phi), 1e-11 / (1 - courant * courant)) << courant;
    }
  }
}

// m/2 v_(n-1/2) . v_(n+1/2) and the trapezoidal work of the forces, sum dt v . (f_n + f_(n+1)) / 2, balance to
// round-off for any force at a constant step.
TEST(IntegrateNode, BalancesKineticEnergyAndTrapezoidalWork) {
  Random random(61);
  const double mass = 1.7, dt = 0.1;
  Node n;
  const Vec3<double> start = random_vector(random);
  n.velocity[0] = start.x, n.velocity[1] = start.y, n.velocity[2] = start.z;
  double kinetic_start = 0, work = 0, previous_force[3] = {0, 0, 0};
  for (int i = 0; i < 1000; ++i) {
    const Vec3<double> f = random_vector(random, 10);
    const double force[3] = {f.x, f.y, f.z};
    for (int c = 0; c < 3; ++c) {
      if (i > 0) work += 0.5 * dt * n.velocity[c] * (force[c] + previous_force[c]);
      n.force[c] = previous_force[c] = force[c];
    }
    const double kinetic = 0.5 * mass * integrate_node(n.position, n.velocity, n.force, 1 / mass, dt, dt, dt).kinetic;
    if (i == 0) kinetic_start = kinetic;
    ASSERT_NEAR(kinetic - kinetic_start, work, 1e-11);
  }
}

TEST(ConstrainNode, RemovesTheComponentsAlongTheNormal) {
  Random random(62);
  for (int trial = 0; trial < 50; ++trial) {
    const Vec3<double> n = random_direction(random), f = random_vector(random), v = random_vector(random);
    const double normal[3] = {n.x, n.y, n.z};
    double force[4] = {f.x, f.y, f.z, 5}, velocity[4] = {v.x, v.y, v.z, 6};
    constrain_node(force, velocity, normal);
    EXPECT_NEAR(dot(Vec3<double>{force[0], force[1], force[2]}, n), 0, 1e-15);
    EXPECT_NEAR(dot(Vec3<double>{velocity[0], velocity[1], velocity[2]}, n), 0, 1e-15);
    EXPECT_VECTOR_NEAR((Vec3<double>{force[0], force[1], force[2]}), f - dot(f, n) * n, 1e-15);
    EXPECT_VECTOR_NEAR((Vec3<double>{velocity[0], velocity[1], velocity[2]}), v - dot(v, n) * n, 1e-15);
    EXPECT_EQ(force[3], 5);
    EXPECT_EQ(velocity[3], 6);
  }
}

TEST(ConstrainNode, KeepsAnAxisExactlyAtRest) {
  Random random(63);
  const double normal[3] = {0, 0, 1};
  Node n;
  n.position[2] = 0.7;
  n.velocity[2] = -0.3;
  for (int i = 0; i < 100; ++i) {
    for (int c = 0; c < 3; ++c) n.force[c] = uniform(random, -1, 1);
    constrain_node(n.force, n.velocity, normal);
    integrate_node(n.position, n.velocity, n.force, 2.0, 0.1, 0.1, 0.1);
    ASSERT_EQ(n.velocity[2], 0);
    ASSERT_EQ(n.position[2], 0.7);
  }
  EXPECT_NE(n.position[0], 0);
}

}  // namespace
}  // namespace pinball::node_update_test
