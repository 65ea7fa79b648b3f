#include <array>

#include "trial.hpp"
#include "turned_body.hpp"

/// A cube that falls on its corner, on its edge or tilted, onto a held plate.
namespace pinball::drop_trial_test {
namespace {

using namespace test;

class DropTrial : public TrialTest {};
INSTANTIATE_TEST_SUITE_P(All, DropTrial, testing::ValuesIn(variants), variant_name);

constexpr double h = 0.1, speed = 5;     ///< size of all elements [m]; of the fall [m/s]
constexpr double rebound_time = 1.5e-3;  ///< from touching to when the rebound is measured [s]

struct Attitude {
  const char* name;
  Matrix rotation;
};
std::vector<Attitude> attitudes() {
  const Point up{0, 0, 1};
  const double third = 1 / std::sqrt(3.0), half = 1 / std::sqrt(2.0);
  return {{"corner", shortest_turn(up, {third, third, third})},
          {"edge", shortest_turn(up, {half, 0, half})},
          {"edge turned by 27", times(turn(2, 27), shortest_turn(up, {half, 0, half}))},
          {"tilted 7, 13", times(turn(0, 7), turn(1, 13))},
          {"tilted 31, 52", times(turn(2, 17), times(turn(0, 31), turn(1, 52)))}};
}

struct Place {
  const char* name;
  double x, y;  ///< of the lowest point, over h, from a node of the plate
};
constexpr Place places[] = {{"node", 0, 0}, {"face", 0.5, 0.5}, {"edge", 0.5, 0}, {"odd", 0.23, 0.41}};

struct Drop {
  double depth = 0;    ///< when the first force acts, over h
  double rebound = 0;  ///< velocity of the cube [m/s]
};

Drop drop(const Attitude& attitude, const Place& place, const Variant& variant) {
  constexpr double edge = 3 * h, gap = 0.05 * h;
  const Point low = lowest_point({edge, edge, edge}, attitude.rotation);
  const Body plate = block("plate", {8, 8, 2}, h, {-4 * h, -4 * h, -2 * h});
  Body cube = turned(block("cube", {3, 3, 3}, h, {}), attitude.rotation,
                     {place.x * h - low[0], place.y * h - low[1], gap - low[2]});
  cube.velocity = {0, 0, -speed};
  const double touching = gap / speed;
  Scene scene = trial_scene({plate, cube}, touching + h / speed);
  scene.fixed_constraints = {held("plate")};
  Solver<double> solver(with_contact(scene, variant));
  const FirstForce force(solver, 1);
  Drop result;
  bool felt = false;
  while (!solver.at_end() && !(felt && solver.time() > touching + rebound_time)) {
    solver.step();
    felt = felt || force.felt();
    if (!felt) result.depth = (speed * (solver.force_time() + solver.dt()) - gap) / h;
    if (solver.time() < touching + rebound_time) result.rebound = motion_of_body(solver, 1).velocity()[2];
  }
  return result;
}

TEST_P(DropTrial, CubeReboundsFromAHeldPlateWhereItTouches) {
  also_holds({"slideline_lagrange"});
  for (const Attitude& attitude : attitudes()) {
    for (const Place& place : places) {
      const std::string trial = fmt::format("cube, {}, on {}", attitude.name, place.name);
      const Drop found = run_of(trial, [&] { return drop(attitude, place, GetParam()); });
      const double reference = drop(attitude, place, slideline_lagrange).rebound;
      compare(trial + ", depth/h", found.depth, 0, 0.01);
      compare(trial + ", rebound", found.rebound, reference, 0.05 * std::abs(reference));
    }
  }
}

}  // namespace
}  // namespace pinball::drop_trial_test
