#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include <solver/field_base.hpp>

#include "array_scene.hpp"
#include "simulation_case.hpp"

/// Arrays of a host that a simulation is built from, and those in which it shows its state.
namespace pinball::simulation_arrays_test {
namespace {

using test::hash_of_run;
using test::impact;

TEST(Simulation, ArraysGiveTheBitsOfTheSameMeshInASceneFile) {
  Scene scene = read_scene(find_scene("rod_plate"));
  scene.time.steps = 60;
  for (const Precision precision : {Precision::float64, Precision::float32, Precision::mixed}) {
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

TEST(Simulation, FieldsKnowWhereNodesWereAndWhatMeshFilesCallThem) {
  Scene scene = read_scene(find_scene("crushed_tube"));
  ASSERT_GT(scene.output.field_interval, 0);
  const Simulation tube(scene);
  const FieldBase base = tube.field_base();  // the file numbers nodes and elements from 1 on
  ASSERT_EQ(static_cast<std::int64_t>(base.node_number.size()), tube.nodes());
  ASSERT_EQ(static_cast<std::int64_t>(base.element_number.size()), tube.elements());
  for (std::size_t n = 0; n < base.node_number.size(); ++n) {
    EXPECT_EQ(base.node_number[n], static_cast<std::int64_t>(n) + 1);
  }
  for (std::size_t e = 0; e < base.element_number.size(); ++e) {
    EXPECT_EQ(base.element_number[e], static_cast<std::int64_t>(e) + 1);
  }
  EXPECT_EQ(base.initial[0], (Point{19, 0, 0}));

  const Simulation generated(impact());
  EXPECT_TRUE(generated.field_base().node_number.empty());
  EXPECT_TRUE(generated.field_base().element_number.empty());
  EXPECT_EQ(static_cast<std::int64_t>(generated.field_base().initial.size()), generated.nodes());
}

TEST(Simulation, MassesAreThoseOfTheBodies) {
  const Simulation simulation(impact());
  double sum = 0;
  for (std::int64_t n = 0; n < simulation.nodes(); ++n) sum += simulation.masses().number(n);
  EXPECT_NEAR(sum, 2 * 7850 * 0.3 * 0.3 * 0.3, 1e-9 * sum);
}

}  // namespace
}  // namespace pinball::simulation_arrays_test
