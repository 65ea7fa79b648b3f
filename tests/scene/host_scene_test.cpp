#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include <solver/scene_rules.hpp>
#include <tests/support/error_of.hpp>

namespace pinball::host_scene_test {
namespace {

/// As a host makes one: no file has been read.
Scene scene_of_a_host() {
  Scene scene;
  scene.time.end = 1;
  Material& steel = scene.materials.emplace_back();
  steel.name = "steel";
  steel.density = steel.bulk_modulus = steel.shear_modulus = 1;
  Body& bar = scene.bodies.emplace_back();
  bar.name = "bar";
  bar.material = "steel";
  bar.mesh = BlockMesh{{1, 1, 1}, {1, 1, 1}};
  return scene;
}

/// What is said of a scene that one change has made wrong.
std::string error_with(const std::function<void(Scene&)>& change) {
  Scene scene = scene_of_a_host();
  change(scene);
  return test::error_of([&scene] { checked_scene(scene); });
}

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

TEST(HostScene, IsTakenAsItIs) { EXPECT_NO_THROW(checked_scene(scene_of_a_host())); }

TEST(HostScene, HasTheBoundsOfFiles) {
  EXPECT_EQ(error_with([](Scene& scene) { scene.time.cfl = 2; }), "time.cfl: expected a number > 0 and <= 1.2, got 2");
  EXPECT_EQ(error_with([](Scene& scene) { scene.contact.skin = 11; }),
            "contact.skin: expected a number >= 0 and <= 10, got 11");
  EXPECT_EQ(error_with([](Scene& scene) { scene.materials[0].bulk_modulus = 0; }),
            "material.steel.bulk_modulus: expected a number > 0, got 0");
  EXPECT_EQ(error_with([](Scene& scene) { scene.materials[0].erosion_strain = -1; }),
            "material.steel.erosion_strain: expected a number >= 0, got -1");
  EXPECT_EQ(error_with([](Scene& scene) { scene.materials[0].ultimate_stress = -1; }),
            "material.steel.ultimate_stress: expected a number > 0, got -1");
}

TEST(HostScene, MayLeaveOutWhatFilesMay) {
  EXPECT_EQ(error_with([](Scene& scene) {
              scene.contact.static_friction = -1;
              scene.element.hourglass_coefficient = -1;
              scene.materials[0].ultimate_stress = std::numeric_limits<double>::infinity();
            }),
            test::no_error);
}

TEST(HostScene, HasDirectionsOfSomeLength) {
  EXPECT_EQ(error_with([](Scene& scene) { scene.bodies[0].axis = Point{}; }),
            "body.bar.axis: expected a vector of non-zero, finite length, got [0, 0, 0]");
  EXPECT_EQ(error_with([](Scene& scene) { scene.rigid_walls.emplace_back(); }),
            "rigid_wall.0.normal: expected a vector of non-zero, finite length, got [0, 0, 0]");
  EXPECT_EQ(error_with([](Scene& scene) {
              RigidWall& wall = scene.rigid_walls.emplace_back();
              wall.plane.normal = {0, 0, 1};
              wall.nodes.plane = Plane{};
            }),
            "rigid_wall.0.plane.normal: expected a vector of non-zero, finite length, got [0, 0, 0]");
  EXPECT_EQ(error_with([](Scene& scene) {
              FixedConstraint& fixed = scene.fixed_constraints.emplace_back();
              fixed.directions = {{1, 0, 0}};
              fixed.nodes.body = "bar";
            }),
            test::no_error)
      << "only a cylindrical frame has an axis";
}

TEST(HostScene, HasNumbersInAllPlaces) {
  EXPECT_EQ(error_with([](Scene& scene) { scene.bodies[0].velocity_gradient[1][2] = not_a_number; }),
            "body.bar.velocity_gradient[2]: expected a finite number, got nan");
  EXPECT_EQ(error_with([](Scene& scene) {
              NodalLoad& load = scene.loads.emplace_back();
              load.nodes.nearest = Point{0, not_a_number, 0};
            }),
            "load.0.nearest[1]: expected a finite number, got nan");
  EXPECT_EQ(error_with([](Scene& scene) {
              FixedConstraint& fixed = scene.fixed_constraints.emplace_back();
              fixed.directions = {{1, 0, 0}};
              fixed.nodes.plane = Plane{{not_a_number, 0, 0}, {0, 0, 1}};
            }),
            "fixed constraint.0.plane.point[0]: expected a finite number, got nan");
}

}  // namespace
}  // namespace pinball::host_scene_test
