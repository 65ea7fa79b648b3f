#include <array>

#include "geometric_depth.hpp"
#include "trial.hpp"

/// Elements of very different sizes.
namespace pinball::size_trial_test {
namespace {

using namespace test;

class SizeTrial : public TrialTest {};
INSTANTIATE_TEST_SUITE_P(All, SizeTrial, testing::ValuesIn(variants), variant_name);

struct Impact {
  double velocity = 0;  ///< of the cube at the end, over that before, positive where it is thrown back
  double depth = 0;     ///< largest on the way, over the cube's elements
};

/// A cube of n^3 elements of size s falls at 400 m/s onto the middle node of a block of elements of size ratio s, whose
/// lower side is held.
Impact cube_onto_node(double ratio, int n, const Variant& variant) {
  constexpr double s = 0.01, gap = 0.05 * s, speed = 400;
  const double big = ratio * s;
  const int layers = ratio < 5 ? 4 : 2;
  const Body target =
      block("target", {layers, layers, layers}, big, {-layers / 2 * big, -layers / 2 * big, -layers * big});
  const Body cube = block("cube", {n, n, n}, s, {-n * s / 2, -n * s / 2, gap}, {0, 0, -speed});
  Scene scene = trial_scene({target, cube}, 2 * n * s / speed);
  scene.fixed_constraints = {held_at("target", -layers * big)};
  Solver<double> solver(with_contact(scene, variant));
  GeometricDepth depth(solver.mesh());
  Impact result;
  run_to_end(solver, [&] {
    depth.take([&](std::size_t node) { return position_of(solver, node); });
    result.depth = std::max(result.depth, depth.deepest_node(1) / s);
  });
  result.velocity = motion_of_body(solver, 1).velocity()[2] / speed;
  return result;
}

TEST_P(SizeTrial, SmallCubesReboundFromLargeElements) {
  also_holds({"slideline_projection", "slideline_lagrange"});
  for (const int n : {1, 2}) {
    for (const double ratio : {1.0, 4.0, 9.0, 20.0, 100.0, 1000.0, 10000.0}) {
      const std::string trial = fmt::format("cube of {}^3 on a node, h/s = {}", n, ratio);
      const Impact found = run_of(trial, [&] { return cube_onto_node(ratio, n, GetParam()); });
      at_least(trial + ", rebound/v", found.velocity, 0.3);
      at_most(trial + ", depth/s", found.depth, 0.1);  // a step is 0.06 s
    }
  }
}

/// How deep a cube of 2^3 elements of size s is when the first force acts, over its way in a step. It flies several of
/// its elements in the 20 steps for which pairs are listed ahead, from `distance` elements away.
double steps_at_first_force(double ratio, double distance, const Variant& variant) {
  constexpr double s = 0.01, speed = 1000;
  const double big = ratio * s;
  const Body target = block("target", {2, 2, 2}, big, {-0.77 * big, -0.41 * big, -2 * big});
  const Body cube = block("cube", {2, 2, 2}, s, {-s, -s, distance * s}, {0, 0, -speed});
  Scene scene = trial_scene({target, cube}, (distance + 2) * s / speed);
  scene.fixed_constraints = {held("target")};
  Solver<double> solver(with_contact(scene, variant));
  const FirstForce force(solver, 1);
  double depth = 0;
  while (!solver.at_end()) {
    solver.step();
    depth = (speed * solver.force_time() - distance * s) / (speed * solver.dt());
    if (force.felt()) break;
  }
  return depth;
}

TEST_P(SizeTrial, WhatIsFastIsFoundInTime) {
  also_holds({"slideline_penalty", "slideline_projection", "slideline_lagrange"});
  for (const double ratio : {1.0, 10.0, 10000.0}) {
    for (const double distance : {0.5, 5.3, 61.7}) {
      const std::string trial = fmt::format("1000 m/s, h/s = {}, from {} s, depth in steps", ratio, distance);
      compare(trial, run_of(trial, [&] { return steps_at_first_force(ratio, distance, GetParam()); }), 0, 1);
    }
  }
}

}  // namespace
}  // namespace pinball::size_trial_test
