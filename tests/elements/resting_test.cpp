#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <utility>

#include <solver/elements/resting_tiles.hpp>
#include <tests/support/solver_case.hpp>

/// Tiles at rest or in free uniform flight: when they are left out, when they wake, and that it changes no bit.
namespace pinball::resting_test {
namespace {

using namespace test;

struct Outcome {
  std::uint64_t hash = 0;
  std::int64_t steps = 0, skipped = 0;
  double dt_min = 0;
  Energies energy;
};

template <class S>
Outcome outcome(const Solver<S>& solver) {
  RunSummary summary;
  fill_summary(solver, summary);
  return {summary.state_hash, summary.steps, summary.element_steps_resting, summary.dt_min, summary.energy};
}

template <class S>
Outcome run_with(Scene scene, bool skip_resting, int threads) {
  scene.skip.resting = skip_resting;
  DefaultExecutionSpace::set_concurrency(threads);
  Solver<S> solver(scene);
  run(solver);
  DefaultExecutionSpace::set_concurrency(1);
  return outcome(solver);
}

/// Runs a scene with all tiles worked and without those that rest; returns how many element steps were left out.
template <class S>
std::int64_t expect_same_bits(const Scene& scene) {
  const Outcome worked = run_with<S>(scene, false, 1);
  EXPECT_EQ(worked.skipped, 0);
  std::int64_t skipped = -1;
  for (const int threads : {1, 3}) {
    const Outcome left_out = run_with<S>(scene, true, threads);
    EXPECT_EQ(left_out.hash, worked.hash) << scene.name << ", " << threads << " threads";
    EXPECT_EQ(left_out.steps, worked.steps);
    EXPECT_EQ(left_out.dt_min, worked.dt_min);
    EXPECT_EQ(left_out.energy.total(), worked.energy.total());
    EXPECT_EQ(left_out.energy.internal, worked.energy.internal);
    EXPECT_EQ(left_out.energy.hourglass, worked.energy.hourglass);
    EXPECT_EQ(left_out.energy.bulk_viscosity, worked.energy.bulk_viscosity);
    EXPECT_TRUE(skipped < 0 || left_out.skipped == skipped) << "depends on the threads";
    skipped = left_out.skipped;
  }
  return skipped;
}

Scene scene_file(const std::string& name, std::int64_t steps) {
  Scene scene = read_scene(find_scene(name));
  scene.time.steps = steps;
  return scene;
}

/// One number of one element that is not zero, of any that it may have.
TEST(RestingTiles, HaveNothingThatElementsKeep) {
  Scene scene = scene_of({block("a", {2, 2, 2}, 0.1, {0, 0, 0}, {3, 0, 0})}, 1, false);
  scene.materials = {plastic_material("steel", 1e8, 0)};
  scene.materials[0].isotropic_share = 0.5;
  scene.element.bulk_viscosity = true;
  Model<double> model = build_model<double>(scene);
  const auto rests = [&] { return RestingTiles<double>(model).rests(0); };
  EXPECT_TRUE(rests());
  auto& e = model.elements;
  int kept = 0;
  for (RealArray* array : {&e.stress, &e.plastic_strain, &e.hourglass_state, &e.viscous_stress, &e.material_state}) {
    ++kept;
    ASSERT_GT(array->size(), 0U) << kept;
    for (const std::size_t at : {std::size_t(0), array->size() - 1}) {
      const double before = (*array)[at];
      (*array)[at] = 1e-30;
      EXPECT_FALSE(rests()) << kept;
      (*array)[at] = before;
    }
  }
  EXPECT_TRUE(rests());
}

/// Air presses with what volumes are rounded by.
TEST(SkippedTiles, ChangeNothingWhereAirIsInCells) {
  Scene scene = scene_of({block("foam", {3, 3, 3}, 0.1, {0.013, 0.7, 0.31}, {}, "foam"),
                          block("far", {3, 3, 3}, 0.1, {5, 0, 0}, {10, 0, 0})},
                         1e-4, false);
  scene.materials.push_back(foam_material("foam"));
  EXPECT_GT(expect_same_bits<double>(scene), 0);
  EXPECT_GT(expect_same_bits<float>(scene), 0);
}

TEST(SkippedTiles, ChangeNothingInRodPlate) {
  EXPECT_GT(expect_same_bits<double>(scene_file("rod_plate", -1)), 0);
  EXPECT_GT(expect_same_bits<float>(scene_file("rod_plate", 60)), 0);
}

TEST(SkippedTiles, ChangeNothingInRodPlateBySlideline) {
  Scene scene = scene_file("rod_plate", 60);
  scene.contact.method = ContactMethod::slideline;
  EXPECT_GT(expect_same_bits<double>(scene), 0);
  EXPECT_GT(expect_same_bits<float>(scene), 0);
}

TEST(SkippedTiles, ChangeNothingInRodOblique) {
  for (const Enforcement enforcement : {Enforcement::penalty, Enforcement::projection, Enforcement::lagrange}) {
    Scene scene = scene_file("rod_oblique", 40);
    scene.contact.enforcement = enforcement;
    scene.contact.gap = enforcement == Enforcement::penalty ? ContactGap::pinball : ContactGap::face;
    EXPECT_GT(expect_same_bits<double>(scene), 0);
    EXPECT_GT(expect_same_bits<float>(scene), 0);
  }
}

TEST(SkippedTiles, ChangeNothingInTaylorBar) {
  EXPECT_GT(expect_same_bits<double>(scene_file("taylor_bar", 40)), 0);
  EXPECT_GT(expect_same_bits<float>(scene_file("taylor_bar", 40)), 0);
}

TEST(SkippedTiles, ChangeNothingInTwoBars) {
  // Both bars share a tile: only one at a time rests.
  for (const double second : {0.0, 0.1}) {
    Scene scene = scene_file("two_bars", -1);
    scene.bodies[1].velocity = {second, 0, 0};
    const std::int64_t skipped = expect_same_bits<double>(scene);
    EXPECT_EQ(skipped > 0, second > 0);
    expect_same_bits<float>(scene);
  }
}

/// 64 layers of four elements along x, in tiles of eight layers.
Scene long_bar() { return scene_of({block("bar", {64, 2, 2}, 0.1, {0, 0, 0})}, 1e-2, false); }

TEST(RestingTiles, AreSkippedAheadOfAWave) {
  Scene scene = long_bar();
  InitialVelocity struck;
  struck.nodes.plane = Plane{{0, 0, 0}, {1, 0, 0}};
  struck.velocity = {10, 0, 0};
  scene.initial_velocities = {struck};
  Solver<double> solver(scene);
  ASSERT_EQ(solver.model().tile_count(), 8);
  std::int64_t before = 0;
  for (int step = 0; step < 80; ++step) {
    solver.step();
    // The first step works all. The next ones bring motion to one more layer of nodes each; step 1 knows of the first.
    int expected = 0;
    for (int tile = 0; tile < 8 && step > 0; ++tile) expected += 8 * tile > step - 1 ? 32 : 0;
    const std::int64_t skipped = outcome(solver).skipped;
    ASSERT_EQ(skipped - before, expected) << "step " << step;
    before = skipped;
  }
}

/// Element steps that are skipped in the next step.
template <class S>
std::int64_t skipped_by_step(Solver<S>& solver) {
  const std::int64_t before = outcome(solver).skipped;
  solver.step();
  return outcome(solver).skipped - before;
}

/// All but one end of the bar rests for the first steps, all of it is awake in the end, and it is as if all were
/// worked.
void expect_to_wake(const Scene& scene) {
  Solver<double> solver(scene);
  EXPECT_EQ(skipped_by_step(solver), 0) << "the first step works all";
  EXPECT_GE(skipped_by_step(solver), 7 * 32);
  while (!solver.at_end()) solver.step();
  EXPECT_EQ(skipped_by_step(solver), 0);
  expect_same_bits<double>(scene);
  expect_same_bits<float>(scene);
}

Scene long_bar_for(std::int64_t steps) {
  Scene scene = long_bar();
  scene.time.steps = steps;
  return scene;
}

NodeSelection end_of_bar() { return {.plane = Plane{{0, 0, 0}, {1, 0, 0}}}; }

TEST(RestingTiles, WakeByALoad) {
  Scene scene = long_bar_for(100);
  scene.loads = {{end_of_bar(), {1e6, 0, 0}, {{1e-4, 2e-4}, {0, 1}}}};
  expect_to_wake(scene);
}

TEST(RestingTiles, WakeByAPrescribedVelocity) {
  Scene scene = long_bar_for(100);
  scene.prescribed_velocities = {{end_of_bar(), std::nullopt, {1, 2, 0}, {{1e-4, 2e-4}, {0, 1}}}};
  expect_to_wake(scene);
}

TEST(RestingTiles, WakeByAConstraint) {
  Scene scene = long_bar_for(100);
  scene.bodies[0].velocity = {1, 0, 3};
  scene.constraints = {{{0, 0, 0}, {1, 0, 0}, ""}};
  expect_to_wake(scene);
}

TEST(RestingTiles, WakeByARigidWall) {
  Scene scene = long_bar_for(120);
  scene.bodies[0].velocity = {-10, 0, 0};
  scene.rigid_walls = {{"wall", {{-0.005, 0, 0}, {1, 0, 0}}, "", "here"}};
  expect_to_wake(scene);
}

TEST(RestingTiles, WakeByContact) {
  for (const Enforcement enforcement : {Enforcement::penalty, Enforcement::projection, Enforcement::lagrange}) {
    Scene scene = long_bar_for(150);
    scene.contact.method = ContactMethod::pinball;
    scene.contact.enforcement = enforcement;
    scene.contact.gap = enforcement == Enforcement::penalty ? ContactGap::pinball : ContactGap::face;
    scene.materials.push_back(elastic_material("other"));  // elements of two materials share no tile
    scene.bodies.push_back(block("striker", {2, 2, 2}, 0.1, {-0.24, 0, 0}, {100, 0, 0}, "other"));
    expect_to_wake(scene);
  }
}

TEST(RestingTiles, FallFreelyAndWakeOnTheGround) {
  // A load on all nodes in proportion to their masses is gravity.
  Scene scene = long_bar_for(300);
  NodalLoad gravity;
  gravity.nodes.body = "bar";
  gravity.force = {-9.81 * 7850 * 0.01 * 6.4 * 4, 0, 0};
  scene.loads = {gravity};
  scene.bodies[0].velocity = {-10, 0, 0};
  scene.rigid_walls = {{"ground", {{-0.02, 0, 0}, {1, 0, 0}}, "", "here"}};
  expect_to_wake(scene);
}

TEST(RestingTiles, AreLookedAtAnewWhenTheModelWasChanged) {
  Scene scene = long_bar();
  scene.guard.energy_error = 1e9;
  Solver<double> solver(scene);
  solver.step();
  EXPECT_EQ(skipped_by_step(solver), 256);
  solver.change_model().elements.stress[0] = 1e6;
  EXPECT_EQ(skipped_by_step(solver), 0);
  EXPECT_EQ(skipped_by_step(solver), 256 - 32);
  EXPECT_GT(kinetic_energy(solver), 0);
}

/// Node by node, of a block whose tiles have nodes of several stretches of the store.
TEST(RestingTiles, HaveTheNodesOfTheirElementsAndNoOthers) {
  for (const Scene& scene : {long_bar(), scene_of({block("a", {30, 25, 20}, 0.1, {0, 0, 0})}, 1)}) {
    const Model<double> model = build_model<double>(scene);
    const RestingTiles<double> resting(model);
    ASSERT_EQ(static_cast<std::int64_t>(resting.tiles().size()), model.tile_count());
    std::size_t most = 0;
    for (const auto& tile : resting.tiles()) {
      std::set<std::int32_t> expected, found;
      std::int32_t elements = 0;
      for (std::size_t e = 0; e < model.slot_of_element.size(); ++e) {
        const std::int64_t slot = model.slot_of_element[e], pack = slot / model.elements.width;
        if (pack < model.tile_packs[tile.number] || pack >= model.tile_packs[tile.number + 1]) continue;
        ++elements;
        for (const std::int32_t node : model.elements.corners(slot)) expected.insert(node);
      }
      for (const NodeRange& range : tile.nodes) {
        ASSERT_LT(range.first, range.end);
        for (std::int32_t node = range.first; node < range.end; ++node) EXPECT_TRUE(found.insert(node).second);
      }
      EXPECT_EQ(found, expected) << "tile " << tile.number;
      EXPECT_EQ(tile.elements, elements);
      most = std::max(most, tile.nodes.size());
    }
    if (model.tile_count() == 8) continue;
    EXPECT_GT(most, 1U) << "the test is to cover tiles of several ranges";
  }
}

TEST(RestingTiles, HaveOneVelocityAndNoStress) {
  const Model<double> still = build_model<double>(long_bar());
  EXPECT_EQ(RestingTiles<double>(still).elements(), 256);
  const auto at_rest = [](auto change) {
    Model<double> model = build_model<double>(long_bar());
    RestingTiles<double> tiles(model);
    change(model);
    const bool woken = tiles.wake(model.nodes);
    EXPECT_EQ(woken, tiles.elements() < 256);
    EXPECT_LE(RestingTiles<double>(model).elements(), tiles.elements());
    return tiles.elements();
  };
  const auto last = [](Model<double>& model) { return 4 * (static_cast<std::size_t>(model.nodes.count) - 1); };
  EXPECT_EQ(at_rest([](auto&) {}), 256);
  for (std::size_t k = 0; k < 3; ++k) {
    for (const double v : {1.0, -5e-324, std::numeric_limits<double>::quiet_NaN()}) {
      EXPECT_EQ(at_rest([&](auto& m) { m.nodes.velocity[last(m) + k] = v; }), 224);
    }
    EXPECT_EQ(at_rest([&](auto& m) { m.nodes.velocity[last(m) + k] = -0.0; }), 256);
  }
  EXPECT_EQ(at_rest([&](auto& m) { m.nodes.velocity[last(m) + 3] = 1; }), 256) << "is no velocity";
  EXPECT_EQ(at_rest([](auto& m) {
              for (std::int32_t n = 0; n < m.nodes.count; ++n) m.nodes.velocity[4 * static_cast<std::size_t>(n)] = 7;
            }),
            256)
      << "all together";

  Model<double> model = build_model<double>(long_bar());
  model.elements.stress[3] = 1;
  EXPECT_EQ(RestingTiles<double>(model).elements(), 224);
  model.elements.hourglass_state[static_cast<std::size_t>(model.elements.slots) * 12 - 1] = 1;
  EXPECT_EQ(RestingTiles<double>(model).elements(), 192);
  model.elements.mass[static_cast<std::size_t>(model.elements.slots) / 2] = 0;  // eroded
  EXPECT_EQ(RestingTiles<double>(model).elements(), 160);
}

}  // namespace
}  // namespace pinball::resting_test
