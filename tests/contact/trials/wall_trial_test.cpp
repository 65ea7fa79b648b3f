#include "trial.hpp"
#include "turned_body.hpp"

/// Nodes that are pressed between a body and a rigid wall.
namespace pinball::wall_trial_test {
namespace {

using namespace test;

class WallTrial : public TrialTest {};
INSTANTIATE_TEST_SUITE_P(All, WallTrial, testing::Values(variants[0], variants[1]), variant_name);

constexpr double h = 0.1;

/// Two blocks on a floor, with faces that lean: that of the one that comes overhangs the foot of the other, and presses
/// its nodes down as it pushes them on.
Scene overhang(double lean, double over, int elements, double friction) {
  const auto leaning = [&](const std::string& name, double by, const Point& corner) {
    return mapped(block(name, {2 * elements, elements, elements}, h / elements, {}), [&](const Point& x) {
      return Point{corner[0] + x[0] - by * x[2], corner[1] + x[1], corner[2] + x[2]};
    });
  };
  Body struck = leaning("struck", lean, {}), striker = leaning("striker", over, {2 * h + 0.001, 0.013, 0.001});
  striker.velocity = {-20, 0, 0};
  Scene scene = trial_scene({struck, striker}, 1.5e-3);
  scene.rigid_walls = {floor_of(friction)};
  return scene;
}

TEST_P(WallTrial, NodesBetweenABodyAndAWallKeepTheBalance) {
  struct Case {
    double lean, over;
    int elements;
  };
  for (const Case& c : {Case{1, 0.5, 1}, {1, 0.5, 3}, {1, 0.8, 2}, {0.5, 0.4, 3}}) {
    const std::string trial = fmt::format("overhang, {} over {}, {} elements", c.over, c.lean, c.elements);
    const double balance = run_of(trial, [&] {
      Solver<double> solver(with_contact(overhang(c.lean, c.over, c.elements, 0), GetParam()));
      return worst_balance_of_run(solver);
    });
    at_most(trial + ", balance", balance, 1e-3);
  }
}

/// The wall may also come to the bodies.
TEST_P(WallTrial, NodesBetweenABodyAndAWallThatMovesKeepTheBalance) {
  Scene scene = overhang(1, 0.5, 3, 0);
  scene.rigid_walls[0].speed = 2;
  const double balance = run_of("moving wall", [&] {
    Solver<double> solver(with_contact(scene, GetParam()));
    return worst_balance_of_run(solver);
  });
  at_most("overhang on a wall that moves, balance", balance, 2e-3);
}

}  // namespace
}  // namespace pinball::wall_trial_test
