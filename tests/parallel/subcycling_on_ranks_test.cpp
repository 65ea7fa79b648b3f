#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <vector>

#include <tests/elements/thin_section.hpp>
#include <tests/support/changing_scene.hpp>
#include <tests/support/folder_case.hpp>
#include <tests/support/tetrahedra_case.hpp>

#include "outcome.hpp"
#include "shared_scenes.hpp"

/// Elements that make steps of their own, on any ranks in the bits of one process.
namespace pinball::test::subcycling_on_ranks_test {
namespace {

const std::vector<Shared> two_to_four{
    {2, {}}, {2, {Partition::By::random, 5}}, {3, {Partition::By::random, 1}}, {3, {Partition::By::graph, 0}},
    {4, {}}, {4, {Partition::By::random, 2}}};

/// What there was to be the same.
struct Seen {
  std::int32_t longest_cycle = 0;
  std::size_t choices = 0;  ///< of levels, by their elements
};

Seen seen_in(const Scene& scene) {
  Seen seen;
  std::set<std::vector<std::int64_t>> choices;
  const auto look = [&](const auto& solver) {
    seen.longest_cycle = std::max(seen.longest_cycle, solver.subcycling()->cycle_steps());
    choices.insert(solver.subcycling()->elements_of_levels());
  };
  Solver<double> solver(scene);
  while (!solver.at_end()) {
    solver.step();
    look(solver);
  }
  seen.choices = choices.size();
  return seen;
}

/// A bar that turns and shakes, of cubes but for its middle.
Scene shaken(Precision precision = Precision::float64) {
  Scene scene = bar_with_thin_section(2e-3, 4, 12);
  scene.bodies[0].angular_velocity = {3, -5, 20};
  scene.bodies[0].velocity = {10, -20, 30};
  scene.bodies[0].velocity_noise = 1;
  scene.element.bulk_viscosity = true;
  scene.precision = precision;
  return scene;
}

/// The same bar is pressed flat, so that its cubes need smaller steps, or elements erode. rate: of strain [1/time].
Scene pressed(double rate, double erosion_strain = 0) {
  Scene scene = shaken();
  scene.time.end = 3e-3;
  scene.materials = {plastic_material("steel", 4e8, erosion_strain)};
  scene.bodies[0].velocity_gradient = {Point{0, 0, 0}, Point{0, -rate, 0}, Point{0, 0, -rate}};
  scene.bodies[0].angular_velocity = {};
  scene.output.body_energies = true;
  return scene;
}

/// A striker comes to a bar with a thin section; both erode.
Scene struck(Enforcement enforcement = Enforcement::lagrange) {
  Body bar = block("bar", {32, 4, 4}, 1, {0, 0, 0}, {}, "soft");
  auto& mesh = std::get<BlockMesh>(bar.mesh);
  mesh.size[0] = 25;
  mesh.sections[0] = {{12.0, 12}, {1, 8}, {12.0, 12}};
  Scene scene = scene_of({bar, block("striker", {3, 4, 4}, 1, {-3.3, 0.2, 0.1}, {600, 0, 0}, "soft")}, 3e-3);
  scene.materials = {plastic_material("soft", 2e8, 0.3)};
  scene.contact.enforcement = enforcement;
  if (enforcement == Enforcement::lagrange) scene.contact.gap = ContactGap::face;
  scene.time.subcycling = true;
  return scene;
}

/// Boundary conditions with names, whose forces are means over the steps of a cycle. free: without what makes all
/// nodes, or those of the surface, make the smallest step.
Scene driven(bool free) {
  Scene scene = held_and_driven();
  scene.bodies[1] = block("b", {6, 6, 6}, 0.025, {2, 0, 0.5});
  scene.time.end = 4e-4;
  scene.time.subcycling = true;
  scene.loads.clear();
  if (!free) return scene;
  scene.rigid_walls.clear();
  scene.gravities.clear();
  scene.damping.mass = 0;
  return scene;
}

TEST(SubcyclingOnRanks, HasTheBitsOfOneProcess) {
  EXPECT_EQ(seen_in(shaken()).longest_cycle, 4);
  std::vector<Shared> all = some_ranks;
  all.insert(all.end(), two_to_four.begin(), two_to_four.end());
  expect_same_on<double>(all, shaken());
}

TEST(SubcyclingOnRanks, HasThemInSinglePrecision) { expect_same_on<float>(two_to_four, shaken(Precision::float32)); }
TEST(SubcyclingOnRanks, HasThemInMixedPrecision) { expect_same_on<double>(two_to_four, shaken(Precision::mixed)); }

TEST(SubcyclingOnRanks, HasThemOfManyPartitionsAtRandom) {
  Scene scene = pressed(1000);
  scene.time.end = 1e-3;
  std::vector<Shared> all;
  for (std::uint64_t seed = 0; seed < 12; ++seed)
    all.push_back({2 + static_cast<int>(seed % 3), {Partition::By::random, seed}});
  expect_same_on<double>(all, scene);
}

TEST(SubcyclingOnRanks, ChoosesTheSameLevelsWhereStepsChange) {
  const Scene scene = pressed(2000);
  EXPECT_GT(seen_in(scene).choices, 1U);
  expect_same_on<double>(two_to_four, scene);
}

TEST(SubcyclingOnRanks, ChoosesThemWhereElementsErode) {
  const Scene scene = pressed(300, 0.25);
  const Seen seen = seen_in(scene);
  EXPECT_GT(seen.choices, 2U);
  EXPECT_GE(seen.longest_cycle, 4);
  EXPECT_GT(expect_same_on<double>(two_to_four, scene).eroded, 0);
}

TEST(SubcyclingOnRanks, HasThemInContactWhileElementsErode) {
  for (const Enforcement enforcement : {Enforcement::lagrange, Enforcement::penalty}) {
    const Scene scene = struck(enforcement);
    EXPECT_GE(seen_in(scene).longest_cycle, 4);
    const Outcome of = expect_same_on<double>(two_to_four, scene);
    EXPECT_GT(of.pairs, 0);
    EXPECT_GT(of.eroded, 0);
  }
}

TEST(SubcyclingOnRanks, HasThemOfLoadsConstraintsPressuresGravityDampingAndWalls) {
  for (const bool free : {false, true}) {
    const Scene scene = driven(free);
    EXPECT_GE(seen_in(scene).longest_cycle, 4);
    expect_same_on<double>(two_to_four, scene);
    Solver<double> alone(scene);
    run(alone);
    for (const ForceResult& named : alone.boundary().forces(alone.model()))
      EXPECT_NE(norm(named.force), 0) << named.name;
  }
}

TEST(SubcyclingOnRanks, HasThemBesideTetrahedra) {
  static const HostMesh mesh = half_of_tetrahedra(0.01, 0.3);
  Scene scene = striking_bar_of(mesh, Precision::float64);
  scene.rigid_walls.clear();
  scene.constraints = {{{0, 0, 0}, {0, 0, 1}, ""}};
  scene.time.subcycling = true;
  EXPECT_GE(seen_in(scene).longest_cycle, 2);
  expect_same_on<double>(two_to_four, scene);
}

class SubcyclingOnRanksFrom : public FolderTest {
 protected:
  /// What begins and ends, with contact, walls and loads.
  Scene changing() const {
    const std::string path = (folder_ / "scene.toml").string();
    std::ofstream(path) << changing_scene;
    Scene scene = read_scene(path);
    auto& mesh = std::get<BlockMesh>(scene.bodies[3].mesh);
    mesh.elements[0] = 10;
    mesh.sections[0] = {{0.1, 1}, {0.1, 8}, {0.1, 1}};
    scene.tied_contacts.clear();
    scene.time.subcycling = true;
    return scene;
  }
};

TEST_F(SubcyclingOnRanksFrom, WhatBeginsAndEnds) {
  EXPECT_GE(seen_in(changing()).longest_cycle, 4);
  expect_same_on<double>({{2, {}}, {3, {Partition::By::random, 1}}, {4, {Partition::By::graph, 0}}}, changing());
}

TEST_F(SubcyclingOnRanksFrom, AStateThatAnyOthersHaveSaved) {
  for (const Scene& scene : {pressed(1000), pressed(300, 0.25), struck(), driven(true), changing()}) {
    expect_to_go_on_on_others(scene);
  }
}

}  // namespace
}  // namespace pinball::test::subcycling_on_ranks_test
