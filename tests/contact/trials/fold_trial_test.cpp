#include "geometric_depth.hpp"
#include "trial.hpp"
#include "turned_body.hpp"

/// A body that touches itself.
namespace pinball::fold_trial_test {
namespace {

using namespace test;

class FoldTrial : public TrialTest {};
INSTANTIATE_TEST_SUITE_P(All, FoldTrial, testing::ValuesIn(variants), variant_name);

/// A strip bent to a hairpin, whose arms loads press together at their ends until it has come to rest. Returns the
/// depth in itself then, over the size of the elements. gap: between the arms at first, over that size; shift: of the
/// elements of one arm against those of the other; across, layers: elements across the strip and through its thickness.
double fold(double gap, double shift, int across, int layers, const Variant& variant) {
  constexpr double h = 0.05, thickness = 2 * h, arm = 0.6;
  const double radius = gap * h / 2 + thickness / 2, bend = M_PI * radius, lower = arm + shift * h;
  const int along = static_cast<int>(std::lround((2 * arm + bend) / h));
  Body strip;
  strip.name = "strip";
  strip.material = "steel";
  strip.mesh = BlockMesh{{2 * arm + bend, 0.15, thickness}, {along, across, layers}};
  strip = mapped(strip, [&](const Point& x) -> Point {
    const double up = x[2] - thickness / 2;  // out of the middle of the strip: inward once it is bent
    if (x[0] < lower) return {x[0] - lower, x[1], up - radius};
    if (x[0] > lower + bend) return {lower + bend - x[0], x[1], radius - up};
    const double angle = (x[0] - lower) / radius;
    return {(radius - up) * std::sin(angle), x[1], -(radius - up) * std::cos(angle)};
  });
  Scene scene = trial_scene({strip}, 20e-3);
  scene.damping.mass = 1500;
  for (const double side : {-1.0, 1.0}) {
    NodalLoad load;
    load.nodes.box = Box{{-2 * arm, -1, side > 0 ? 0.0 : -1.0}, {-0.8 * arm, 1, side > 0 ? 1.0 : 0.0}};
    load.force = {0, 0, -side * 3e6};
    load.table = {{0, 4e-3}, {0, 1}};
    scene.loads.push_back(load);
  }
  Solver<double> solver(with_contact(scene, variant));
  run_to_end(solver);
  GeometricDepth depth(solver.mesh());
  depth.take([&](std::size_t n) { return position_of(solver, n); });
  return depth.deepest(true) / h;
}

struct Case {
  double gap, shift;
  int across, layers;
};

std::string named(const Case& c) {
  return fmt::format("folded strip, {} x {}, gap {} h, shift {}, depth/h", c.across, c.layers, c.gap, c.shift);
}

TEST_P(FoldTrial, AStripThatFoldsOntoItselfIsNotInItself) {
  also_holds({"slideline_penalty", "slideline_projection", "slideline_lagrange"});
  for (const auto& c : {Case{4, 0.37, 3, 2}, Case{4, 0.5, 1, 1}, Case{4, 0.5, 4, 1}}) {
    at_most(named(c), run_of(named(c), [&] { return fold(c.gap, c.shift, c.across, c.layers, GetParam()); }), 0.01);
  }
}

/// Elements of one body that are near each other from the start may be far apart along its surface.
TEST_P(FoldTrial, ArmsThatAreCloseFromTheStartTouchToo) {
  for (const auto& c : {Case{1.5, 0, 1, 2}, Case{1.5, 0, 3, 2}, Case{1.5, 0.37, 4, 1}, Case{1.5, 0.5, 3, 2}}) {
    at_most(named(c), run_of(named(c), [&] { return fold(c.gap, c.shift, c.across, c.layers, GetParam()); }), 0.01);
  }
}

}  // namespace
}  // namespace pinball::fold_trial_test
