#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include <solver/model/model.hpp>
#include <solver/model/node_selection.hpp>
#include <tests/support/scene_fixture.hpp>

/// Bodies that are parts of one mesh file.
namespace pinball::test {
namespace {

using testing::HasSubstr;

/// Two unit cubes, parts 1 and 2, that share the face of nodes 5 to 8; nodes are numbered in tens.
const char* const two_cubes = R"(*KEYWORD
*NODE
10,0,0,0
20,1,0,0
30,1,1,0
40,0,1,0
50,0,0,1
60,1,0,1
70,1,1,1
80,0,1,1
90,0,0,2
100,1,0,2
110,1,1,2
120,0,1,2
*ELEMENT_SOLID
1,1,10,20,30,40,50,60,70,80
2,2,50,60,70,80,90,100,110,120
*SET_NODE_LIST_TITLE
top
7
90,100,110,120
*SET_NODE_LIST
8
10,999
*END
)";

class FileBodies : public SceneTest {
 protected:
  void SetUp() override {
    SceneTest::SetUp();
    std::ofstream(folder_ / "cubes.k") << two_cubes;
  }
  Scene scene(const std::string& second = "part = \"2\"", const std::vector<std::string>& more = {}) {
    std::vector<std::string> lines = with(14, "mesh = { type = \"keyword\", file = \"cubes.k\", part = \"1\" }");
    for (const std::string& line :
         {std::string("[[body]]"), std::string("name = \"upper\""), std::string("material = \"copper\""),
          "mesh = { type = \"keyword\", file = \"cubes.k\", " + second + " }"}) {
      lines.push_back(line);
    }
    lines.insert(lines.end(), more.begin(), more.end());
    return read(lines);
  }
  std::string build_error(const std::function<void()>& act) {
    try {
      act();
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }
  static NodeSelection selection(const std::string& set, const std::vector<std::int64_t>& nodes = {}) {
    NodeSelection s;
    s.where = "here";
    s.set = set;
    s.nodes = nodes;
    return s;
  }
};

TEST_F(FileBodies, ShareTheNodesOfTheirCommonFace) {
  const ModelMesh mesh = build_mesh(scene());
  EXPECT_EQ(mesh.nodes.size(), 12u);
  EXPECT_EQ(mesh.hexahedra.size(), 2u);
  EXPECT_EQ(mesh.shared[1], (std::vector<std::int32_t>{4, 5, 6, 7}));
  NodeSelection upper;
  upper.body = "upper";
  EXPECT_EQ(select_nodes(mesh, upper).size(), 8u) << "its own nodes and those that it shares";
}

TEST_F(FileBodies, AreApartWhereTheyAreMovedApart) {
  Scene moved = scene();
  moved.bodies[1].position = {0, 0, 1};
  EXPECT_EQ(build_mesh(moved).nodes.size(), 16u);
}

TEST_F(FileBodies, HaveTheMassOfBothAtTheSharedNodes) {
  const Model<double> model = build_model<double>(scene());
  EXPECT_DOUBLE_EQ(model.node_mass[model.node_of_scene_node[4]], 2 * model.node_mass[model.node_of_scene_node[0]]);
}

TEST_F(FileBodies, AnElementBelongsToOneBodyAlone) {
  EXPECT_THAT(build_error([&] { build_mesh(scene("scale = 1")); }), HasSubstr("body upper: element 1 (line 16 of"));
}

TEST_F(FileBodies, NodesAreChosenBySetsAndNumbersOfTheFile) {
  const ModelMesh mesh = build_mesh(scene());
  EXPECT_EQ(select_nodes(mesh, selection("top")), (std::vector<std::int32_t>{8, 9, 10, 11}));
  EXPECT_EQ(select_nodes(mesh, selection("7")), (std::vector<std::int32_t>{8, 9, 10, 11}));
  EXPECT_EQ(select_nodes(mesh, selection("", {120, 10, 10})), (std::vector<std::int32_t>{0, 11}));
  EXPECT_EQ(select_nodes(mesh, selection("top", {120, 10})), (std::vector<std::int32_t>{11}));
}

TEST_F(FileBodies, WhatIsNotInTheFileIsNamed) {
  const ModelMesh mesh = build_mesh(scene());
  EXPECT_THAT(build_error([&] { select_nodes(mesh, selection("tip")); }),
              HasSubstr("has no set of nodes \"tip\", nearest is \"top\""));
  EXPECT_THAT(build_error([&] { select_nodes(mesh, selection("", {15})); }), HasSubstr("has no node 15"));
  EXPECT_THAT(build_error([&] { select_nodes(mesh, selection("8")); }),
              HasSubstr("cubes.k:24: *SET_NODE_LIST: node 999 is not there"));
  EXPECT_THAT(build_error([&] { build_mesh(scene("part = \"upper\"")); }), HasSubstr("no part or set of elements"));
}

TEST_F(FileBodies, AreSelectedInAScene) {
  const Scene held =
      scene("part = \"2\"", {"[[constraint]]", "type = \"fixed\"", "directions = [\"z\"]", "set = \"top\"",
                             "[[initial_velocity]]", "nodes = [10, 20]", "velocity = [1, 0, 0]"});
  const Model<double> model = build_model<double>(held);
  EXPECT_EQ(model.constraints.size(), 4u);
  EXPECT_EQ(model.nodes.velocity_of(model.node_of_scene_node[0])[0], 1);
}

/// Today's volumes of one Gmsh file were torn apart at their common face.
TEST_F(FileBodies, OfAGmshFileAreJoinedToo) {
  std::filesystem::copy(PINBALL_SOURCE_DIR "/tests/data/two_volumes_41.msh", folder_ / "part.msh");
  std::vector<std::string> lines = with(14, R"(mesh = { type = "gmsh", file = "part.msh", physical = "left part" })");
  for (const char* line : {"[[body]]", "name = \"right\"", "material = \"copper\"",
                           R"(mesh = { type = "gmsh", file = "part.msh", physical = "right" })"}) {
    lines.emplace_back(line);
  }
  EXPECT_EQ(build_mesh(read(lines)).nodes.size(), 16u);
}

}  // namespace
}  // namespace pinball::test
