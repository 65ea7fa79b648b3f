#include <array>

#include "trial.hpp"
#include "turned_body.hpp"

/// Elements much longer or flatter than cubes: contact has to begin where the bodies touch.
namespace pinball::aspect_trial_test {
namespace {

using namespace test;

class AspectTrial : public TrialTest {};
INSTANTIATE_TEST_SUITE_P(All, AspectTrial, testing::ValuesIn(variants), variant_name);

constexpr double h = 0.1;  ///< shortest edge [m]

Body block_of(const std::string& name, const Point& size, const std::array<int, 3>& elements, const Point& corner,
              double speed) {
  Body body;
  body.name = name;
  body.material = "steel";
  body.mesh = BlockMesh{size, elements};
  body.position = corner;
  body.velocity = {0, 0, speed};
  return body;
}

/// How deep two blocks are in each other when the first force acts, over h; they close at 20 m/s, 0.003 h a step.
/// Elements are `aspect` times longer along z than across. `shift`: of one block along x and y, over the width of an
/// element. Beyond the length of an element the search for a force ends.
double depth_at_first_force(double aspect, double shift, const Variant& variant) {
  const double across = aspect < 1 ? h / aspect : h, along = aspect * across, gap = 0.3 * h, speed = 10;
  const Point size{3 * across, 3 * across, 2 * along};
  const Scene scene = with_contact(
      trial_scene({block_of("a", size, {3, 3, 2}, {0, 0, 0}, speed),
                   block_of("b", size, {3, 3, 2}, {shift * across, shift * across, 2 * along + gap}, -speed)},
                  1),
      variant);
  Solver<double> solver(scene);
  const FirstForce force(solver, 1);
  const double deepest = std::min(along, 5 * h);
  for (;;) {
    solver.step();
    const double depth = 2 * speed * solver.force_time() - gap;
    if (force.felt() || depth > deepest) return depth / h;
  }
}

TEST_P(AspectTrial, BlocksTouchWhereTheyAre) {
  also_holds({"slideline_penalty", "slideline_projection", "slideline_lagrange"});
  for (const double shift : {0.0, 0.23}) {
    for (const double aspect : {0.125, 0.25, 1.0, 3.0, 4.0, 5.0, 8.0, 20.0, 100.0}) {
      const std::string trial = fmt::format("first force, a = {}, shift {}, depth/h", aspect, shift);
      compare(trial, run_of(trial, [&] { return depth_at_first_force(aspect, shift, GetParam()); }), 0, 0.01);
    }
  }
}

/// Two blocks that overlap at the start by a part of their elements' shortest edge h, and come together at 20 m/s.
/// Returns how much deeper they get, over h.
double deepening(double aspect, double overlap, const Variant& variant) {
  const double across = aspect < 1 ? h / aspect : h, along = aspect * across, speed = 10;
  const Point size{3 * across, 3 * across, 2 * along};
  const double above = 2 * along - overlap * h;
  const Scene scene =
      with_contact(trial_scene({block_of("a", size, {3, 3, 2}, {0, 0, 0}, speed),
                                block_of("b", size, {3, 3, 2}, {0.23 * across, 0.23 * across, above}, -speed)},
                               0.2 * h / speed),
                   variant);
  Solver<double> solver(scene);
  const auto depth = [&] {
    double top = -1e9, bottom = 1e9;
    const auto& mesh = solver.mesh();
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
      const double z = position_of(solver, n)[2];
      (mesh.body_of_node[n] == 0 ? top : bottom) = mesh.body_of_node[n] == 0 ? std::max(top, z) : std::min(bottom, z);
    }
    return top - bottom;
  };
  double most = 0;
  run_to_end(solver, [&] { most = std::max(most, depth()); });
  return most / h - overlap;
}

TEST_P(AspectTrial, BlocksThatOverlapComeNoNearer) {
  for (const double aspect : {0.02, 0.05, 0.125, 1.0, 8.0}) {
    for (const double overlap : {0.02, 0.1, 0.12, 0.17}) {
      const std::string trial = fmt::format("overlap {} h at the start, a = {}, deeper by", overlap, aspect);
      at_most(trial, run_of(trial, [&] { return deepening(aspect, overlap, GetParam()); }), 0.02);
    }
  }
}

/// Two equal bars along z, with flat elements 8:1 where they meet, whose meshes across are shifted by 0.23 of an
/// element. flush: the sides are in one plane all the same, the mesh is cut differently. Returns the relative velocity
/// after the impact over that before.
double rebound_of_bars(bool flush, double poisson_ratio, const Variant& variant) {
  constexpr double length = 16 * h, end = h / 2, shift = 0.23 * h, gap = 0.05 * h, speed = 10;
  const std::vector<BlockSection> lower_z{{length, 16}, {end, 4}}, upper_z{{end, 4}, {length, 16}},
      cut{{h - shift, 1}, {3 * h, 3}, {shift, 1}};
  Body lower = block_of("lower", {}, {}, {0, 0, 0}, speed), upper = lower;
  upper.name = "upper";
  upper.velocity = {0, 0, -speed};
  BlockMesh mesh;
  mesh.size = {4 * h, 4 * h, length + end};
  mesh.elements = {4, 4, 20};
  mesh.sections[2] = lower_z;
  lower.mesh = mesh;
  mesh.sections[2] = upper_z;
  upper.position = {shift, shift, length + end + gap};
  if (flush) {
    mesh.sections[0] = mesh.sections[1] = cut;
    mesh.elements = {5, 5, 20};
    upper.position = {0, 0, length + end + gap};
  }
  upper.mesh = mesh;
  const Scene scene = with_contact(trial_scene({lower, upper}, 1.3e-3, poisson_ratio), variant);
  Solver<double> solver(scene);
  const auto relative = [&] {
    return motion_of_body(solver, 1).velocity()[2] - motion_of_body(solver, 0).velocity()[2];
  };
  const double before = relative();
  run_to_end(solver);
  return relative() / before;
}

TEST_P(AspectTrial, BarsWithFlatEndsRebound) {
  also_holds({"slideline_penalty", "slideline_projection", "slideline_lagrange"});
  // Without lateral strain the two bars are one: all of the velocity comes back after two passages of the wave.
  std::string trial = "bars, flat ends, flush, nu 0, rebound";
  compare(trial, run_of(trial, [&] { return rebound_of_bars(true, 0, GetParam()); }), -1, 0.05);
  trial = "bars, flat ends, shifted, nu 0.3, rebound";
  static const double reference = rebound_of_bars(false, 0.3, slideline_lagrange);
  compare(trial, run_of(trial, [&] { return rebound_of_bars(false, 0.3, GetParam()); }), reference, 0.05);
}

struct Penetration {
  double depth = 0;  ///< at the first force, over the radius
  double speed = 0;  ///< of the plate after the impact [m/s]
};

/// A sphere that hits the middle of a free plate of one layer of elements, 20 x 20 x 100 mm.
Penetration sphere_onto_plate(const Variant& variant) {
  constexpr double across = 0.02, thickness = 0.1, radius = 0.05, speed = 300, gap = 0.02 * across;
  Body sphere = block_of("sphere", {}, {}, {0, 0, thickness + radius + gap}, -speed);
  SphereMesh mesh;
  mesh.radius = radius;
  mesh.core = {4, 4};
  mesh.ring = 2;
  sphere.mesh = mesh;
  const int n = 11;
  const double side = n * across;
  const Scene scene = with_contact(
      trial_scene({block_of("plate", {side, side, thickness}, {n, n, 1}, {-side / 2, -side / 2, 0}, 0), sphere}, 6e-4),
      variant);
  Solver<double> solver(scene);
  const FirstForce force(solver, 1);
  Penetration result;
  bool felt = false;
  run_to_end(solver, [&] {
    if (!felt && force.felt()) {
      felt = true;
      result.depth = (speed * solver.force_time() - gap) / radius;
    }
  });
  result.speed = felt ? motion_of_body(solver, 0).velocity()[2] : 0;
  return result;
}

TEST_P(AspectTrial, ASphereIsStoppedByAPlateOfOneLayer) {
  also_holds({"slideline_penalty", "slideline_projection", "slideline_lagrange"});
  const std::string trial = "sphere on plate, a = 5";
  const Penetration found = run_of(trial, [&] { return sphere_onto_plate(GetParam()); });
  static const Penetration reference = sphere_onto_plate(slideline_lagrange);
  compare(trial + ", first force, depth/h", found.depth * 0.05 / 0.02, 0, 0.05);  // a step is 0.04 h
  compare(trial + ", plate after [m/s]", found.speed, reference.speed, 0.05 * std::abs(reference.speed));
}

}  // namespace
}  // namespace pinball::aspect_trial_test
