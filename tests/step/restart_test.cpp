#include <gtest/gtest.h>

#include <tuple>

#include <solver/base/state_archive.hpp>
#include <solver/summary.hpp>
#include <tests/support/law_materials.hpp>
#include <tests/support/saved_state.hpp>
#include <tests/support/solver_case.hpp>

/// A solver that goes on from the saved state of another one makes the same bits, with any number of threads.
namespace pinball::restart_test {
namespace {

using namespace test;

template <class S>
void save(Solver<S>& solver, StateBytes& bytes) {
  StateArchive::save(bytes, [&](StateArchive& archive) { solver.persist(archive); });
}

/// What a run has come to, but for times, threads and the memory that arrays happened to take.
template <class S>
std::string outcome(Solver<S>& solver) {
  while (!solver.at_end()) solver.step();
  solver.finish();
  RunSummary summary;
  fill_summary(solver, summary);
  summary.threads = 0;
  summary.phases.clear();
  summary.skipped_seconds = {};
  summary.bytes_per_element = 0;
  return summary_json(summary);
}

/// Saves before the first step and after parts of the run, and goes on from there in solvers of their own.
template <class S>
void expect_same_after_restart(const Scene& scene, const std::vector<double>& parts = {0, 0.35, 0.8}) {
  DefaultExecutionSpace::set_concurrency(1);
  Solver<S> whole(scene);
  std::vector<StateBytes> states;
  for (const double part : parts) {
    while (whole.time() < part * scene.time.end && !whole.at_end()) whole.step();
    ASSERT_FALSE(whole.at_end());
    save(whole, states.emplace_back());
  }
  const FieldSnapshot there = snapshot(whole);
  const std::string expected = outcome(whole);
  for (std::size_t i = 0; i < states.size(); ++i) {
    DefaultExecutionSpace::set_concurrency(static_cast<int>(1 + i));
    Solver<S> rest(scene);
    EXPECT_EQ(fingerprint(rest.model()), fingerprint(whole.model()));
    EXPECT_EQ(load(rest, states[i]), 0U);
    if (i + 1 == states.size()) {  // the picture of a state is that of the run
      const FieldSnapshot again = snapshot(rest);
      EXPECT_EQ(again.position, there.position);
      EXPECT_EQ(again.stress, there.stress);
      EXPECT_EQ(again.contact_force, there.contact_force);
      EXPECT_EQ(again.pinball_radius, there.pinball_radius);
    }
    EXPECT_EQ(outcome(rest), expected) << "from " << parts[i] << " of the run";
  }
  // A solver that has gone further goes back.
  DefaultExecutionSpace::set_concurrency(1);
  EXPECT_EQ(load(whole, states.back()), 0U);
  EXPECT_EQ(outcome(whole), expected);
}

Scene rod_plate() {
  Scene scene = read_scene(find_scene("rod_plate"));
  scene.time.end = 16e-6;  // late enough for the first elements to erode
  return scene;
}

TEST(Restart, RodPlateWithErosion) {
  const Scene scene = rod_plate();
  expect_same_after_restart<double>(scene, {0.3, 0.75, 0.95});
  Solver<double> solver(scene);
  while (solver.time() < 0.95 * scene.time.end) solver.step();
  EXPECT_GT(solver.counts().eroded_elements(), 0) << "the test is to cover erosion before the state is saved";
}

TEST(Restart, RodPlateInFloatWithPresentRadii) {
  Scene scene = rod_plate();
  scene.contact.radius = ContactRadius::current;
  expect_same_after_restart<float>(scene, {0.9});
}

TEST(Restart, RodPlateByImpulses) {
  Scene scene = rod_plate();
  scene.contact.gap = ContactGap::face;
  scene.contact.enforcement = Enforcement::lagrange;
  expect_same_after_restart<double>(scene, {0.9});
  scene.time.end = 25e-6;  // erosion in most of the steps, before and after
  expect_same_after_restart<double>(scene, {0.75});
}

TEST(Restart, ThousandsOfRowsOfImpulses) { expect_same_after_restart<double>(wide_blocks(1e-4), {0.2, 0.5, 0.8}); }

TEST(Restart, RodPlateBySlideline) {
  Scene scene = rod_plate();
  scene.contact.method = ContactMethod::slideline;
  expect_same_after_restart<double>(scene, {0.5, 0.95});
  scene.contact.enforcement = Enforcement::lagrange;
  expect_same_after_restart<double>(scene, {0.9});
}

TEST(Restart, EveryKindOfBoundaryCondition) {
  Scene scene = pressed_blocks(4e-4);
  expect_same_after_restart<double>(scene);
  scene.contact.enforcement = Enforcement::projection;
  expect_same_after_restart<float>(scene, {0.5});
}

TEST(Restart, AddedMassesAndSettingsOfBodies) {
  Scene scene = pressed_blocks(4e-4);
  scene.bodies[1].element = ElementSettings{};
  Solver<double> first(scene);
  first.step();
  scene.time.smallest_step = 1.3 * first.clock().dt_min();
  expect_same_after_restart<double>(scene);
  expect_same_after_restart<float>(scene, {0.5});
}

TEST(Restart, WhatBeginsAndEndsAndMoves) {
  Scene scene = pressed_blocks(4e-4);
  scene.contact.enforcement = Enforcement::lagrange;
  scene.contact.gap = ContactGap::face;
  scene.prescribed_velocities[0].when = {1e-4, 2e-4};
  FixedConstraint fixed;
  fixed.nodes.body = "b";
  fixed.directions = {{0.6, 0, 0.8}};
  fixed.when = {2.2e-4, 3.5e-4};
  scene.fixed_constraints = {fixed};
  scene.rigid_walls[0].mass = 500;
  scene.rigid_walls[1].speed = 3;
  scene.rigid_walls[1].when.end = 3e-4;
  Pressure pressure;
  pressure.name = "gas";
  pressure.faces.body = "b";
  pressure.faces.plane = Plane{{0, 0, 1.13}, {0, 0, 1}};
  pressure.pressure = 1e7;
  pressure.start = 5e-5;
  scene.pressures = {pressure};
  expect_same_after_restart<double>(scene, {0.2, 0.4, 0.6, 0.8, 0.95});
}

TEST(Restart, WhatRubsOnAWallAndOnABody) {
  Scene scene = scene_of({block("a", {2, 2, 2}, 0.1, {0, 0, 1e-3}, {0, 0, -20}),
                          block("b", {2, 2, 2}, 0.1, {0.201, 0.02, 1e-3}, {-60, 0, -20})},
                         4e-4);
  scene.contact = ContactSettings();
  scene.contact.friction = scene.contact.static_friction = 0.1;
  scene.rigid_walls = {{"floor", {{0, 0, 0}, {0, 0, 1}}, "", "here"}};
  scene.rigid_walls[0].friction = 0.3;
  expect_same_after_restart<double>(scene, {0.2, 0.5, 0.8});
  scene.contact.friction = scene.contact.static_friction = 0;
  expect_same_after_restart<float>(scene, {0.3, 0.7});
}

TEST(Restart, SphereAtAWall) {
  Scene scene = read_scene(find_scene("sphere_wall"));
  scene.time.end *= 0.05;
  expect_same_after_restart<double>(scene);
}

TEST(Restart, TilesAtRest) {
  Scene scene = scene_of({block("a", {4, 4, 200}, 0.1, {0, 0, 0})}, 1e-3, false);
  scene.rigid_walls = {{"floor", {{0, 0, 0}, {0, 0, 1}}, "", "here"}};
  scene.bodies[0].velocity = {0, 0, -10};
  expect_same_after_restart<double>(scene);
  Solver<double> solver(scene);
  RunSummary summary;
  run(solver);
  fill_summary(solver, summary);
  EXPECT_GT(summary.element_steps_resting, 0);
}

TEST(Restart, Subcycling) {
  Scene scene = read_scene(find_scene("refined_layer"));
  scene.time.end *= 0.1;
  expect_same_after_restart<double>(scene, {0.5});
}

TEST(Restart, SubcyclingWithErosionAndContact) {
  Body bar = block("bar", {32, 2, 2}, 1, {0, 0, 0}, {}, "soft");
  auto& mesh = std::get<BlockMesh>(bar.mesh);
  mesh.size[0] = 25;
  mesh.sections[0] = {{12.0, 12}, {1, 8}, {12.0, 12}};
  Scene scene = scene_of({bar, block("striker", {3, 2, 2}, 1, {-3.3, 0, 0}, {600, 0, 0}, "soft")}, 4e-3);
  scene.materials = {plastic_material("soft", 2e8, 0.3)};
  scene.time.subcycling = true;
  expect_same_after_restart<double>(scene, {0.3, 0.7});
}

TEST(Restart, BackStressAndStrainRates) {
  Scene scene = scene_of({block("bar", {6, 3, 3}, 0.1, {0, 0, 0}, {0, 20, -60})}, 8e-4, false);
  scene.rigid_walls = {{"floor", {{0, 0, 0}, {0, 0, 1}}, "", "here"}};
  scene.materials = {plastic_material("steel", 3e8, 0)};
  scene.materials[0].isotropic_share = 0.3;
  scene.materials[0].rate_constant = 500;
  scene.materials[0].rate_exponent = 4;
  scene.materials[0].strain_rate = StrainRate::plastic;
  expect_same_after_restart<double>(scene);
  expect_same_after_restart<float>(scene, {0.6});
}

TEST(Restart, StrainOfRubberAndEnergyOfFluids) {
  Scene scene = scene_of({block("bar", {6, 3, 3}, 0.1, {0, 0, 0}, {0, 5, -20}, "rubber"),
                          block("drop", {3, 3, 3}, 0.1, {2, 0, 0}, {0, 0, -20}, "water")},
                         8e-4, false);
  scene.element.hourglass = HourglassControl::viscous;
  scene.rigid_walls = {{"floor", {{0, 0, 0}, {0, 0, 1}}, "", "here"}};
  Material rubber = elastic_material("rubber"), water = plastic_material("water", 0, 0);
  rubber.mooney_rivlin = MooneyRivlinSettings{3e9, 1e9, 0.45};
  water.shear_modulus = water.plastic_modulus = 0;
  water.fluid = FluidSettings{1e-3};
  water.equation_of_state.emplace();
  water.equation_of_state->sound_speed = 1500;
  scene.materials = {rubber, water};
  expect_same_after_restart<double>(scene);
  expect_same_after_restart<float>(scene, {0.6});
}

TEST(Restart, CompactionOfWhatCrushes) {
  Scene scene = scene_of({block("bar", {6, 3, 3}, 0.1, {0, 0, 0}, {0, 5, -20}, "soil")}, 8e-4, false);
  scene.rigid_walls = {{"floor", {{0, 0, 0}, {0, 0, 1}}, "", "here"}};
  scene.materials = {soil_material("soil")};
  expect_same_after_restart<double>(scene);
  expect_same_after_restart<float>(scene, {0.6});
}

TEST(Restart, WhatFoamsHaveBesideTheirSkeleton) {
  Scene scene = scene_of({block("bar", {6, 3, 3}, 0.1, {0, 0, 0}, {0, 5, -40}, "foam")}, 8e-4, false);
  scene.rigid_walls = {{"floor", {{0, 0, 0}, {0, 0, 1}}, "", "here"}};
  scene.materials = {foam_material("foam")};
  expect_same_after_restart<double>(scene);
  expect_same_after_restart<float>(scene, {0.6});
}

TEST(Restart, WhatIsTorn) {
  Scene scene = scene_of({block("bar", {6, 3, 3}, 0.1, {0, 0, 0}, {0, 5, -40}, "soil")}, 8e-4, false);
  scene.rigid_walls = {{"floor", {{0, 0, 0}, {0, 0, 1}}, "", "here"}};
  scene.materials = {soil_material("soil")};
  scene.materials[0].equation_of_state->tension_limit = 1e7;
  scene.materials[0].equation_of_state->tears = true;
  expect_same_after_restart<double>(scene);
}

TEST(Restart, DeformationOfWhatHasAxes) {
  Scene scene = scene_of({block("bar", {6, 3, 3}, 0.1, {0, 0, 0}, {0, 5, -20}, "wood")}, 8e-4, false);
  scene.rigid_walls = {{"floor", {{0, 0, 0}, {0, 0, 1}}, "", "here"}};
  scene.materials = {orthotropic()};
  expect_same_after_restart<double>(scene);
  expect_same_after_restart<float>(scene, {0.6});
}

TEST(StateArchive, GivesBackWhatItTook) {
  std::vector<std::pair<double, std::string>> pairs{{0.5, "half"}, {-1, ""}};
  std::vector<std::string> texts{"a", "long text with\nbreaks"};
  std::array<int, 3> numbers{1, 2, 3};
  bool flag = true;
  StateBytes bytes;
  StateArchive::save(bytes, [&](StateArchive& archive) { archive(pairs, texts, numbers, flag); });
  auto expected = std::tuple(pairs, texts, numbers, flag);
  decltype(expected) read;
  StateArchive archive = StateArchive::reading({bytes.data(), bytes.size()});
  archive(std::get<0>(read), std::get<1>(read), std::get<2>(read), std::get<3>(read));
  EXPECT_EQ(read, expected);
  EXPECT_EQ(archive.left(), 0U);
}

TEST(StateArchive, RefusesSizesThatTheBytesCannotHold) {
  std::vector<double> numbers{1, 2, 3};
  StateBytes bytes;
  StateArchive::save(bytes, [&](StateArchive& archive) { archive(numbers); });
  for (const std::uint64_t size : {std::uint64_t{4}, std::uint64_t{1} << 40, ~std::uint64_t{0}}) {
    std::memcpy(bytes.data(), &size, sizeof size);
    StateArchive archive = StateArchive::reading({bytes.data(), bytes.size()});
    EXPECT_THROW(archive(numbers), InputError) << size;
  }
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    StateArchive archive = StateArchive::reading({bytes.data(), length});
    EXPECT_THROW(archive(numbers), InputError) << length;
  }
}

TEST(StateArchive, RefusesTheStateOfAnotherMesh) {
  Solver<double> two(scene_of({block("a", {2, 2, 2}, 0.1, {0, 0, 0})}, 1e-4));
  Solver<double> three(scene_of({block("a", {3, 3, 3}, 0.1, {0, 0, 0})}, 1e-4));
  EXPECT_NE(fingerprint(two.model()), fingerprint(three.model()));
  StateBytes bytes;
  save(two, bytes);
  StateArchive archive = StateArchive::reading({bytes.data(), bytes.size()});
  EXPECT_THROW(three.persist(archive), InputError);
}

}  // namespace
}  // namespace pinball::restart_test
