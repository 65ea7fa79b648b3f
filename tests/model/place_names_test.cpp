#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include <solver/model/place_names.hpp>
#include <solver/step/report.hpp>
#include <tests/support/folder_case.hpp>
#include <tests/support/solver_case.hpp>

/// What elements and nodes are called in messages and warnings.
namespace pinball::place_names_test {
namespace {

using test::block;
using test::scene_of;

/// Two generated bodies with one from a file between them, whose node tags begin at 101 and whose element is 77.
class PlaceNames : public test::FolderTest {
 protected:
  Scene scene() const {
    const std::string file = (folder_ / "part.msh").string();
    std::ofstream(file) << R"($MeshFormat
2.2 0 8
$EndMeshFormat
$Nodes
8
101 0 0 0
102 1 0 0
103 1 1 0
104 0 1 0
105 0 0 1
106 1 0 1
107 1 1 1
108 0 1 1
$EndNodes
$Elements
1
77 5 2 0 1 101 102 103 104 105 106 107 108
$EndElements
)";
    Body part = block("part", {1, 1, 1}, 1, {5, 0, 0});
    FileMesh mesh;
    mesh.format = MeshFormat::gmsh;
    mesh.file = file;
    part.mesh = mesh;
    return scene_of({block("first", {2, 1, 1}, 1, {}), part, block("last", {2, 1, 1}, 1, {0, 5, 0})}, 1e-4, false);
  }
};

TEST_F(PlaceNames, AreNumbersOfTheFileElseOfTheScene) {
  const Solver<double> solver(scene());
  const ModelMesh& mesh = solver.mesh();
  EXPECT_EQ(element_name(mesh, 1), "element 1 of body first");
  EXPECT_EQ(element_name(mesh, 2), "element 77 of body part");
  EXPECT_EQ(element_name(mesh, 3), "element 3 of body last");
  EXPECT_EQ(node_name(mesh, 11), "node 11 of body first");
  EXPECT_EQ(node_name(mesh, 12), "node 101 of body part");
  EXPECT_EQ(node_name(mesh, 20), "node 20 of body last");
  const Model<double>& model = solver.model();
  EXPECT_EQ(element_name(model, model.slot_of_element[2]), "element 77 of body part");
  EXPECT_EQ(element_name(model, -1), "no element");
}

TEST_F(PlaceNames, AreTheSameInErrorsOfTheMesh) {
  Scene far = scene();
  far.bodies[2].position = {1e18, 0, 0};
  EXPECT_THAT(test::input_error_of(far), testing::HasSubstr("body last: element 3 "));
  Scene flat = scene();
  std::get<BlockMesh>(flat.bodies[2].mesh).size[1] = {1e-300};
  EXPECT_THAT(test::input_error_of(flat), testing::HasSubstr("body last: element 3 "));
}

}  // namespace
}  // namespace pinball::place_names_test
