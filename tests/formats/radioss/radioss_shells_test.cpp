#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <solver/formats/mesh_reader.hpp>

#include "radioss_case.hpp"

/// Shells of Radioss input that do not deform are layers of solids.
namespace pinball::test::radioss_shells_test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string held = "/GRNOD/PART/9\nplate\n" + ten({"3"}) + "/BCS/9\nb\n   111 111         0         9\n",
                  quadrilaterals =
                      "/SHELL/3\n" + ten({"31", "21", "22", "23", "24"}) + ten({"32", "22", "25", "26", "23"});

class RadiossShells : public RadiossTest {
 protected:
  /// A cube, and below it two squares side by side, 0.2 thick, at a height of -0.5.
  static std::string plate(const std::string& more, const std::string& shells = quadrilaterals,
                           const std::string& thickness = "") {
    return radioss_begin + radioss_steel + radioss_property + radioss_cube + "/NODE\n" + square_nodes(21, -0.5) +
           fmt::format("{:>10}{:>20}{:>20}{:>20}\n", 25, 2, 0, -0.5) +
           fmt::format("{:>10}{:>20}{:>20}{:>20}\n", 26, 2, 1, -0.5) +
           fmt::format("{:>10}{:>20}{:>20}{:>20}\n", 90, 1, 0.5, -0.5) + "/PART/3\nplate\n" + ten({"3", "1", "0"}) +
           "/PROP/TYPE1/3\nplate\n\n\n" + fmt::format("{:>40}\n", thickness) + more + shells;
  }
  MeshFile mesh(const std::string& text) {
    translate(text);
    FileMesh settings;
    settings.file = path_;
    settings.format = MeshFormat::radioss;
    return read_mesh_file(settings, {});
  }
  static std::string thick(const std::string& more, const std::string& shells = quadrilaterals) {
    return plate(more, shells, "0.2");
  }
};

TEST_F(RadiossShells, ThatAreHeldAreRigidBodies) {
  const Scene made = scene(thick(held));
  ASSERT_EQ(made.bodies.size(), 2U);
  EXPECT_EQ(made.bodies[1].name, "plate");
  ASSERT_EQ(made.rigid_bodies.size(), 1U);
  EXPECT_EQ(made.rigid_bodies[0].bodies, std::vector<std::string>{"plate"});
  EXPECT_EQ(made.rigid_bodies[0].held.size(), 3U);
  EXPECT_EQ(made.rigid_bodies[0].held_rotations.size(), 3U);
  EXPECT_TRUE(made.fixed_constraints.empty());
  EXPECT_THAT(translate(thick(held)).understood,
              Contains(HasSubstr("body plate of 2 solids, layers in the place of shells")));
  const MeshFile file = mesh(thick(held));
  ASSERT_EQ(file.mesh.hexahedra.size(), 3U);
  for (const std::size_t e : {1, 2}) {
    for (const std::int32_t node : file.mesh.hexahedra[e])
      EXPECT_NEAR(std::abs(file.mesh.nodes[node][2] + 0.5), 0.1, 1e-15);
  }
}

TEST_F(RadiossShells, OfARigidBodyHaveItsMainNode) {
  const Scene made =
      scene(thick("/GRNOD/PART/9\nplate\n" + ten({"3"}) + "/GRNOD/NODE/8\nmain\n" + ten({"90"}) + "/RBODY/1\nr\n" +
                  ten({"90", "0", "0", "0", "-", "-", "9"}) + "/BCS/9\nb\n   110 111         0         8\n"));
  ASSERT_EQ(made.rigid_bodies.size(), 1U);
  EXPECT_EQ(made.rigid_bodies[0].name, "rbody_1");
  EXPECT_EQ(made.rigid_bodies[0].bodies, std::vector<std::string>{"plate"});
  EXPECT_EQ(made.rigid_bodies[0].held.size(), 2U);
}

TEST_F(RadiossShells, OfARigidMaterialAreRigidBodies) {
  std::string text = thick("/MAT/RIGID/2\nr\n" + twenty({7.85e-9, 0}) + twenty({210000, 0.3}));
  const std::string part = "/PART/3\nplate\n" + ten({"3", "1", "0"});
  text.replace(text.find(part), part.size(), "/PART/3\nplate\n" + ten({"3", "2", "0"}));
  const Scene made = scene(text);
  ASSERT_EQ(made.rigid_bodies.size(), 1U);
  EXPECT_TRUE(made.rigid_bodies[0].held.empty());
}

TEST_F(RadiossShells, ThatDeformAreRefused) {
  EXPECT_THAT(error(thick("")), HasSubstr("/SHELL of a part that deforms"));
  EXPECT_THAT(error(thick("/GRNOD/PART/9\nplate\n" + ten({"3"}) + "/BCS/9\nb\n   110 111         0         9\n")),
              HasSubstr("/SHELL of a part that deforms"));
  EXPECT_THAT(error(thick("/GRNOD/NODE/9\nsome\n" + ten({"21", "22", "23", "24"}) +
                          "/BCS/9\nb\n   111 111         0         9\n")),
              HasSubstr("/SHELL of a part that deforms"));
  EXPECT_THAT(error(plate(held)), HasSubstr("shell 31 has no thickness"));
  EXPECT_THAT(error(thick(held, "/SHELL/3\n" + ten({"31", "21", "22", "23", "77"}))),
              HasSubstr("/SHELL: shell 31 has node 77, which is not there"));
  EXPECT_THAT(error(thick(held, "/SHELL/3\n" + ten({"31", "21", "22", "22", "21"}))),
              HasSubstr("shell 31 has two nodes or less"));
}

TEST_F(RadiossShells, HaveThicknessesOfTheirOwn) {
  const std::string own = ten({"31", "21", "22", "23"});
  const MeshFile file = mesh(thick(held, "/SH3N/3\n" + own.substr(0, own.size() - 1) + std::string(40, ' ') +
                                             "                 0.4\n" + ten({"32", "21", "23", "24"})));
  ASSERT_EQ(file.mesh.hexahedra.size(), 3U);
  std::vector<double> heights;
  for (const std::int32_t node : file.mesh.hexahedra[1]) heights.push_back(file.mesh.nodes[node][2]);
  EXPECT_THAT(heights, Contains(testing::DoubleNear(-0.3, 1e-12))) << "of its own corner";
  EXPECT_THAT(heights, Contains(testing::DoubleNear(-0.35, 1e-12))) << "of the common edge, the mean";
}

TEST_F(RadiossShells, AreHeldBesideSolids) {
  const Scene made =
      scene(thick("/GRNOD/PART/9\nplate\n" + ten({"3"}) + "/GRNOD/NODE/8\nbase\n" + ten({"1", "2", "3", "4"}) +
                  "/GRNOD/GRNOD/7\nboth\n" + ten({"8", "9"}) + "/BCS/9\nb\n   111 111         0         7\n"));
  ASSERT_EQ(made.rigid_bodies.size(), 1U);
  ASSERT_EQ(made.fixed_constraints.size(), 1U);
  EXPECT_THAT(made.fixed_constraints[0].nodes.nodes, ElementsAre(1, 2, 3, 4));
}

TEST_F(RadiossShells, TouchWithBothFaces) {
  for (const char* surface : {"EXT", "ALL"}) {
    const std::string start = std::string("/SURF/PART/") + surface + "/";
    const Scene made = scene(thick(held + start + "6\ncube\n" + ten({"1"}) + start + "7\nplate\n" + ten({"3"}) +
                                   "/INTER/TYPE25/1\ni\n" + ten({"6", "7"}) + "\n\n\n\n\n"));
    ASSERT_EQ(made.contact_pairs.size(), 1U) << surface;
    EXPECT_THAT(made.contact_pairs[0].first.bodies, ElementsAre("cube"));
    EXPECT_THAT(made.contact_pairs[0].second.bodies, ElementsAre("plate")) << "as a whole";
    EXPECT_EQ(mesh(thick(held + start + "7\nplate\n" + ten({"3"}))).face_sets.at(0).faces.size(), 4U);
  }
}

}  // namespace
}  // namespace pinball::test::radioss_shells_test
