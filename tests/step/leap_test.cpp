#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include <tests/support/solver_case.hpp>

/// Gaps that close within one step which nothing before it told of: the first one, and those in which motions leap or
/// nodes are stopped. Contact of faces has to see them before.
namespace pinball::leap_test {
namespace {

using namespace test;

constexpr double h = 0.01;       ///< size of elements
constexpr double speed = 1500;   ///< a quarter of that of waves
constexpr double sound = 1e-3;   ///< penetration over the sum of radii
constexpr double begins = 2e-6;  ///< when something begins, some steps after the start

/// A block above another one, whose nodes lie over the middles of its faces, at rest.
Scene blocks(double gap) {
  Scene scene = scene_of(
      {block("low", {4, 4, 4}, h, {0, 0, 0}), block("high", {3, 3, 3}, h, {0.4 * h, 0.3 * h, (4 + gap) * h})}, 4e-6);
  scene.contact = ContactSettings();
  scene.element = ElementSettings();
  return scene;
}

/// The deepest penetration of a run, over the sum of the radii.
double deepest(Solver<double>& solver) {
  run_to_end(solver, [] {});
  return solver.counts().penetration_ratio_max();
}

/// Gaps that are open beyond doubt, and closed within the step.
void expect_to_be_seen(const std::vector<double>& gaps, void (*change)(Scene& scene)) {
  for (const double gap : gaps) {
    Scene scene = blocks(gap);
    change(scene);
    Solver<double> solver(scene);
    EXPECT_LT(deepest(solver), sound) << "gap " << gap;
    EXPECT_GT(solver.energies().internal, 0) << "gap " << gap << ": they have met";
  }
}

const std::vector<double> gaps{0.021, 0.03, 0.04};

PrescribedVelocity motion_of_high() {
  PrescribedVelocity motion;
  motion.nodes.body = "high";
  motion.velocity = {0, 0, -speed};
  return motion;
}

TEST(Leaps, OfTheFirstStep) {
  expect_to_be_seen(gaps, [](Scene& scene) { scene.bodies[1].velocity = {0, 0, -speed}; });
}

TEST(Leaps, OfMotionsThatBeginWithTheRun) {
  expect_to_be_seen(gaps, [](Scene& scene) { scene.prescribed_velocities = {motion_of_high()}; });
}

TEST(Leaps, OfMotionsThatBeginLater) {
  expect_to_be_seen(gaps, [](Scene& scene) {
    scene.prescribed_velocities = {motion_of_high()};
    scene.prescribed_velocities[0].when.start = begins;
  });
}

TEST(Leaps, OfTables) {
  expect_to_be_seen(gaps, [](Scene& scene) {
    scene.prescribed_velocities = {motion_of_high()};
    scene.prescribed_velocities[0].table = {{0, begins, 1.0001 * begins, 1}, {0, 0, 1, 1}};
  });
  expect_to_be_seen(gaps, [](Scene& scene) {
    scene.prescribed_velocities = {motion_of_high()};
    scene.prescribed_velocities[0].quantity = MotionQuantity::displacement;
    scene.prescribed_velocities[0].table = {{0, begins, 10 * begins}, {0, 0, 9 * begins}};
  });
}

TEST(Leaps, OfRigidBodies) {
  const std::vector<double> wider{0.021, 0.04, 0.1};
  expect_to_be_seen(wider, [](Scene& scene) {
    scene.rigid_bodies = {{.name = "tool", .bodies = {"high"}}};
    scene.rigid_motions = {{.rigid_body = "tool", .direction = Point{0, 0, -1}, .speed = speed, .when = {begins}}};
  });
  expect_to_be_seen(wider, [](Scene& scene) {
    scene.rigid_bodies = {{.name = "tool", .bodies = {"high"}}};
    scene.rigid_motions = {{.rigid_body = "tool",
                            .axis = Point{0, 1, 0},
                            .angular_speed = speed / (1.5 * h),
                            .table = {{0, begins, 1.0001 * begins, 1}, {0, 0, 1, 1}}}};
  });
}

TEST(Leaps, OfNodesThatAreStopped) {
  expect_to_be_seen(gaps, [](Scene& scene) {
    for (Body& body : scene.bodies) body.velocity = {0, 0, -speed};
    scene.prescribed_velocities = {motion_of_high()};
    scene.prescribed_velocities[0].nodes.body = "low";
    scene.prescribed_velocities[0].velocity = {0, 0, 0};
    scene.prescribed_velocities[0].direction = Point{0, 0, 1};
    scene.prescribed_velocities[0].when.start = begins;
  });
}

TEST(Leaps, OfVelocitiesThatAHostChanges) {
  for (const double gap : gaps) {
    Scene scene = blocks(gap);
    scene.time.end *= 2;
    scene.contact.method = ContactMethod::pinball;
    Solver<double> solver(scene);
    for (int step = 0; step < 3; ++step) solver.step();
    Array<double>& velocity = solver.change_velocities();
    const ModelMesh& mesh = solver.mesh();
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
      if (mesh.body_of_node[n] == 1) {
        velocity[4 * static_cast<std::size_t>(solver.model().node_of_scene_node[n]) + 2] = -speed;
      }
    }
    EXPECT_LT(deepest(solver), sound) << "gap " << gap;
    EXPECT_GT(solver.energies().internal, 0) << "gap " << gap << ": they have met";
  }
}

}  // namespace
}  // namespace pinball::leap_test
