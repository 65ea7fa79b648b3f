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

/// A cube from x = 1 to 2; the plane is where its set lies, wherever the scene's point is.
TEST_F(SymmetryWall, OfASetGoesThroughItsNodes) {
  std::ofstream(folder_ / "cube.msh") << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
                                         "$PhysicalNames\n2\n2 1 \"cut\"\n3 2 \"cube\"\n$EndPhysicalNames\n"
                                         "$Nodes\n8\n1 1 0 0\n2 2 0 0\n3 2 1 0\n4 1 1 0\n"
                                         "5 1 0 1\n6 2 0 1\n7 2 1 1\n8 1 1 1\n$EndNodes\n"
                                         "$Elements\n2\n1 3 2 1 1 1 4 8 5\n2 5 2 2 2 1 2 3 4 5 6 7 8\n$EndElements\n";
  std::ofstream(folder_ / "scene.toml") << R"(units = "kg-m-s"
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
[[body]]
name = "cube"
material = "soft"
mesh = { type = "gmsh", file = "cube.msh" }
[[constraint]]
type = "symmetry"
normal = [1, 0, 0]
set = "cut"
)";
  Model<double> model = build_model<double>(read_scene((folder_ / "scene.toml").string()));
  const SymmetryWalls<double> walls(model, *make_host_boundary_kernels<double>(nullptr));
  const std::int32_t crosses = model.node_of_scene_node[1], stays = model.node_of_scene_node[2];
  model.nodes.position_of(crosses)[0] = 0.9;
  model.nodes.velocity_of(crosses)[0] = -11;
  model.nodes.position_of(stays)[0] = 1.1;
  model.nodes.velocity_of(stays)[0] = -9;
  walls.reflect(node_arrays(model), 0.1);
  EXPECT_EQ(model.nodes.velocity_of(crosses)[0], 11);
  EXPECT_NEAR(model.nodes.position_of(crosses)[0], 3.1, 1e-12);
  EXPECT_EQ(model.nodes.velocity_of(stays)[0], -9);
}

}  // namespace
}  // namespace pinball::test::symmetry_walls_test
