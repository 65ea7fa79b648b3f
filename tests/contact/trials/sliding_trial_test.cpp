#include <array>
#include <vector>

#include "geometric_depth.hpp"
#include "lasting_depth.hpp"
#include "trial.hpp"
#include "turned_body.hpp"

/// Blocks that slide over flat floors of other meshes.
namespace pinball::sliding_trial_test {
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

/// A block of 4 x 4 x `layers` elements, pressed down by a force that begins within the time `ramp`, slides until
/// friction has stopped it.
struct Block {
  const char* name;
  int layers;
  double weight;  ///< force over mass [m/s^2]
  double speed;   ///< at the start [m/s]
  double ramp;    ///< [s]
};
constexpr Block cube{"cube", 4, 1e4, 30, 1e-3}, tower{"tower", 6, 1e5, 100, 0};
constexpr double friction = 0.5;

struct Braking {
  double depth = 0;  ///< that stays, over h
  double way = 0;    ///< over the exact one
};

Braking brake(const Block& block_on_it, const Floor& floor, const Variant& variant) {
  const auto& [name, layers, weight, speed, ramp] = block_on_it;
  const double slowing = friction * weight, slower = speed - slowing * ramp / 2, stop = ramp + slower / slowing;
  const double way = speed * ramp - slowing * ramp * ramp / 6 + slower * slower / (2 * slowing);
  const double size = floor.size * h, above = variant.gap == ContactGap::pinball ? 0.12 * (h + size) : 1e-5 * h;
  const int along = static_cast<int>(std::ceil((0.32 + way) / size)), across = static_cast<int>(std::ceil(0.32 / size));
  const Body ground =
      block("floor", {along, across, 2}, size, {-0.06 + floor.shift * h, -0.06 + floor.shift * h, -2 * size});
  Scene scene = trial_scene({ground, block("block", {4, 4, layers}, h, {0, 0, above}, {speed, 0, 0})}, 1.2 * stop);
  scene.contact.friction = friction;
  scene.fixed_constraints = {held_at("floor", -2 * size)};
  scene.loads = {load_on("block", {0, 0, -7850 * 16 * layers * h * h * h * weight})};
  if (ramp > 0) scene.loads[0].table = {{0, ramp}, {0, 1}};
  Solver<double> solver(with_contact(scene, variant));
  const auto place = [&] {
    double x = 0;
    const auto& mesh = solver.mesh();
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
      if (mesh.body_of_node[n] == 1) x += position_of(solver, n)[0] / (25 * (layers + 1));
    }
    return x;
  };
  const double start = place();
  LastingDepth depth(solver, 3e-4);
  run_to_end(solver, [&] { depth.look(); });
  return {depth.deepest() / h, (place() - start) / way};
}

TEST_P(SlidingTrial, ABlockThatBrakesStaysOnTheFloor) {
  if (GetParam().enforcement == Enforcement::penalty) GTEST_SKIP() << "springs have no friction";
  also_holds({"slideline_lagrange"});
  for (const Floor& floor : floors) {
    std::string trial = fmt::format("braking cube, floor {}", floor.name);
    Braking found = run_of(trial, [&] { return brake(cube, floor, GetParam()); });
    at_most(trial + ", depth/h that stays", found.depth, 0.01);
    // On finer faces the block hops, and its way is a matter of chance: 1.019 to 1.021 with velocities changed by 1e-6.
    compare(trial + ", way", found.way, 1, 0.025);
    trial = fmt::format("braking tower, floor {}", floor.name);
    found = run_of(trial, [&] { return brake(tower, floor, GetParam()); });
    at_most(trial + ", depth/h that stays", found.depth, 0.01);
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
  const auto& mesh = solver.mesh();
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
  also_holds({"pinball_projection_face", "slideline_penalty", "slideline_projection", "slideline_lagrange"});
  const Ride found = run_of("sliding block", [&] { return ride(GetParam()); });
  at_most("sliding block, height/h", found.bumps, 0.001);
  at_most("sliding block, resisting force/load", found.ripple, 0.001);
}

// ---- Grazing --------------------------------------------------------------------------------------------------------

/// Impulse on a block that falls, turned, onto a flat held plate while it flies along it.
double impulse(const Matrix& rotation, double along, const Variant& variant) {
  constexpr double size = 0.1, speed = 10;
  const double above = variant.gap == ContactGap::pinball ? 0.26 * size : 0.01 * size;
  Body falling = turned(block("block", {3, 3, 3}, size, {}), rotation,
                        {0.173, 0.191, above + reach_down({3 * size, 3 * size, 3 * size}, rotation)});
  falling.velocity = {along, 0, -speed};
  Scene scene = trial_scene({block("plate", {12, 5, 1}, size, {-0.1, -0.1, -size}), falling}, 1e-3);
  scene.fixed_constraints = {held("plate")};
  Solver<double> solver(with_contact(scene, variant));
  run_to_end(solver);
  return motion_of_body(solver, 1).velocity()[2] + speed;
}

TEST_P(SlidingTrial, AGrazingImpactHasTheSameImpulse) {
  also_holds({"slideline_penalty", "slideline_projection", "slideline_lagrange"});
  const std::pair<const char*, Matrix> attitudes[] = {
      {"flat", turn(2, 0)}, {"tilted", times(turn(0, 7), turn(1, 13))}, {"corner", times(turn(0, 31), turn(1, 40))}};
  for (const auto& [name, rotation] : attitudes) {
    for (const double along : {30.0, 100.0, 300.0}) {
      const std::string trial = fmt::format("graze, {}, {} m/s along, impulse", name, along);
      const double ratio = run_of(trial, [&, &turned = rotation] {
        return impulse(turned, along, GetParam()) / impulse(turned, 0, GetParam());
      });
      compare(trial, ratio, 1, 0.02);
    }
  }
}

/// Impulse over mass of a block that meets an equal one by `overlap` of an element and slides off it.
double impulse_off_the_edge(double overlap, double along, const Variant& variant) {
  constexpr double size = 0.1;
  Solver<double> solver(with_contact(
      trial_scene({block("a", {3, 3, 3}, size, {0, 0, -3 * size}, {0, 0, 10}),
                   block("b", {3, 3, 3}, size, {(3 - overlap) * size, 0.023, 0.02 * size}, {along, 0, -10})},
                  2e-3),
      variant));
  run_to_end(solver);
  return motion_of_body(solver, 1).velocity()[2] + 10;
}

TEST_P(SlidingTrial, ABlockSlidesOffAnEdge) {
  also_holds({"slideline_projection", "slideline_lagrange"});
  for (const double overlap : {0.1, 0.5, 1.3}) {
    for (const double along : {0.0, 20.0, 100.0}) {
      const std::string trial = fmt::format("slides off, {} h at {} m/s, impulse", overlap, along);
      const double reference = impulse_off_the_edge(overlap, along, slideline_lagrange);
      compare(trial, run_of(trial, [&] { return impulse_off_the_edge(overlap, along, GetParam()); }), reference,
              0.05 * std::max(1.0, reference));
    }
  }
}

}  // namespace
}  // namespace pinball::sliding_trial_test
