#include <cmath>
#include <vector>

#include "trial.hpp"
#include "turned_body.hpp"

/// A column of cubes that stands on a floor under gravity: it has to stay up, and where it is.
namespace pinball::column_trial_test {
namespace {

using namespace test;

constexpr double h = 0.1;
constexpr int cubes = 5;

/// aside: of every other cube [h]; turned: each cube over the one below [degree].
Scene column(double friction, double aside, double turned_by) {
  std::vector<Body> bodies;
  for (int i = 0; i < cubes; ++i) {
    const Body cube = block("cube " + std::to_string(i), {2, 2, 2}, h / 2, {});
    bodies.push_back(turned(cube, turn(2, turned_by * i), {aside * (i % 2) * h, 0, h * (i + 0.5)}));
  }
  Scene scene = trial_scene(bodies, 1e9);
  scene.contact.friction = scene.contact.static_friction = friction;
  scene.rigid_walls = {floor_of(friction)};
  Gravity gravity;
  gravity.acceleration = {0, 0, -981};
  scene.gravities = {gravity};
  return scene;
}

Point centre_of_body(const Solver<double>& solver, std::int32_t body) {
  Point sum{};
  double mass = 0;
  const Model<double>& model = solver.model();
  for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n) {
    if (model.mesh.body_of_node[n] != body) continue;
    const double m = model.node_mass[model.node_of_scene_node[n]];
    const Point x = position_of(solver, n);
    mass += m;
    for (std::size_t k = 0; k < 3; ++k) sum[k] += m * x[k];
  }
  return {sum[0] / mass, sum[1] / mass, sum[2] / mass};
}

/// How far the cubes are from where they were put, along the floor and down, the largest [h].
struct Strayed {
  double aside = 0, down = 0;
};

Strayed strayed_after(const Scene& scene, int steps) {
  Solver<double> solver(scene);
  std::vector<Point> start;
  for (std::int32_t body = 0; body < cubes; ++body) start.push_back(centre_of_body(solver, body));
  for (int step = 0; step < steps; ++step) solver.step();
  Strayed most;
  for (std::int32_t body = 0; body < cubes; ++body) {
    const Point way = minus(centre_of_body(solver, body), start[body]);
    most.aside = std::max(most.aside, std::hypot(way[0], way[1]) / h);
    most.down = std::max(most.down, -way[2] / h);
  }
  return most;
}

constexpr int many_steps = 10000;

TEST(Column, StaysUpWhereItIs) {
  const Strayed strayed = strayed_after(column(0, 0, 0), many_steps);
  EXPECT_LT(strayed.aside, 1e-11);
  EXPECT_LT(strayed.down, 2e-4);  // it swings under its own weight
}

TEST(Column, OfCubesThatAreAsideAndTurnedDoesNotCreepWithFriction) {
  const Strayed strayed = strayed_after(column(0.3, 0.2, 7), many_steps);
  EXPECT_LT(strayed.aside, 2e-4);
  EXPECT_LT(strayed.down, 2e-4);
}

}  // namespace
}  // namespace pinball::column_trial_test
