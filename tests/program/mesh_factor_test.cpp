#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <solver/program/study/mesh_factor.hpp>
#include <tests/support/error_of.hpp>

namespace pinball::mesh_factor_test {
namespace {

using test::error_of;
using test::no_error;
using testing::ElementsAre;
using testing::HasSubstr;

Scene scene_of(const MeshSettings& mesh) {
  Scene scene;
  scene.bodies.resize(1);
  scene.bodies[0].name = "body";
  scene.bodies[0].mesh = mesh;
  return scene;
}

template <class Mesh>
Mesh refined(const Mesh& mesh, MeshFactor factor) {
  return std::get<Mesh>(refined_by(scene_of(mesh), factor).bodies[0].mesh);
}

std::string problem_of_refining(const MeshSettings& mesh, MeshFactor factor) {
  return error_of([&] { refined_by(scene_of(mesh), factor); });
}

TEST(MeshFactor, AreFractionsFromCoarseToFine) {
  EXPECT_THAT(parse_mesh_factors("2,1,1/2"), ElementsAre(MeshFactor{1, 2}, MeshFactor{1, 1}, MeshFactor{2, 1}));
  EXPECT_THAT(parse_mesh_factors("1,6/4,2,3"),
              ElementsAre(MeshFactor{1, 1}, MeshFactor{3, 2}, MeshFactor{2, 1}, MeshFactor{3, 1}));
  EXPECT_EQ((MeshFactor{3, 2}.text()), "3/2");
  EXPECT_EQ((MeshFactor{2, 1}.text()), "2");
  for (const char* text : {"", "1,2", "1,2,2", "1,2,2/1", "1,2,x", "1,2,", ",1,2,3", "0,1,2", "-1,1,2", "1/0,1,2",
                           "1.5,1,2", "1/2/3,1,2", "1,2,1001", "1, 2,3"}) {
    EXPECT_THROW(parse_mesh_factors(text), InputError) << text;
  }
}

TEST(MeshFactor, MultipliesAllThatRefineDoes) {
  const BlockMesh block{{1, 1, 1}, {4, 6, 2}, {}};
  EXPECT_THAT(refined(block, {3, 2}).elements, ElementsAre(6, 9, 3));
  BlockMesh sections = block;
  sections.sections[1] = {{0.5, 2}, {0.5, 4}};
  const BlockMesh finer = refined(sections, {3, 2});
  EXPECT_THAT(finer.elements, ElementsAre(6, 9, 3));
  EXPECT_EQ(finer.sections[1][0].elements, 3);
  EXPECT_EQ(finer.sections[1][1].elements, 6);
  EXPECT_EQ(finer.sections[1][1].length, 0.5);

  const RoundNosedRodMesh rod = refined(RoundNosedRodMesh{4, 1, true, {2, 4}, 2, 10}, {1, 2});
  EXPECT_THAT(rod.core, ElementsAre(1, 2));
  EXPECT_EQ(rod.ring, 1);
  EXPECT_EQ(rod.layers, 5);

  const CylinderMesh cylinder = refined(CylinderMesh{1, 4, Section::full, 0, 2, 4, 1, 6}, {3, 2});
  EXPECT_EQ(cylinder.core, 3);
  EXPECT_EQ(cylinder.ring, 6);
  EXPECT_EQ(cylinder.layers, 9);
  EXPECT_EQ(cylinder.radial, 1);  // of a wedge alone
  const CylinderMesh wedge = refined(CylinderMesh{1, 4, Section::wedge, 10, 1, 1, 4, 6}, {1, 2});
  EXPECT_EQ(wedge.radial, 2);
  EXPECT_EQ(wedge.core, 1);
  EXPECT_EQ(wedge.ring, 1);

  const SphereMesh sphere = refined(SphereMesh{1, Section::full, 0, {4, 4}, 2, 1}, {3, 2});
  EXPECT_THAT(sphere.core, ElementsAre(6, 6));
  EXPECT_EQ(sphere.ring, 3);
  EXPECT_THAT(refined(SphereMesh{1, Section::wedge, 10, {2, 4}, 2, 1}, {1, 2}).core, ElementsAre(1, 2));
}

/// What the reader of scenes makes of --refine 2 is the factor 2.
TEST(MeshFactor, AgreesWithRefine) {
  for (const char* name : {"taylor_bar", "rod_plate", "sphere_floor", "refined_layer"}) {
    const std::string path = find_scene(name);
    SceneOverrides twice;
    twice.refine = 2;
    EXPECT_EQ(element_counts(refined_by(read_scene(path), {2, 1})), element_counts(read_scene(path, twice))) << name;
  }
  EXPECT_EQ(element_counts(read_scene(find_scene("taylor_bar"))), "bar: core 8, ring 4, layers 80");
  EXPECT_EQ(element_counts(read_scene(find_scene("two_bars"))), "bar1: elements 10 x 1 x 1; bar2: elements 10 x 1 x 1");
}

TEST(MeshFactor, NamesWhatItDoesNotLeaveWholeOrEven) {
  EXPECT_THAT(problem_of_refining(BlockMesh{{1, 1, 1}, {4, 3, 2}, {}}, {1, 2}),
              HasSubstr("body.body.mesh.elements: expected a number that 1/2 times leaves whole, got 3"));
  const CylinderMesh quarter{1, 4, Section::quarter, 0, 2, 2, 1, 6};
  EXPECT_THAT(problem_of_refining(quarter, {1, 2}), HasSubstr("body.body.mesh.core: expected a number that is even"));
  EXPECT_EQ(problem_of_refining(quarter, {2, 1}), no_error);
  EXPECT_THAT(problem_of_refining(SphereMesh{1, Section::half, 0, {2, 2}, 2, 1}, {1, 2}), HasSubstr("is even"));
  EXPECT_THAT(problem_of_refining(BlockMesh{{1, 1, 1}, {400, 3, 2}, {}}, {1000, 1}), HasSubstr("at most 100000"));
}

TEST(MeshFactor, HalvesWhereAllCountsAllowIt) {
  EXPECT_EQ(default_mesh_factors(scene_of(BlockMesh{{1, 1, 1}, {4, 6, 2}, {}})).front(), (MeshFactor{1, 2}));
  EXPECT_THAT(default_mesh_factors(scene_of(BlockMesh{{1, 1, 1}, {4, 6, 1}, {}})),
              ElementsAre(MeshFactor{1, 1}, MeshFactor{2, 1}, MeshFactor{4, 1}));
}

TEST(MeshFactor, RefusesWhatIsAnotherProblemOnAnotherMesh) {
  const auto problem = [](const Scene& scene) { return error_of([&scene] { require_refinable(scene); }); };
  Scene scene = scene_of(BlockMesh{{1, 1, 1}, {4, 6, 2}, {}});
  EXPECT_EQ(problem(scene), no_error);
  scene.time.steps = 5;
  EXPECT_THAT(problem(scene), HasSubstr("time.steps = 5: expected none"));
  scene.time.steps = -1;
  scene.loads.resize(1);
  scene.loads[0].each = true;
  EXPECT_THAT(problem(scene), HasSubstr("load.0.each: expected false"));
  Scene of_file = scene_of(FileMesh{});
  EXPECT_EQ(problem(of_file), no_error);
  of_file.fixed_constraints.resize(2);
  of_file.fixed_constraints[1].nodes.nodes = {17};
  EXPECT_EQ(problem(of_file), no_error) << "they become a set";
  of_file.fixed_constraints[1].nodes.set = "base";
  EXPECT_THAT(problem(of_file), HasSubstr("constraint.1.nodes: expected a set or numbers, and not both"));
  of_file.fixed_constraints.clear();
  of_file.pressures.resize(1);
  of_file.pressures[0].name = "load";
  of_file.pressures[0].corners = {{1, 2, 3, 4}};
  EXPECT_EQ(problem(of_file), no_error);
  of_file.pressures[0].faces.set = "top";
  EXPECT_THAT(problem(of_file), HasSubstr("pressure.load.faces: expected faces alone"));
  of_file.pressures.clear();
  of_file.equation_terms.resize(2);
  of_file.equation_terms[0].nodes.nodes = {17, 18};
  of_file.equation_terms[1].nodes.nodes = {27};
  EXPECT_EQ(problem(of_file), no_error) << "each of the nodes is beside one";
  of_file.equation_terms[1].nodes.nodes = {28, 27};
  EXPECT_THAT(problem(of_file),
              HasSubstr("equation.1: expected nodes of generated meshes, or one node, beside the "
                        "nodes of equation.0: nothing says which of their new nodes belong together"));
  of_file.equation_terms[1].name = "another";
  EXPECT_EQ(problem(of_file), no_error);
  of_file.equation_terms.clear();
  of_file.probes.resize(1);
  of_file.probes[0].number = 17;
  EXPECT_EQ(problem(of_file), no_error) << "a node keeps its number";
  of_file.probes[0].kind = ProbeKind::element;
  EXPECT_THAT(problem(of_file), HasSubstr("probe..element: expected a node or a point: on a finer mesh"));
}

TEST(MeshFactor, SplitsTheElementsOfFilesInEight) {
  FileMesh file;
  file.file = "somewhere/rod.k";
  EXPECT_EQ(refined(file, {4, 1}).splits, 2);
  EXPECT_EQ(refined(file, {1, 1}).splits, 0);
  EXPECT_THAT(problem_of_refining(file, {3, 1}), HasSubstr("body.body.mesh.file: expected factors 1, 2, 4"));
  EXPECT_THAT(problem_of_refining(file, {1, 2}), HasSubstr("got 1/2"));
  EXPECT_EQ(element_counts(scene_of(file)), "body: rod.k");
  EXPECT_EQ(element_counts(refined_by(scene_of(file), {4, 1})), "body: rod.k, each element in 64");
  EXPECT_THAT(default_mesh_factors(scene_of(file)), ElementsAre(MeshFactor{1, 1}, MeshFactor{2, 1}, MeshFactor{4, 1}));
}

}  // namespace
}  // namespace pinball::mesh_factor_test
