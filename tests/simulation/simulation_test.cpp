#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <thread>

#include <solver/simulation.hpp>
#include <tests/support/solver_case.hpp>

#include "array_scene.hpp"

namespace pinball {
namespace {

using test::block;
using test::elastic_material;
using test::scene_of;

/// Two blocks in impact, of a few elements.
Scene impact(Precision precision = Precision::float64) {
  Scene scene =
      scene_of({block("a", {3, 3, 3}, 0.1, {0, 0, 0}, {0, 0, 100}), block("b", {3, 3, 3}, 0.1, {0, 0, 0.302})}, 1e-4);
  scene.precision = precision;
  return scene;
}

std::uint64_t hash_of_run(const Scene& scene) {
  Simulation simulation(scene);
  EXPECT_TRUE(simulation.run());
  return simulation.state_hash();
}

TEST(Simulation, ArraysGiveTheBitsOfTheSameMeshInASceneFile) {
  Scene scene = read_scene(find_scene("rod_plate"));
  scene.time.steps = 60;
  for (const Precision precision : {Precision::float64, Precision::float32}) {
    scene.precision = precision;
    EXPECT_EQ(hash_of_run(scene), hash_of_run(test::ArrayScene<>(scene).scene));
  }
}

TEST(Simulation, TakesIndicesOf64BitsThatBeginAtOneAndCoordinatesByComponent) {
  const Scene scene = impact();
  test::ArrayScene<std::int64_t> host(scene, 1);
  std::vector<std::vector<double>> by_component;
  for (std::size_t b = 0; b < host.meshes.size(); ++b) {
    const std::vector<double>& x = host.meshes[b].coordinates;
    const std::size_t nodes = x.size() / 3;
    auto& turned = by_component.emplace_back(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) turned[i % 3 * nodes + i / 3] = x[i];
    ArrayMesh mesh = host.meshes[b].view();
    mesh.coordinates = {turned.data(),
                        NumberType::float64,
                        static_cast<std::int64_t>(nodes),
                        3,
                        sizeof(double),
                        static_cast<std::int64_t>(nodes * sizeof(double))};
    host.scene.bodies[b].mesh = mesh;
  }
  EXPECT_EQ(hash_of_run(scene), hash_of_run(host.scene));
}

TEST(Simulation, NeedsTheArraysOfTheHostOnlyToBeBuilt) {
  const Scene scene = impact();
  auto host = std::make_unique<test::ArrayScene<>>(scene);
  Simulation simulation(host->scene);
  host.reset();
  simulation.run();
  EXPECT_EQ(simulation.state_hash(), hash_of_run(scene));
}

TEST(Simulation, ViewsShowTheMemoryOfTheSolver) {
  for (const Precision precision : {Precision::float64, Precision::float32}) {
    Simulation simulation(impact(precision));
    const ConstArrayView positions = simulation.positions(), velocities = simulation.velocities();
    EXPECT_EQ(positions.type, precision == Precision::float64 ? NumberType::float64 : NumberType::float32);
    EXPECT_EQ(positions.count, simulation.nodes());
    EXPECT_EQ(positions.components, 3);
    const std::int64_t node = simulation.place_of_node()[0];
    const double before = positions.number(node, 2);
    simulation.step();
    EXPECT_NEAR(positions.number(node, 2), before + simulation.dt() * velocities.number(node, 2), 1e-9);
    EXPECT_GT(positions.number(node, 2), before);
    Simulation moved = std::move(simulation);
    EXPECT_EQ(moved.positions().data, positions.data);
    EXPECT_EQ(moved.velocities_to_change().data, velocities.data);
  }
}

TEST(Simulation, MapsLeadFromNumbersOfTheSceneToPlacesInViews) {
  Scene scene = impact();
  scene.materials.push_back(test::plastic_material("soft", 1e6, 0));
  scene.bodies[1].material = "soft";
  const Mesh mesh = generate(scene.bodies[1].mesh);
  Simulation simulation(scene);
  const IndexRange nodes = simulation.nodes_of("b"), elements = simulation.elements_of("b");
  EXPECT_EQ(nodes.first, 64);
  EXPECT_EQ(nodes.count, 64);
  EXPECT_EQ(elements.first, 27);
  EXPECT_EQ(elements.count, 27);
  std::vector<double> copied(3 * 128);
  simulation.copy(NodeField::position, view_records(copied.data(), 128, 3));
  for (std::int64_t n = 0; n < nodes.count; ++n) {
    const Point& from_mesh = mesh.nodes[n];
    const std::int32_t place = simulation.place_of_node()[nodes.first + n];
    for (std::size_t k = 0; k < 3; ++k) {
      const double expected = from_mesh[k] + scene.bodies[1].position[k];
      EXPECT_EQ(simulation.positions().number(place, static_cast<std::int64_t>(k)), expected);
      EXPECT_EQ(copied[3 * (nodes.first + n) + k], expected);
    }
  }
  simulation.run();
  const FieldSnapshot fields = simulation.snapshot();
  std::vector<float> stress(6 * 54), strain(54);
  simulation.copy(ElementField::stress, view_records(stress.data(), 54, 6));
  simulation.copy(ElementField::plastic_strain, view_records(strain.data(), 54, 1));
  double largest = 0;
  for (std::size_t e = 0; e < 54; ++e) {
    for (std::size_t c = 0; c < 6; ++c) EXPECT_EQ(stress[6 * e + c], static_cast<float>(fields.stress[e][c]));
    const double in_view = simulation.plastic_strains().number(simulation.place_of_element()[e]);
    EXPECT_EQ(in_view, fields.plastic_strain[e]);
    EXPECT_EQ(strain[e], static_cast<float>(in_view));
    largest = std::max(largest, in_view);
  }
  EXPECT_EQ(largest, simulation.bodies()[1].max_plastic_strain);
  EXPECT_GT(largest, 0);
}

TEST(Simulation, MassesAreThoseOfTheBodies) {
  const Simulation simulation(impact());
  double sum = 0;
  for (std::int64_t n = 0; n < simulation.nodes(); ++n) sum += simulation.masses().number(n);
  EXPECT_NEAR(sum, 2 * 7850 * 0.3 * 0.3 * 0.3, 1e-9 * sum);
}

TEST(Simulation, CallsBackAfterEachStepAndOnceAtTheEnd) {
  Simulation simulation(impact());
  std::vector<std::int64_t> steps;
  int completed = 0;
  simulation.on_step([&](Simulation& s) {
    EXPECT_EQ(&s, &simulation);
    steps.push_back(s.steps());
    completed += s.complete() ? 1 : 0;
    return AfterStep::go_on;
  });
  EXPECT_TRUE(simulation.run());
  ASSERT_EQ(steps.size(), static_cast<std::size_t>(simulation.steps()) + 1);
  for (std::size_t i = 0; i + 1 < steps.size(); ++i) EXPECT_EQ(steps[i], static_cast<std::int64_t>(i) + 1);
  EXPECT_EQ(completed, 1);
  EXPECT_DOUBLE_EQ(simulation.time(), 1e-4);
  EXPECT_FALSE(simulation.step());
  EXPECT_EQ(steps.size(), static_cast<std::size_t>(simulation.steps()) + 1);
}

TEST(Simulation, ACallbackStopsARunAndAnotherCallGoesOn) {
  Simulation simulation(impact());
  simulation.on_step([](Simulation& s) { return s.steps() == 3 ? AfterStep::stop : AfterStep::go_on; });
  EXPECT_FALSE(simulation.run());
  EXPECT_EQ(simulation.steps(), 3);
  EXPECT_TRUE(simulation.run());
  EXPECT_EQ(simulation.state_hash(), hash_of_run(impact()));
}

TEST(Simulation, AnExceptionOfACallbackPassesAndTheRunMayGoOn) {
  Simulation simulation(impact());
  simulation.on_step([](Simulation& s) {
    if (s.steps() == 2) throw std::logic_error("of the host");
    return AfterStep::go_on;
  });
  EXPECT_THROW(simulation.run(), std::logic_error);
  EXPECT_TRUE(simulation.run());
  EXPECT_EQ(simulation.state_hash(), hash_of_run(impact()));
}

TEST(Simulation, AStopAtATimeChangesNothing) {
  Simulation simulation(impact());
  EXPECT_TRUE(simulation.run_until(0.5e-4));
  EXPECT_GE(simulation.time(), 0.5e-4 * (1 - 1e-12));
  EXPECT_LT(simulation.time() - simulation.dt(), 0.5e-4);
  EXPECT_TRUE(simulation.run());
  EXPECT_EQ(simulation.state_hash(), hash_of_run(impact()));
}

TEST(Simulation, TwoOnTwoThreadsGiveTheBitsOfOneAfterTheOther) {
  const Scene scenes[] = {impact(Precision::float64), impact(Precision::float32)};
  std::uint64_t together[2] = {};
  {
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < 2; ++i) {
      threads.emplace_back([&, i] {
        Simulation simulation(scenes[i], {2});
        simulation.run();
        together[i] = simulation.state_hash();
      });
    }
    for (std::thread& thread : threads) thread.join();
  }
  for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(together[i], hash_of_run(scenes[i]));
  EXPECT_NE(together[0], together[1]);
}

TEST(Simulation, LeavesTheNumberOfThreadsOfTheHostAlone) {
  const int before = DefaultExecutionSpace::concurrency();
  Simulation simulation(impact(), {before + 1});
  simulation.step();
  EXPECT_EQ(simulation.summary().threads, before + 1);
  EXPECT_EQ(DefaultExecutionSpace::concurrency(), before);
}

/// Adds a velocity along x to all nodes.
void push(Simulation& simulation, double speed) {
  const ArrayView v = simulation.velocities_to_change();
  for (std::int64_t n = 0; n < v.count; ++n) *v.at<double>(n, 0) += speed;
}

TEST(Simulation, WhatAChangeOfVelocitiesBringsIsWorkFromOutside) {
  Scene scene = scene_of({block("a", {2, 2, 2}, 0.1, {0, 0, 0})}, 1e-4);  // at rest: its elements are left out
  const double mass = 7850 * 0.2 * 0.2 * 0.2;
  Simulation simulation(scene);
  simulation.step();
  simulation.step();
  push(simulation, 2.0);
  simulation.run();
  EXPECT_NEAR(simulation.history_row().momentum[0], 2 * mass, 1e-9);
  EXPECT_NEAR(simulation.energies().external, 0.5 * mass * 4, 1e-9);
  EXPECT_NEAR(simulation.energies().kinetic, 0.5 * mass * 4, 1e-9);
  EXPECT_LT(std::abs(simulation.balance_error()), 1e-12);
}

TEST(Simulation, AChangeBeforeTheFirstStepIsAnInitialVelocity) {
  Scene scene = impact();
  Simulation changed(scene);
  push(changed, 5);
  changed.run();
  for (Body& body : scene.bodies) body.velocity[0] = 5;
  Simulation given(scene);
  given.run();
  EXPECT_EQ(changed.state_hash(), given.state_hash());
  EXPECT_EQ(changed.summary().momentum_initial, given.summary().momentum_initial);
  EXPECT_EQ(changed.energies().external, 0);
}

TEST(Simulation, ExternalForcesActAsTheLoadsOfASceneDo) {
  Scene scene = scene_of({block("a", {2, 2, 2}, 0.1, {0, 0, 0})}, 1e-4, false);
  Simulation hosted(scene);
  const double mass = 7850 * 0.2 * 0.2 * 0.2, force = 1e5;
  const ArrayView f = hosted.external_forces();
  for (std::int64_t n = 0; n < f.count; ++n) *f.at<double>(n, 1) = force * hosted.masses().number(n) / mass;
  hosted.run();
  scene.loads.emplace_back().nodes.body = "a";
  scene.loads[0].force = {0, force, 0};
  Simulation loaded(scene);
  loaded.run();
  EXPECT_NEAR(hosted.history_row().momentum[1], force * 1e-4, 1e-9);
  EXPECT_NEAR(hosted.history_row().momentum[1], loaded.history_row().momentum[1], 1e-12);
  EXPECT_NEAR(hosted.energies().external, loaded.energies().external, 1e-12);
  EXPECT_LT(std::abs(hosted.balance_error()), 1e-12);
}

TEST(Simulation, ASavedStateGoesOnInAnotherSimulation) {
  Simulation first(impact());
  first.run_until(0.4e-4);
  StateBytes bytes;
  StateArchive::save(bytes, [&](StateArchive& archive) { first.persist(archive); });
  Simulation second(impact());
  StateArchive archive = StateArchive::reading({bytes.data(), bytes.size()});
  second.persist(archive);
  EXPECT_EQ(second.time(), first.time());
  second.run();
  EXPECT_EQ(second.state_hash(), hash_of_run(impact()));
}

// ---- Wrong input ----

/// The InputError that building a simulation of the scene throws; "" if it throws none.
std::string input_error_of(const Scene& scene) {
  try {
    const Simulation simulation(scene);
  } catch (const std::exception& error) {
    return dynamic_cast<const InputError*>(&error) != nullptr ? error.what() : std::string("another error");
  }
  return "";
}

class WrongArrays : public testing::Test {
 protected:
  test::ArrayScene<> host_{impact()};
  test::HostMesh<>& mesh() { return host_.meshes[1]; }
  ArrayMesh& arrays() { return std::get<ArrayMesh>(host_.scene.bodies[1].mesh); }
};

TEST_F(WrongArrays, NullPointers) {
  arrays().coordinates.data = nullptr;
  EXPECT_EQ(input_error_of(host_.scene), "body.b.mesh.coordinates: expected an array, got a null pointer");
  arrays() = mesh().view();
  arrays().hexahedra.data = nullptr;
  EXPECT_EQ(input_error_of(host_.scene), "body.b.mesh.hexahedra: expected an array, got a null pointer");
}

TEST_F(WrongArrays, CountsAndTypes) {
  arrays().coordinates.count = 0;
  EXPECT_EQ(input_error_of(host_.scene), "body.b.mesh.coordinates: expected 1 to 500000000 records, got 0");
  arrays() = mesh().view();
  arrays().hexahedra.components = 4;
  EXPECT_EQ(input_error_of(host_.scene), "body.b.mesh.hexahedra: expected records of 8 numbers, got 4");
  arrays() = mesh().view();
  arrays().hexahedra.type = NumberType::float32;
  EXPECT_EQ(input_error_of(host_.scene), "body.b.mesh.hexahedra: expected integers, got floating-point numbers");
  arrays() = mesh().view();
  arrays().coordinates.type = NumberType::int64;
  EXPECT_EQ(input_error_of(host_.scene), "body.b.mesh.coordinates: expected floating-point numbers, got integers");
}

TEST_F(WrongArrays, IndicesOutOfRange) {
  mesh().hexahedra[8 * 2 + 5] = 64;
  EXPECT_EQ(input_error_of(host_.scene), "body.b.mesh.hexahedra[2][5]: expected a node from 0 to 63, got 64");
  mesh().hexahedra[8 * 2 + 5] = -1;
  EXPECT_EQ(input_error_of(host_.scene), "body.b.mesh.hexahedra[2][5]: expected a node from 0 to 63, got -1");
}

TEST_F(WrongArrays, Coordinates) {
  mesh().coordinates[3 * 7 + 1] = std::nan("");
  EXPECT_EQ(input_error_of(host_.scene), "body.b.mesh.coordinates[7][1]: expected a finite number, got nan");
}

TEST_F(WrongArrays, NodesOfNoElement) {
  mesh().coordinates.insert(mesh().coordinates.end(), {1, 2, 3});
  arrays() = mesh().view();
  EXPECT_EQ(input_error_of(host_.scene),
            "body.b.mesh.coordinates[64]: expected nodes of elements only, no element has this one");
}

TEST_F(WrongArrays, InvertedElements) {
  for (std::size_t i = 0; i < 4; ++i) std::swap(mesh().hexahedra[i], mesh().hexahedra[i + 4]);
  EXPECT_THAT(input_error_of(host_.scene), testing::HasSubstr("body b: element 0 is inverted or flat"));
}

TEST(WrongScenes, NameTheKey) {
  const auto with = [](const auto& change) {
    Scene scene = impact();
    change(scene);
    return input_error_of(scene);
  };
  EXPECT_EQ(with([](Scene& s) { s.materials[0].density = -1; }),
            "material.steel.density: expected a number > 0, got -1");
  EXPECT_EQ(with([](Scene& s) { s.time.end = 0; }), "time.end: expected a number > 0, got 0");
  EXPECT_EQ(with([](Scene& s) { s.bodies[0].velocity[1] = std::nan(""); }),
            "body.a.velocity[1]: expected a finite number, got nan");
  EXPECT_EQ(with([](Scene& s) { s.bodies[1].material = "stel"; }),
            "body.b.material: no material is named \"stel\", nearest is \"steel\"");
  EXPECT_EQ(with([](Scene& s) { s.bodies[1].name = "a"; }),
            "body.a.name: expected a name of its own, got \"a\" a second time");
  EXPECT_EQ(with([](Scene& s) { s.contact.gap = ContactGap::face; }),
            "contact.gap: \"face\" needs enforcement = \"projection\" or \"lagrange\" in this version");
  EXPECT_EQ(with([](Scene& s) { s.rigid_walls.emplace_back(); }),
            "rigid_wall.0.normal: expected a vector of non-zero, finite length, got [0, 0, 0]");
  EXPECT_EQ(with([](Scene& s) { s.loads.emplace_back().nodes.body = "c"; }),
            "load.0.body: no body is named \"c\", nearest is \"a\"");
  EXPECT_EQ(with([](Scene& s) { s.loads.emplace_back(); }),
            "load.0.body: missing, expected at least one of body, plane, line, box and nearest");
  EXPECT_EQ(with([](Scene& s) { s.bodies.clear(); }), "body: missing, expected at least one [[body]]");
}

TEST(WrongCalls, AreNamed) {
  Simulation simulation(impact());
  std::vector<double> memory(3 * 128, 7.0);
  const auto input_error = [&](const auto& call) {
    try {
      call();
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(input_error([&] { simulation.copy(NodeField::position, view_records(memory.data(), 127, 3)); }),
            "copy: to: expected 128 records of 3, got 127 of 3");
  EXPECT_EQ(memory, std::vector<double>(3 * 128, 7.0));
  EXPECT_EQ(input_error([&] { simulation.copy(NodeField::mass, ArrayView{}); }),
            "copy: to: expected an array, got a null pointer");
  EXPECT_EQ(input_error([&] { simulation.nodes_of("c"); }), "body: there is no body named \"c\"");
  EXPECT_EQ(input_error([&] { simulation.on_step(nullptr); }), "on_step: expected a function, got none");
  Scene scene = impact();
  scene.time.subcycling = true;
  Simulation subcycled(scene);
  EXPECT_EQ(input_error([&] { subcycled.velocities_to_change(); }),
            "velocities: expected time.subcycling = false, with it they cannot be changed");
  for (const int threads : {-1, 4097}) {
    EXPECT_EQ(input_error([&] { const Simulation none(scene, {threads}); }),
              "threads: expected an integer >= 0 and <= 4096, got " + std::to_string(threads));
  }
}

TEST(CompletedScene, HasTheDefaultsOfASceneFile) {
  Scene scene;
  scene.contact.friction = 0.2;
  scene.time.end = 1;
  scene.materials = {elastic_material()};
  scene.bodies = {block("a", {1, 1, 1}, 1, {})};
  scene.rigid_walls.emplace_back().plane = {{0, 0, -1}, {0, 0, 2}};
  const Simulation simulation(scene);
  const Scene& made = simulation.scene();
  EXPECT_EQ(made.contact.gap, ContactGap::face);
  EXPECT_EQ(made.contact.static_friction, 0.2);
  EXPECT_EQ(made.element.hourglass_coefficient, 1.0);
  EXPECT_EQ(made.rigid_walls[0].name, "wall_0");
  EXPECT_EQ(made.rigid_walls[0].plane.normal, (Point{0, 0, 1}));
}

}  // namespace
}  // namespace pinball
