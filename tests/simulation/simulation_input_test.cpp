#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <tests/support/error_of.hpp>

#include "array_scene.hpp"
#include "simulation_case.hpp"

/// What a simulation says of wrong input, and what it makes of input that is not complete.
namespace pinball::simulation_input_test {
namespace {

using test::block;
using test::elastic_material;
using test::impact;

/// The InputError of building a simulation of the scene.
std::string input_error_of(const Scene& scene) {
  return test::error_of([&] { const Simulation simulation(scene); });
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
  EXPECT_THAT(input_error_of(host_.scene), testing::HasSubstr("body b: element 27 is inverted or flat"));
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
            "load.0.body: missing, expected at least one of body, plane, line, box, nearest, set and nodes");
  EXPECT_EQ(with([](Scene& s) { s.bodies.clear(); }), "body: missing, expected at least one [[body]]");
}

TEST(WrongCalls, AreNamed) {
  Simulation simulation(impact());
  std::vector<double> memory(3 * 128, 7.0);
  EXPECT_EQ(test::error_of([&] { simulation.copy(NodeField::position, view_records(memory.data(), 127, 3)); }),
            "copy: to: expected 128 records of 3, got 127 of 3");
  EXPECT_EQ(memory, std::vector<double>(3 * 128, 7.0));
  EXPECT_EQ(test::error_of([&] { simulation.copy(NodeField::mass, ArrayView{}); }),
            "copy: to: expected an array, got a null pointer");
  EXPECT_EQ(test::error_of([&] { simulation.nodes_of("c"); }), "body: there is no body named \"c\"");
  EXPECT_EQ(test::error_of([&] { simulation.run_until(std::nan("")); }), "run_until: expected a time, got nan");
  EXPECT_EQ(simulation.steps(), 0);
  EXPECT_EQ(test::error_of([&] { simulation.on_step(nullptr); }), "on_step: expected a function, got none");
  Scene scene = impact();
  scene.time.subcycling = true;
  Simulation subcycled(scene);
  EXPECT_EQ(test::error_of([&] { subcycled.velocities_to_change(); }),
            "velocities: expected time.subcycling = false, with it they cannot be changed");
  for (const int threads : {-1, 4097, std::numeric_limits<int>::max()}) {
    EXPECT_EQ(test::error_of([&] { const Simulation none(scene, {threads}); }),
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
}  // namespace pinball::simulation_input_test
