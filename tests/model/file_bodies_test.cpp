#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include <solver/model/model.hpp>
#include <solver/model/selection/node_selection.hpp>
#include <solver/model/selection/pressed_faces.hpp>
#include <tests/support/cube_text.hpp>
#include <tests/support/error_of.hpp>
#include <tests/support/scene_fixture.hpp>
#include <tests/support/scene_text.hpp>

/// Bodies that are parts of one mesh file.
namespace pinball::test::file_bodies_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// Two unit cubes, parts 1 and 2, that share the face of nodes 50 to 80; nodes are numbered in tens, and the last four
/// are of no solid.
const std::string two_cubes = "*KEYWORD\n*NODE\n" + cube_lines(10, 10) + square_lines(90, 2, 10) + R"(*ELEMENT_SOLID
1,1,10,20,30,40,50,60,70,80
2,2,50,60,70,80,90,100,110,120
*SET_NODE_LIST_TITLE
top
7
90,100,110,120
*SET_NODE_LIST
8
10,999
*SET_SEGMENT_TITLE
lid
7
90,100,110,120
*SET_SEGMENT_TITLE
between
9
50,60,70,80
*SET_SEGMENT_TITLE
ends
11
90,100,110,120
10,20,30,40
130,140,150,160
*SET_SOLID_TITLE
second
10
2
*SET_NODE_LIST_TITLE
mixed
12
80,110,140,130
*SET_SOLID_TITLE
all
13
1,2
*NODE
)" + square_lines(130, 9, 10) +
                              "*END\n";

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

/// Whichever of the bodies is first, all has the momentum of both.
TEST_F(FileBodies, HaveTheMeanOfTheirVelocitiesByMassAtTheSharedNodes) {
  const auto momentum_with = [&](const Point& lower, const Point& upper) {
    Scene given = scene();
    given.bodies[0].velocity = lower;
    given.bodies[1].velocity = upper;
    const Model<double> model = build_model<double>(given);
    Point momentum{};
    for (std::size_t n = 0; n < model.node_mass.size(); ++n) {
      for (std::size_t k = 0; k < 3; ++k) momentum[k] += model.node_mass[n] * model.nodes.velocity_of(n)[k];
    }
    EXPECT_DOUBLE_EQ(model.nodes.velocity_of(model.node_of_scene_node[0])[0], lower[0]);
    EXPECT_DOUBLE_EQ(model.nodes.velocity_of(model.node_of_scene_node[8])[0], upper[0]);
    const double lower_mass = model.element_mass[0], upper_mass = model.element_mass[1];
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(momentum[k], lower_mass * lower[k] + upper_mass * upper[k], 1e-12 * (lower_mass + upper_mass)) << k;
    }
    return model.nodes.velocity_of(model.node_of_scene_node[4])[0];
  };
  EXPECT_NE(momentum_with({10, 0, 2}, {0, 3, 0}), 0);
  EXPECT_NE(momentum_with({0, 0, 0}, {10, 3, 0}), 0);
  EXPECT_DOUBLE_EQ(momentum_with({0.1, 0, 0}, {0.1, 0, 0}), 0.1) << "nothing differs";
  Scene given = scene();
  given.bodies[0].velocity = {10, 0, 0};
  InitialVelocity last;
  last.nodes.body = "upper";
  last.velocity = {3, 0, 0};
  last.components = {true, true, true};
  given.initial_velocities = {last};
  const Model<double> model = build_model<double>(given);
  EXPECT_DOUBLE_EQ(model.nodes.velocity_of(model.node_of_scene_node[4])[0], 3) << "[[initial_velocity]] counts";
}

TEST_F(FileBodies, HaveTheMassOfBothAtTheSharedNodes) {
  const Model<double> model = build_model<double>(scene());
  EXPECT_DOUBLE_EQ(model.node_mass[model.node_of_scene_node[4]], 2 * model.node_mass[model.node_of_scene_node[0]]);
}

/// A plane of symmetry that is a set holds each node of it along its normal.
TEST_F(FileBodies, EveryNodeOfASetOfSymmetryIsHeld) {
  const Model<double> model = build_model<double>(
      scene("part = \"2\"", {"[[constraint]]", "type = \"symmetry\"", "set = \"top\"", "normal = [0, 0, 1]"}));
  std::vector<std::int32_t> held, expected;
  for (const std::int32_t n : {8, 9, 10, 11}) expected.push_back(model.node_of_scene_node[n]);
  for (const auto& constraint : model.constraints) {
    held.push_back(constraint.node);
    EXPECT_EQ(constraint.normal[2], 1);
  }
  EXPECT_THAT(held, testing::UnorderedElementsAreArray(expected));
}

TEST_F(FileBodies, AnElementBelongsToOneBodyAlone) {
  EXPECT_THAT(error_of([&] { build_mesh(scene("scale = 1")); }), HasSubstr("body upper: element 1 (line 16 of"));
}

TEST_F(FileBodies, NodesAreChosenBySetsAndNumbersOfTheFile) {
  const ModelMesh mesh = build_mesh(scene());
  EXPECT_EQ(select_nodes(mesh, selection("top")), (std::vector<std::int32_t>{8, 9, 10, 11}));
  EXPECT_EQ(select_nodes(mesh, selection("7")), (std::vector<std::int32_t>{8, 9, 10, 11}));
  EXPECT_EQ(select_nodes(mesh, selection("", {120, 10, 10})), (std::vector<std::int32_t>{0, 11}));
  EXPECT_EQ(select_nodes(mesh, selection("top", {120, 10})), (std::vector<std::int32_t>{11}));
}

/// A set of nodes comes before one of faces, and that before one of elements; parts come last.
TEST_F(FileBodies, NodesAreThoseOfFacesElementsAndPartsToo) {
  const ModelMesh mesh = build_mesh(scene());
  EXPECT_EQ(select_nodes(mesh, selection("lid")), (std::vector<std::int32_t>{8, 9, 10, 11}));
  EXPECT_EQ(select_nodes(mesh, selection("second")), (std::vector<std::int32_t>{4, 5, 6, 7, 8, 9, 10, 11}));
  EXPECT_EQ(select_nodes(mesh, selection("1")), (std::vector<std::int32_t>{0, 1, 2, 3, 4, 5, 6, 7}));
  NodeSelection without = selection("second");
  without.without = "lid";
  EXPECT_EQ(select_nodes(mesh, without), (std::vector<std::int32_t>{4, 5, 6, 7}));
}

TEST_F(FileBodies, FacesArePressedBySetsAndNumbersOfTheFile) {
  const ModelMesh mesh = build_mesh(scene());
  const auto faces = [&](const NodeSelection& nodes, const std::vector<std::array<std::int64_t, 4>>& corners = {}) {
    Pressure pressure;
    pressure.faces = nodes;
    pressure.corners = corners;
    return pressed_faces(mesh, {}, pressure);
  };
  const auto lid = faces(selection("lid"));
  ASSERT_EQ(lid.size(), 1u);
  EXPECT_EQ(lid[0].element, 1);
  EXPECT_EQ(lid[0].corners, (std::array<std::int32_t, 4>{8, 9, 10, 11}));
  EXPECT_EQ(faces(selection("7")).size(), 1u) << "of faces rather than of nodes";
  EXPECT_EQ(faces(selection("second")).size(), 5u) << "what is exposed of an element";
  EXPECT_EQ(faces(selection(""), {{110, 70, 60, 100}, {120, 110, 100, 90}}).size(), 2u) << "either way round";
  EXPECT_THAT(error_of([&] { faces(selection("between")); }),
              HasSubstr("here: the face with the corners (0, 0, 1) (1, 0, 1) (1, 1, 1) (0, 1, 1) lies between two"));
  EXPECT_THAT(error_of([&] { faces(selection(""), {{10, 20, 90, 100}}); }), HasSubstr("is one of no hexahedron"));
}

/// Those of part 2, which is in no body, and those with nodes that no solid has.
TEST_F(FileBodies, FacesOfASetThatNoBodyHasAreTold) {
  const auto told = [&](const std::string& lines, const std::string& mesh) {
    return build_model<double>(read(with(14, mesh + "\n" + lines))).mesh.warnings;
  };
  const std::string lower = R"(mesh = { type = "keyword", file = "cubes.k", part = "1" })",
                    both = R"(mesh = { type = "keyword", file = "cubes.k" })";
  const std::string pressure = "[[pressure]]\npressure = 1\nset = \"ends\"",
                    pair = "[contact]\nmethod = \"pinball\"\n[[contact.pair]]\nfirst = { faces = \"11\" }",
                    tied = "[[contact.tied]]\nfirst = \"bar\"\nsecond = { faces = \"ends\" }";
  EXPECT_THAT(told(pressure, lower), ElementsAre(HasSubstr("2 of the 3 faces of the set ends are of no body")));
  EXPECT_THAT(told(pressure, both), ElementsAre(HasSubstr("1 of the 3 faces of the set ends is of no body")));
  EXPECT_THAT(told(pair, lower), ElementsAre(HasSubstr("contact.pair.0.first: 2 of the 3 faces of the set 11")));
  EXPECT_THAT(told(tied, lower), ElementsAre(HasSubstr("contact.tied.0.second: 2 of the 3 faces of the set ends")));
  EXPECT_THAT(told("[[pressure]]\npressure = 1\nset = \"lid\"", both), IsEmpty());
}

/// Sets of nodes and elements, too, wherever something acts on nodes; by numbers of the file.
TEST_F(FileBodies, NodesOfASetThatNoBodyHasAreTold) {
  const std::string lower = R"(mesh = { type = "keyword", file = "cubes.k", part = "1" })",
                    both = R"(mesh = { type = "keyword", file = "cubes.k" })";
  const auto told = [&](const std::string& lines, const std::string& mesh) {
    return build_model<double>(read(with(14, mesh + "\n" + lines))).mesh.warnings;
  };
  const std::string fixed = "[[constraint]]\ntype = \"fixed\"\ndirections = [\"z\"]\nset = ";
  EXPECT_THAT(
      told(fixed + "\"mixed\"", both),
      ElementsAre(HasSubstr("2 of the 4 nodes of the set mixed are of no body and left out, the first is node 130")));
  EXPECT_THAT(
      told(fixed + "\"12\"", lower),
      ElementsAre(HasSubstr("3 of the 4 nodes of the set 12 are of no body and left out, the first is node 110")));
  EXPECT_THAT(
      told(fixed + "\"all\"", lower),
      ElementsAre(HasSubstr("1 of the 2 elements of the set all is of no body and left out, the first is element 2")));
  EXPECT_THAT(told("[[load]]\nforce = [1, 0, 0]\nset = \"ends\"", both),
              ElementsAre(HasSubstr("1 of the 3 faces of the set ends is of no body and left out")));
  EXPECT_THAT(told("[[initial_velocity]]\nvelocity = [1, 0, 0]\nset = \"mixed\"", both), SizeIs(1));
  EXPECT_THAT(told("[[contact.tied]]\nfirst = { nodes = \"mixed\" }\nsecond = \"bar\"", both),
              ElementsAre(HasSubstr("contact.tied.0.first: 2 of the 4 nodes of the set mixed")));
  EXPECT_THAT(told(fixed + "\"top\"", both), IsEmpty());
  EXPECT_THAT(told("", lower), IsEmpty()) << "nothing names the sets";
}

/// What a reader drops since no element uses it: the end of the left part, of which no body is.
TEST_F(FileBodies, NodesOfASetThatAReaderDropsAreTold) {
  std::ostringstream mesh;
  mesh << std::ifstream(PINBALL_SOURCE_DIR "/tests/data/two_volumes_22.msh").rdbuf();
  std::ofstream(folder_ / "part.msh") << replaced(mesh.str(), "1 5 8 4\n", "1 90 110 4\n");
  const auto right = R"(mesh = { type = "gmsh", file = "part.msh", physical = "right" }
[[constraint]]
type = "fixed"
directions = ["x"]
set = "clamped end")";
  EXPECT_THAT(build_model<double>(read(with(14, right))).mesh.warnings,
              ElementsAre(HasSubstr("2 of the 4 nodes of the set clamped end are of no body and left out, the first is "
                                    "node 1")));
}

TEST_F(FileBodies, ASetWithoutANodeOfABodyIsAnError) {
  const std::string lower = R"(mesh = { type = "keyword", file = "cubes.k", part = "1" })";
  for (const std::string acting :
       {"[[constraint]]\ntype = \"symmetry\"\nnormal = [0, 0, 1]\npoint = [0, 0, 0]",
        "[[constraint]]\ntype = \"fixed\"\ndirections = [\"z\"]", "[[initial_velocity]]\nvelocity = [1, 0, 0]"}) {
    const std::string lines = lower + "\n" + acting + "\nset = \"top\"";
    EXPECT_THAT(error_of([&] { build_model<double>(read(with(14, lines))); }),
                HasSubstr("expected at least one node, there is none"))
        << acting;
  }
}

TEST_F(FileBodies, WhatIsNotInTheFileIsNamed) {
  const ModelMesh mesh = build_mesh(scene());
  EXPECT_THAT(error_of([&] { select_nodes(mesh, selection("tip")); }),
              HasSubstr("has no set of nodes, faces or elements, and no part, \"tip\", nearest is \"top\""));
  EXPECT_THAT(error_of([&] { select_nodes(mesh, selection("", {15})); }), HasSubstr("has no node 15"));
  EXPECT_THAT(error_of([&] { select_nodes(mesh, selection("8")); }),
              HasSubstr("cubes.k:24: *SET_NODE_LIST: node 999 is not there"));
  EXPECT_THAT(error_of([&] { build_mesh(scene("part = \"upper\"")); }), HasSubstr("no part or set of elements"));
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

/// Two bodies of a file, of parts by these names.
std::vector<std::string> two_bodies(const std::string& file, const std::string& first, const std::string& second) {
  std::vector<std::string> lines = minimal;
  lines.at(13) = fmt::format(R"(mesh = {{ type = "file", file = "{}", part = "{}" }})", file, first);
  for (const std::string& line :
       {std::string("[[body]]"), std::string("name = \"right\""), std::string("material = \"copper\""),
        fmt::format(R"(mesh = {{ type = "file", file = "{}", part = "{}" }})", file, second)}) {
    lines.push_back(line);
  }
  return lines;
}

TEST_F(FileBodies, OfEveryFormatAreJoined) {
  const std::string data = PINBALL_SOURCE_DIR "/tests/data/";
  struct Case {
    std::string file, first, second;
    std::size_t nodes, shared;
  };
  for (const Case& c :
       {Case{data + "two_volumes_22.msh", "left part", "right", 16, 4},
        Case{data + "two_volumes_41.msh", "1", "2", 16, 4}, Case{data + "exodus/two_blocks.g", "left", "20", 14, 4},
        Case{data + "exodus/two_blocks_hdf5.g", "10", "right", 14, 4},
        Case{data + "vtk/grid_raw_zlib.vtu", "3", "4", 14, 4}, Case{data + "vtk/grid_binary.vtk", "3", "4", 14, 4}}) {
    SCOPED_TRACE(c.file);
    const ModelMesh mesh = build_mesh(read(two_bodies(c.file, c.first, c.second)));
    EXPECT_EQ(mesh.nodes.size(), c.nodes);
    EXPECT_EQ(mesh.shared[1].size(), c.shared);
  }
}

TEST_F(FileBodies, AreOfFilesWhoseEndingsAreKnown) {
  std::ofstream(folder_ / "mesh.stl") << "solid";
  const std::string message = error(with(14, R"(mesh = { type = "file", file = "mesh.stl" })"));
  EXPECT_THAT(message,
              HasSubstr("body.bar.mesh.file: expected a file that ends in .msh, .k, .key, .dyn, .g, .e, .exo"));
  EXPECT_THAT(error(with(14, R"(mesh = { type = "file", file = "cubes.k", array = "material" })")),
              HasSubstr("body.bar.mesh.array: is for files of VTK alone"));
}

}  // namespace
}  // namespace pinball::test::file_bodies_test
