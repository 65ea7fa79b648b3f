#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <solver/model/selection/named_nodes.hpp>
#include <solver/model/selection/near_nodes.hpp>
#include <solver/model/selection/node_selection.hpp>
#include <solver/results/warnings.hpp>
#include <tests/support/solver_case.hpp>

/// Selections of meshes whose places are rounded.
namespace pinball::test::node_selection_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

NodeSelection plane_x(double x) {
  NodeSelection nodes;
  nodes.where = "here";
  nodes.plane = Plane{{x, 0, 0}, {1, 0, 0}};
  return nodes;
}

/// A block of 20 x 4 x 4 elements of 0.1 whose corner lies at x = 7, and on which a scene asks for planes.
Scene block_scene() {
  Scene scene = scene_of({block("a", {20, 4, 4}, 0.1, {7, 0, 0})}, 1e-4, false);
  scene.constraints = {{{7, 0, 0}, {1, 0, 0}, ""}};
  return scene;
}

/// Every node of a plane to and fro by so much.
ModelMesh rounded(double by) {
  ModelMesh mesh = build_mesh(block_scene());
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) mesh.nodes[n][0] += n % 2 == 0 ? by : -by;
  return mesh;
}

TEST(NodeSelection, TakesAPlaneWholeWhoseNodesAFileHasRounded) {
  for (const double digits : {1e-6, 1e-7}) {
    const SelectedNodes found = selected_nodes(rounded(digits * 9), plane_x(7));
    EXPECT_EQ(found.nodes.size(), 25u) << digits;
    EXPECT_EQ(found.near, 0);
  }
}

TEST(NodeSelection, CountsWhatLiesNearAndIsNotTaken) {
  const SelectedNodes found = selected_nodes(rounded(5e-3), plane_x(7));
  EXPECT_THAT(found.nodes, IsEmpty());
  EXPECT_EQ(found.near, 25);
  EXPECT_EQ(selected_nodes(rounded(0.04), plane_x(7)).near, 0) << "a mesh that is meant so";
}

TEST(NodeSelection, HasTheToleranceThatIsGiven) {
  NodeSelection wide = plane_x(7);
  wide.tolerance = 0.006;
  EXPECT_EQ(selected_nodes(rounded(5e-3), wide).nodes.size(), 25u);
  wide.tolerance = 1e-6;
  EXPECT_THAT(selected_nodes(rounded(1e-5), wide).nodes, IsEmpty());
}

/// Small elements in a large mesh are told apart, whatever digits its places have.
TEST(NodeSelection, GoesByTheElementsAtEachNode) {
  Scene scene = block_scene();
  scene.bodies.push_back(block("fine", {2, 2, 2}, 1e-4, {7 - 2e-4, 1, 1}));
  const ModelMesh mesh = build_mesh(scene);
  NodeSelection fine = plane_x(7);
  fine.body = "fine";
  EXPECT_EQ(selected_nodes(mesh, fine).nodes.size(), 9u);
}

TEST(NodeSelection, OfBoxesAndLinesIsRoundedToo) {
  NodeSelection box, line;
  box.box = Box{{7, 0, 0}, {7, 0.4, 0.4}};
  line.line = Line{{7, 0.1, 5}, {0, 0, 1}};
  EXPECT_EQ(selected_nodes(rounded(9e-6), box).nodes.size(), 25u);
  EXPECT_EQ(selected_nodes(rounded(9e-6), line).nodes.size(), 5u);
}

TEST(NodeSelection, ThatIsNearlyMissedIsToldAtTheStart) {
  Scene scene = block_scene();
  scene.constraints[0].point = {6.995, 0, 0};
  scene.constraints[0].where = "scene.toml:7:1: constraint.0";
  EXPECT_THAT(find_near_nodes(scene, build_mesh(scene)),
              ElementsAre("scene.toml:7:1: constraint.0: 25 nodes within a tenth of an element of those on the plane "
                          "through (6.995, 0, 0) with normal (1, 0, 0) are not taken, 0 are: give a tolerance if they "
                          "are meant"));
  Solver<double> solver(scene);
  RunSummary summary;
  fill_summary(solver, summary);
  EXPECT_THAT(start_warnings(summary), ElementsAre(HasSubstr("25 nodes within a tenth")));
  EXPECT_THAT(find_near_nodes(block_scene(), build_mesh(block_scene())), IsEmpty());
}

/// Also where nothing else of the scene asks where nodes lie.
TEST(NodeSelection, OfRigidNodesIsRoundedAsAllOthers) {
  Scene scene = scene_of({block("a", {2, 2, 2}, 1, {0, 0, 0})}, 1e-4, false);
  AttachedNodes& end = scene.attached_nodes.emplace_back();
  end.nodes = plane_x(2 + 9e-4);
  EXPECT_EQ(select_nodes(build_mesh(scene), end.nodes).size(), 9u);
  EXPECT_THAT(find_near_nodes(scene, build_mesh(scene)), IsEmpty());
  end.nodes = plane_x(2.05);
  EXPECT_THAT(find_near_nodes(scene, build_mesh(scene)), ElementsAre(HasSubstr("9 nodes within a tenth")));
}

TEST(NodeSelection, ThatIsFarFromAllNodesIsToldAtTheStart) {
  Scene scene = block_scene();
  scene.constraints[0].point = {70, 0, 0};
  scene.constraints[0].where = "scene.toml:7:1: constraint.0";
  EXPECT_THAT(find_near_nodes(scene, build_mesh(scene)),
              ElementsAre("scene.toml:7:1: constraint.0: there is no node on the plane through (70, 0, 0) with normal "
                          "(1, 0, 0)"));
  scene = block_scene();
  NodalLoad load;
  load.nodes.nearest = Point{70, 0, 0};
  scene.loads = {load};
  EXPECT_THAT(find_near_nodes(scene, build_mesh(scene)), ElementsAre(HasSubstr("(70, 0, 0) lies ")));
}

/// Faces on a rounded plane of symmetry are none that contact could touch.
TEST(NodeSelection, OfASymmetryPlaneHidesTheFacesInIt) {
  Scene scene = block_scene();
  scene.contact.method = ContactMethod::pinball;
  const auto surface = [&] { return Solver<double>(scene).contact()->surface_elements(); };
  const std::int32_t exact = surface();
  scene.constraints[0].point = {7.00002, 0, 0};
  EXPECT_EQ(surface(), exact);
}

/// Sets and numbers are those of one file, which has to be named where there are several.
TEST(NodeSelection, TakesNamesOfAFileThatIsNamedOrTheOnlyOne) {
  ModelMesh mesh;
  const auto error = [&](const char* name) { return error_of([&] { file_of(mesh, name, "here"); }); };
  EXPECT_THAT(error(""),
              HasSubstr("here: sets and numbers of nodes are those of a mesh file, and no body is from one"));
  mesh.files.resize(1);
  mesh.files[0].path = "meshes/rod.k";
  EXPECT_EQ(&file_of(mesh, "", "here"), mesh.files.data());
  mesh.files.resize(2);
  mesh.files[1].path = "meshes/plate.k";
  EXPECT_THAT(error(""), HasSubstr("here: expected file, the mesh file that the set or the numbers are of"));
  EXPECT_EQ(&file_of(mesh, "plate.k", "here"), &mesh.files[1]);
  EXPECT_EQ(&file_of(mesh, "rod.k", "here"), mesh.files.data());
  EXPECT_THAT(error("plat.k"), HasSubstr("no body is from a mesh file plat.k, nearest is meshes/plate.k"));
}

}  // namespace
}  // namespace pinball::test::node_selection_test
