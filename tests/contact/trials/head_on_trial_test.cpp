#include "trial.hpp"

/// Two balls that meet node on node: what is symmetric has to stay so.
namespace pinball::head_on_trial_test {
namespace {

using namespace test;

/// The first scene of README.md: g, mm, ms.
Scene balls() {
  Scene scene;
  scene.name = "balls";
  scene.time.end = 0.03;
  scene.contact.method = ContactMethod::pinball;
  Material aluminium;
  aluminium.name = "al";
  aluminium.density = 2.7e-3;
  aluminium.bulk_modulus = 7e4;
  aluminium.shear_modulus = 3e4;
  aluminium.plastic = true;
  aluminium.yield_stress = 99;
  scene.materials = {aluminium};
  for (const char* const name : {"left", "right"}) {
    Body ball;
    ball.name = name;
    ball.material = "al";
    SphereMesh mesh;
    mesh.radius = 5;
    mesh.core = {6, 6};
    ball.mesh = mesh;
    scene.bodies.push_back(ball);
  }
  scene.bodies[0].velocity = {0, 0, 200};
  scene.bodies[1].position = {0, 0, 10.01};
  return scene;
}

TEST(HeadOn, BallsPartWithoutLateralVelocities) {
  Solver<double> solver(balls());
  run_to_end(solver, [] {});
  for (const std::int32_t body : {0, 1}) {
    const Point v = motion_of_body(solver, body).velocity();
    EXPECT_LT(std::hypot(v[0], v[1]), 1e-9 * 200) << body;
  }
  EXPECT_GT(motion_of_body(solver, 1).velocity()[2], 100);
}

}  // namespace
}  // namespace pinball::head_on_trial_test
