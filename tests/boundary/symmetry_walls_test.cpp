#include <gtest/gtest.h>

#include <fstream>

#include <solver/boundary/space/make_boundary_kernels.hpp>
#include <solver/boundary/space/model_arrays.hpp>
#include <solver/boundary/symmetry_walls.hpp>
#include <tests/support/folder_case.hpp>
#include <tests/support/solver_case.hpp>

/// Where nodes that erosion has set free turn back.
namespace pinball::test::symmetry_walls_test {
namespace {

class SymmetryWall : public FolderTest {};

constexpr const char* soft = R"(units = "kg-m-s"
[time]
end = 1
[[material]]
name = "soft"
model = "von_mises"
density = 1000
young_modulus = 1e9
poisson_ratio = 0.3
yield_stress = 1e6
erosion_strain = 0.5
)";

/// A cube from x = 1 to 2; the plane is where its set lies, wherever the scene's point is.
TEST_F(SymmetryWall, OfASetGoesThroughItsNodes) {
  std::ofstream(folder_ / "cube.msh") << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
                                         "$PhysicalNames\n2\n2 1 \"cut\"\n3 2 \"cube\"\n$EndPhysicalNames\n"
                                         "$Nodes\n8\n1 1 0 0\n2 2 0 0\n3 2 1 0\n4 1 1 0\n"
                                         "5 1 0 1\n6 2 0 1\n7 2 1 1\n8 1 1 1\n$EndNodes\n"
                                         "$Elements\n2\n1 3 2 1 1 1 4 8 5\n2 5 2 2 2 1 2 3 4 5 6 7 8\n$EndElements\n";
  std::ofstream(folder_ / "scene.toml") << soft << R"([[body]]
name = "cube"
material = "soft"
mesh = { type = "gmsh", file = "cube.msh" }
[[constraint]]
type = "symmetry"
normal = [1, 0, 0]
set = "cut"
)";
  Model<double> model = build_model<double>(read_scene((folder_ / "scene.toml").string()));
  SymmetryWalls<double> walls(model, *make_host_boundary_kernels<double>(nullptr));
  const std::int32_t crosses = model.node_of_scene_node[1], stays = model.node_of_scene_node[2];
  model.nodes.position_of(crosses)[0] = 0.9;
  model.nodes.velocity_of(crosses)[0] = -11;
  model.nodes.position_of(stays)[0] = 1.1;
  model.nodes.velocity_of(stays)[0] = -9;
  walls.keep_forces(node_arrays(model));
  EXPECT_EQ(walls.reflect(node_arrays(model), {0.1, 0.1}, true), 0);
  EXPECT_EQ(model.nodes.velocity_of(crosses)[0], 11);
  EXPECT_NEAR(model.nodes.position_of(crosses)[0], 3.1, 1e-12);
  EXPECT_EQ(model.nodes.velocity_of(stays)[0], -9);
}

/// With subcycling a node makes the steps of its span at once: it goes back all the way that it has come.
TEST_F(SymmetryWall, TakesTheWayOfAllStepsOfANodeBack) {
  std::ofstream(folder_ / "scene.toml") << soft << R"([[body]]
name = "cube"
material = "soft"
position = [0.5, 0, 0]
mesh = { type = "block", size = [1, 1, 1], elements = [1, 1, 1] }
[[constraint]]
type = "symmetry"
normal = [1, 0, 0]
)";
  Model<double> model = build_model<double>(read_scene((folder_ / "scene.toml").string()));
  for (const int level : {0, 2}) {
    SymmetryWalls<double> walls(model, *make_host_boundary_kernels<double>(nullptr));
    const std::int32_t crosses = model.node_of_scene_node[0];
    model.nodes.velocity_of(crosses)[0] = -11;
    model.nodes.position_of(crosses)[0] = 0.75 - 11 * 0.1 * (1 << level);
    walls.keep_forces(node_arrays(model));
    const std::vector<std::int8_t> levels{static_cast<std::int8_t>(level)};
    walls.reflect(node_arrays(model), {0.1, 0.1}, true, {&levels, 2});
    EXPECT_EQ(model.nodes.velocity_of(crosses)[0], 11);
    EXPECT_NEAR(model.nodes.position_of(crosses)[0], 0.75 + 11 * 0.1 * (1 << level), 1e-12);
  }
}

/// Two cubes with a face in common; the plane is that of the second one.
TEST_F(SymmetryWall, OfABodyTurnsNodesRoundThatItShares) {
  std::ofstream(folder_ / "cubes.msh") << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
                                          "$PhysicalNames\n2\n3 1 \"first\"\n3 2 \"second\"\n$EndPhysicalNames\n"
                                          "$Nodes\n12\n1 1 0 0\n2 2 0 0\n3 2 1 0\n4 1 1 0\n"
                                          "5 1 0 1\n6 2 0 1\n7 2 1 1\n8 1 1 1\n"
                                          "9 3 0 0\n10 3 1 0\n11 3 0 1\n12 3 1 1\n$EndNodes\n"
                                          "$Elements\n2\n1 5 2 1 1 1 2 3 4 5 6 7 8\n"
                                          "2 5 2 2 2 2 9 10 3 6 11 12 7\n$EndElements\n";
  std::ofstream(folder_ / "scene.toml") << soft << R"([[body]]
name = "first"
material = "soft"
mesh = { type = "gmsh", file = "cubes.msh", physical = "first" }
[[body]]
name = "second"
material = "soft"
mesh = { type = "gmsh", file = "cubes.msh", physical = "second" }
[[constraint]]
type = "symmetry"
normal = [0, 1, 0]
body = "second"
)";
  Model<double> model = build_model<double>(read_scene((folder_ / "scene.toml").string()));
  SymmetryWalls<double> walls(model, *make_host_boundary_kernels<double>(nullptr));
  for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n) {
    const std::int32_t node = model.node_of_scene_node[n];
    model.nodes.position_of(node)[1] = -0.1;
    model.nodes.velocity_of(node)[1] = -1;
  }
  walls.keep_forces(node_arrays(model));
  walls.reflect(node_arrays(model), {0.1, 0.1}, true);
  for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n) {
    const Point& x = model.mesh.nodes[n];
    const bool is_of_second = x[0] > 1.5 && x[1] > 0.5;  // and not in the plane
    EXPECT_EQ(model.nodes.velocity_of(model.node_of_scene_node[n])[1], is_of_second ? 1 : -1) << x[0] << ' ' << x[1];
  }
}

/// A block flies at a plane of symmetry, whose own body is torn so that some of its elements erode.
Scene fragment_at_plane() {
  Scene scene = scene_of({block("torn", {1, 2, 2}, 0.1, {0, 1, 0}), block("fragment", {2, 2, 2}, 0.1, {0.005, 0, 0})},
                         1e-3, false);
  scene.materials = {elastic_material("steel"), plastic_material("weak", 1e6, 1e-3)};
  scene.bodies[0].material = "weak";
  scene.bodies[0].velocity_gradient = {{{0, 0, 0}, {0, 300, 0}, {0, 0, 0}}};
  scene.bodies[1].velocity = {-100, 20, 0};
  scene.constraints = {{{0, 0, 0}, {1, 0, 0}, "", "", 0, "", "mirror"}};
  return scene;
}

TEST(SymmetryWalls, HaveImpulseAndWorkOfWhatTheyTurnRoundInTheAccounts) {
  Scene scene = fragment_at_plane();
  const auto largest_error = [&](double cfl) {
    scene.time.cfl = cfl;
    Solver<double> solver(scene);
    double impulse = 0, error = 0;
    const double before = solver.momentum()[0];
    while (!solver.at_end()) {
      solver.step();
      impulse += 0.5 * (solver.clock().dt_before() + solver.dt()) * solver.named_forces()[0].force[0];
      error = std::max(error, std::abs(solver.momentum()[0] - before - impulse));
    }
    EXPECT_GT(solver.counts().eroded_elements(), 0);
    const double mass = 7850 * 0.008;
    EXPECT_GT(impulse, 1.5 * mass * 100) << "it has turned round";
    EXPECT_LT(error, 1e-9 * impulse);
    return solver.ledger().balance_error_in_motion_max();
  };
  EXPECT_LT(largest_error(0.9), 0.05);  // without the work of the plane 0.6, 0.2 and 0.1
  EXPECT_LT(largest_error(0.45), 2.5e-3);
  EXPECT_LT(largest_error(0.2), 4e-4);
}

/// A plane that holds one body is no mirror of others that lie behind it, however large, or reach through it.
TEST(SymmetryWalls, LetBodiesPassThatHaveNoImageThere) {
  Scene scene = fragment_at_plane();
  scene.bodies.push_back(block("behind", {4, 4, 4}, 0.1, {-1, 3, 0}, {10, 0, 0}));
  scene.bodies.push_back(block("through", {2, 2, 2}, 0.1, {-0.105, -1, 0}, {-10, 0, 0}));
  Solver<double> solver(scene);
  run(solver);
  RunSummary summary;
  fill_summary(solver, summary);
  EXPECT_GT(solver.counts().eroded_elements(), 0);
  EXPECT_GT(summary.bodies[1].velocity[0], 50) << "it has turned round";
  EXPECT_NEAR(summary.bodies[2].velocity[0], 10, 1e-9);
  EXPECT_NEAR(summary.bodies[3].velocity[0], -10, 1e-9);
}

/// Bodies on both sides that the plane holds are each of a mirror of their own.
TEST(SymmetryWalls, TurnRoundToEitherSideWhereTheyHoldBodies) {
  Scene scene = fragment_at_plane();
  scene.bodies.push_back(block("seat", {1, 1, 1}, 0.1, {-0.1, 2, 0}));
  scene.bodies.push_back(block("flies", {2, 2, 2}, 0.1, {-0.205, -1, 0}, {100, 0, 0}));
  Solver<double> solver(scene);
  run(solver);
  RunSummary summary;
  fill_summary(solver, summary);
  EXPECT_GT(summary.bodies[1].velocity[0], 50);
  EXPECT_LT(summary.bodies[3].velocity[0], -50);
}

}  // namespace
}  // namespace pinball::test::symmetry_walls_test
