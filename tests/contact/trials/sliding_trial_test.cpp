#include <array>
#include <vector>

#include "geometric_depth.hpp"
#include "lasting_depth.hpp"
#include "trial.hpp"

/// Blocks that slide over flat floors of other meshes.
namespace pinball {
namespace {

using namespace test;

class SlidingTrial : public TrialTest {};
INSTANTIATE_TEST_SUITE_P(All, SlidingTrial, testing::ValuesIn(variants), variant_name);

NodalLoad load_on(const std::string& body, const Point& force) {
  NodalLoad load;
  load.nodes.body = body;
  load.force = force;
  return load;
}

// ---- Braking --------------------------------------------------------------------------------------------------------

constexpr double h = 0.05;  ///< size of the elements of the block [m]

struct Floor {
  const char* name;
  double size;   ///< of its elements, over h
  double shift;  ///< of its mesh, over h
};
constexpr Floor floors[] = {{"same", 1, 0}, {"shifted", 1, 0.23}, {"finer", 0.6, 0.1}, {"coarser", 2.1, 0.37}};

struct Braking {
  double depth = 0;  ///< that stays, over h
  double way = 0;    ///< over the exact one
};

/// A cube of 4^3 elements, pressed down, slides until friction has stopped it.
Braking brake(const Floor& floor, const Variant& variant) {
  constexpr double friction = 0.5, weight = 1e4, speed = 30, stop = speed / (friction * weight);
  const double size = floor.size * h, above = variant.gap == ContactGap::pinball ? 0.12 * (h + size) : 1e-5 * h;
  const int along = static_cast<int>(std::ceil(0.42 / size)), across = static_cast<int>(std::ceil(0.32 / size));
  const Body ground =
      block("floor", {along, across, 1}, size, {-0.06 + floor.shift * h, -0.06 + floor.shift * h, -size});
  const Body cube = block("cube", {4, 4, 4}, h, {0, 0, above}, {speed, 0, 0});
  Scene scene = trial_scene({ground, cube}, 1.3 * stop);
  scene.contact.friction = friction;
  scene.fixed_constraints = {held("floor")};
  scene.loads = {load_on("cube", {0, 0, -7850 * std::pow(4 * h, 3) * weight})};
  Solver<double> solver(with_contact(scene, variant));
  const auto place = [&] {
    double x = 0;
    const auto& mesh = solver.model().mesh;
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
      if (mesh.body_of_node[n] == 1) x += position_of(solver, n)[0] / 125;
    }
    return x;
  };
  const double start = place();
  LastingDepth depth(solver, 3e-4);
  run_to_end(solver, [&] { depth.look(); });
  return {depth.deepest() / h, (place() - start) / (0.5 * speed * stop)};
}

TEST_P(SlidingTrial, ABlockThatBrakesStaysOnTheFloor) {
  for (const Floor& floor : floors) {
    const std::string trial = fmt::format("braking block, floor {}", floor.name);
    const Braking found = run_of(trial, [&] { return brake(floor, GetParam()); });
    at_most(trial + ", depth/h that stays", found.depth, 0.01);
    compare(trial + ", way", found.way, 1, 0.01);
  }
}

// ---- Sliding without friction (data/scenes/sliding_block.toml) ------------------------------------------------------

struct Ride {
  double bumps = 0;   ///< highest minus lowest, over the size of the floor's elements
  double ripple = 0;  ///< root of the mean square of the resisting force, over the load
};

Ride ride(const Variant& variant) {
  constexpr double size = 0.1, speed = 10, load = 1e6, rest = 10e-3;
  const double above = variant.gap == ContactGap::pinball ? 0.022 : 1e-4;
  Body slider;
  slider.name = "slider";
  slider.material = "steel";
  slider.mesh = BlockMesh{{0.24, 0.24, 0.16}, {3, 3, 2}};
  slider.position = {-0.12, -0.12, above};
  slider.velocity = {speed, 0, 0};
  Scene scene = trial_scene({block("floor", {16, 6, 1}, size, {-0.3, -0.3, -size}), slider}, 40e-3);
  scene.damping.mass = 500;
  scene.fixed_constraints = {held("floor")};
  PrescribedVelocity drawn;
  drawn.nodes.body = "slider";
  drawn.direction = Point{1, 0, 0};
  drawn.velocity = {speed, 0, 0};
  scene.prescribed_velocities = {drawn};
  scene.loads = {load_on("slider", {0, 0, -load})};
  Solver<double> solver(with_contact(scene, variant));

  std::vector<std::size_t> top;
  const auto& mesh = solver.model().mesh;
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    const Point& x = mesh.nodes[n];
    if (x[2] > 0.15 && std::abs(x[0]) > 0.11 && std::abs(x[1]) > 0.11) top.push_back(n);
  }
  double low = 1e9, high = -1e9, squares = 0, before = 0, energy = 0, fall = 0, kinetic = 0;
  int count = 0;
  run_to_end(solver, [&] {
    if (solver.force_time() < before + 1e-4) return;
    const double time = solver.force_time(), work = solver.energies().external, motion = solver.energies().kinetic;
    const double down = motion_of_body(solver, 1).velocity()[2];
    if (before > rest) {
      double z = 0;
      for (const std::size_t n : top) z += position_of(solver, n)[2] / static_cast<double>(top.size());
      low = std::min(low, z);
      high = std::max(high, z);
      // The work from outside is that of the load, of what draws the block and of the damping.
      const double power =
          (work - energy) / (time - before) + load * (fall + down) / 2 + 2 * 500 * (kinetic + motion) / 2;
      const double force = power / speed - 500 * motion_of_body(solver, 1).mass * speed;
      squares += force * force;
      ++count;
    }
    before = time, energy = work, fall = down, kinetic = motion;
  });
  return {(high - low) / size, std::sqrt(squares / count) / load};
}

TEST_P(SlidingTrial, ABlockSlidesAtOneHeight) {
  const Ride found = run_of("sliding block", [&] { return ride(GetParam()); });
  at_most("sliding block, height/h", found.bumps, 0.001);
  at_most("sliding block, resisting force/load", found.ripple, 0.001);
}

// ---- Grazing --------------------------------------------------------------------------------------------------------

/// Impulse on a block that falls onto a flat held plate while it flies along it.
double impulse(double along, const Variant& variant) {
  constexpr double size = 0.1, speed = 10;
  const double above = variant.gap == ContactGap::pinball ? 0.26 * size : 0.01 * size;
  Scene scene = trial_scene({block("plate", {12, 5, 1}, size, {-0.1, -0.1, -size}),
                             block("block", {3, 3, 3}, size, {0.023, 0.041, above}, {along, 0, -speed})},
                            1e-3);
  scene.fixed_constraints = {held("plate")};
  Solver<double> solver(with_contact(scene, variant));
  run_to_end(solver);
  return motion_of_body(solver, 1).velocity()[2] + speed;
}

TEST_P(SlidingTrial, AGrazingImpactHasTheSameImpulse) {
  also_holds({"slideline_projection", "slideline_lagrange"});
  for (const double along : {30.0, 100.0, 300.0}) {
    const std::string trial = fmt::format("graze, {} m/s along, impulse", along);
    const double ratio = run_of(trial, [&] { return impulse(along, GetParam()) / impulse(0, GetParam()); });
    compare(trial, ratio, 1, 0.01);
  }
}

}  // namespace
}  // namespace pinball
