#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include <solver/model/initial_overlap.hpp>
#include <solver/model/look/thin_bodies.hpp>
#include <solver/scene.hpp>
#include <solver/step/report.hpp>
#include <tests/support/cube_text.hpp>
#include <tests/support/folder_case.hpp>

/// What is looked for in a body all of whose nodes are those of others, too.
namespace pinball::test::shared_bodies_test {
namespace {

/// Three cubes in a row, parts 1, 3 and 2: the one in the middle has no node of its own.
const std::string row_of_cubes = "*KEYWORD\n*NODE\n" + cube_lines(1) +
                                 "9,2,0,0\n10,2,1,0\n11,2,0,1\n12,2,1,1\n13,3,0,0\n14,3,1,0\n15,3,0,1\n16,3,1,1\n"
                                 "*ELEMENT_SOLID\n1,1,1,2,3,4,5,6,7,8\n2,3,2,9,10,3,6,11,12,7\n"
                                 "3,2,9,13,14,10,11,15,16,12\n*END\n";

class SharedBodies : public FolderTest {
 protected:
  /// hit: mesh and position of a fourth body.
  Scene scene(const std::string& hit) const {
    std::ofstream(folder_ / "cubes.k") << row_of_cubes;
    const std::string elastic = "density = 2.7e-3\nyoung_modulus = 7e4\npoisson_ratio = 0.3\n";
    std::string text =
        "time.end = 2e-3\ncontact = { method = \"pinball\", enforcement = \"penalty\", gap = \"pinball\" }\n";
    text += "[[material]]\nname = \"elastic\"\nmodel = \"elastic\"\n" + elastic;
    text +=
        "[[material]]\nname = \"plastic\"\nmodel = \"von_mises\"\nyield_stress = 100\nplastic_modulus = 0\n" + elastic;
    for (const auto& [name, part] : {std::pair("left", 1), {"right", 2}, {"middle", 3}}) {
      text += fmt::format("[[body]]\nname = \"{}\"\nmaterial = \"{}\"\n", name, part == 3 ? "plastic" : "elastic") +
              fmt::format("mesh = {{ type = \"keyword\", file = \"cubes.k\", part = \"{}\" }}\n", part);
    }
    text += "[[body]]\nname = \"hit\"\nmaterial = \"elastic\"\n" + hit;
    return read_scene(SceneSource{folder_ / "scene.toml", text, {}});
  }
};

TEST_F(SharedBodies, OverlapWithOthers) {
  const Scene inside =
      scene("position = [1.3, 0.3, 0.3]\nmesh = { type = \"block\", size = [0.4, 0.4, 0.4], elements = [1, 1, 1] }\n");
  const std::vector<InitialOverlap> found = find_initial_overlaps(inside, build_mesh(inside));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].first + ", " + found[0].second, "middle, hit");
  EXPECT_EQ(found[0].nodes, 8);
}

TEST_F(SharedBodies, MayBeThin) {
  const Scene above =
      scene("position = [1, 0, 1.1]\nmesh = { type = \"block\", size = [1, 1, 1], elements = [2, 2, 2] }\n");
  EXPECT_THAT(find_thin_body(above, build_mesh(above)), testing::HasSubstr("body middle has one layer"));
}

/// Whatever others say of the velocities of its nodes: all move alike.
TEST_F(SharedBodies, MayBeRigid) {
  Scene moving = scene("position = [0, 0, 5]\nmesh = { type = \"block\", size = [1, 1, 1], elements = [1, 1, 1] }\n");
  RigidBody rigid;
  rigid.name = "rigid";
  rigid.bodies = {"middle"};
  moving.rigid_bodies = {rigid};
  for (Body& body : moving.bodies) body.velocity = {1, 2, 3};
  Solver<double> solver(moving);
  for (int step = 0; step < 3; ++step) solver.step();
  EXPECT_NEAR(solver.rigid().results()[0].velocity[2], 3, 1e-9);
  EXPECT_NEAR(norm(solver.rigid().results()[0].angular_velocity), 0, 1e-9);
}

}  // namespace
}  // namespace pinball::test::shared_bodies_test
