#include "geometric_depth.hpp"
#include "trial.hpp"
#include "turned_body.hpp"

/// A body that touches itself.
namespace pinball {
namespace {

using namespace test;

class FoldTrial : public TrialTest {};
INSTANTIATE_TEST_SUITE_P(All, FoldTrial, testing::ValuesIn(variants), variant_name);

/// A strip bent to a hairpin, whose arms loads press together at their ends until it has come to rest. Returns the
/// depth in itself then, over the size of the elements. shift: of the elements of one arm against those of the other,
/// over their size; across, layers: elements across the strip and through its thickness.
double fold(double shift, int across, int layers, const Variant& variant) {
  constexpr double h = 0.05, thickness = 2 * h, gap = 1.5 * h, arm = 0.6;
  const double radius = gap / 2 + thickness / 2, bend = M_PI * radius, lower = arm + shift * h;
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
  GeometricDepth depth(solver.model().mesh);
  depth.take([&](std::size_t n) { return position_of(solver, n); });
  return depth.deepest_node(0, true) / h;
}

TEST_P(FoldTrial, AStripThatFoldsOntoItselfIsNotInItself) {
  struct Case {
    double shift;
    int across, layers;
  };
  for (const auto& [shift, across, layers] :
       {Case{0, 1, 2}, Case{0, 3, 2}, Case{0.37, 3, 2}, Case{0.37, 4, 1}, Case{0.5, 1, 1}, Case{0.5, 3, 2}}) {
    const std::string trial = fmt::format("folded strip, {} x {}, shift {}, depth/h", across, layers, shift);
    at_most(trial, run_of(trial, [&, s = shift, a = across, l = layers] { return fold(s, a, l, GetParam()); }), 0.01);
  }
}

}  // namespace
}  // namespace pinball
