#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include <solver/scene.hpp>
#include <tests/support/solver_case.hpp>

/// Constraints and motions that begin while what they hold moves, or is pressed.
namespace pinball::begun_constraints_test {
namespace {

using namespace test;

constexpr double begins = 1e-5;

/// A cube of edge 1 cm that flies, until the nodes below are held.
Scene stopped_in_flight(double speed, bool by_motion, double start) {
  Scene scene = scene_of({block("cube", {1, 1, 1}, 0.01, {0, 0, 0}, {0, 0, -speed})}, 4e-5, false);
  scene.element = ElementSettings();
  NodeSelection below;
  below.plane = Plane{{0, 0, 0}, {0, 0, 1}};
  if (by_motion) {
    PrescribedVelocity stop;
    stop.nodes = below;
    stop.velocity = {0, 0, 0};
    stop.direction = Point{0, 0, 1};
    stop.when.start = start;
    scene.prescribed_velocities = {stop};
  } else {
    FixedConstraint fixed;
    fixed.nodes = below;
    fixed.directions = {{0, 0, 1}};
    fixed.when.start = start;
    scene.fixed_constraints = {fixed};
  }
  return scene;
}

/// From the start too: the step does not rise while what they have stopped vibrates.
TEST(BegunConstraints, OfTheStartStopBodiesAsWell) {
  for (const double speed : {100.0, 500.0, 1000.0}) {
    Solver<double> solver(stopped_in_flight(speed, false, 0));
    run(solver);
    EXPECT_LT(solver.ledger().balance_error_max(), 0.01) << speed;
  }
}

TEST(BegunConstraints, StopBodiesWithTheEnergyThatTheyHad) {
  for (const bool by_motion : {true, false}) {
    for (const double speed : {100.0, 500.0, 1000.0}) {
      Solver<double> solver(stopped_in_flight(speed, by_motion, begins));
      run(solver);
      EXPECT_LT(solver.ledger().balance_error_max(), 0.02) << by_motion << ' ' << speed;
    }
  }
}

/// The step falls before they begin, and not long before.
TEST(BegunConstraints, MakeTheStepShortJustBefore) {
  Solver<double> solver(stopped_in_flight(1000, false, begins));
  solver.step();
  while (solver.clock().time() + 4 * solver.clock().dt() < begins) solver.step();
  const double flight = solver.clock().dt();
  double before = flight;
  while (solver.clock().time() < begins) {
    solver.step();
    before = solver.clock().dt_before();
  }
  EXPECT_LT(solver.clock().dt(), 0.8 * flight);
  EXPECT_LT(before, 0.95 * flight);
}

/// The work of contact is on what moves: what a constraint has stopped takes part of it no more.
TEST(BegunConstraints, OfWhatIsPressedKeepTheEnergy) {
  const std::string text = R"(time.end = 1.4e-4
units = "g-mm-ms"
contact = { method = "pinball", static_friction = FRICTION }
material = [{ name = "al", model = "elastic", density = 2.7e-3, young_modulus = 70e3, poisson_ratio = 0.3 }]
rigid_body = [{ name = "hammer", bodies = ["hammer"], mass = 0.005 }]
[[body]]
name = "hammer"
material = "al"
mesh = { type = "block", size = [1, 1, 1], elements = [1, 1, 1] }
position = [0, 0, 1.0]
velocity = [0, 0, -50]
[[body]]
name = "anvil"
material = "al"
mesh = { type = "block", size = [1, 1, 1], elements = [1, 1, 1] }
[[constraint]]
type = "fixed"
directions = "all"
body = "anvil"
plane = { point = [0, 0, 1], normal = [0, 0, 1] }
start = START
)";
  for (const std::string friction : {"0.0", "0.3"}) {
    for (const std::string start : {"5e-5", "1e-4"}) {
      std::string scene = text;
      scene.replace(scene.find("FRICTION"), 8, friction);
      scene.replace(scene.find("START"), 5, start);
      Solver<double> solver(read_scene(SceneSource{"pressed.toml", scene, {}}));
      run(solver);
      EXPECT_LT(solver.ledger().balance_error_max(), 0.005) << friction << ' ' << start;
    }
  }
}

}  // namespace
}  // namespace pinball::begun_constraints_test
