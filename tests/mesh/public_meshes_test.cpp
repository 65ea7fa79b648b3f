#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include <solver/formats/mesh_reader.hpp>
#include <solver/mesh/mesh_format.hpp>
#include <solver/mesh/quality.hpp>
#include <solver/simulation.hpp>
#include <tests/support/scene_fixture.hpp>

/// Meshes that others wrote, where they lie beside the tree; elsewhere these tests are skipped.
namespace pinball::test::public_meshes_test {
namespace {

const std::filesystem::path meshes = PINBALL_SOURCE_DIR "/../shared/decks";

class PublicMeshes : public SceneTest {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(meshes)) GTEST_SKIP() << meshes << " is not there";
    SceneTest::SetUp();
  }
  static MeshFile read_file(const std::string& name) {
    FileMesh settings;
    settings.file = (meshes / name).string();
    settings.format = format_by_ending(name).value();
    return read_mesh_file(settings, {});
  }
};

TEST_F(PublicMeshes, PunchTestHas32Hexahedra) {
  const MeshFile file = read_file("punch-test.msh");
  EXPECT_EQ(file.mesh.hexahedra.size(), 32u);
  EXPECT_EQ(file.mesh.nodes.size(), 75u);
  EXPECT_EQ(elements_of_part(file, "block").size(), 32u);
  EXPECT_NEAR(measure_quality(file.mesh).volume, 1e-9, 1e-15);
  EXPECT_EQ(find_set(file.node_sets, "top-punch")->members.size(), 9u);
  EXPECT_EQ(find_set(file.node_sets, "4")->members.size(), 9u);
  EXPECT_EQ(file.face_sets.size(), 5u);
}

TEST_F(PublicMeshes, TheUnstructuredCubeHas400HexahedraAndVolumeOne) {
  const MeshFile file = read_file("unstrucrured-hex-cube.msh");
  EXPECT_EQ(file.mesh.hexahedra.size(), 400u);
  EXPECT_NEAR(measure_quality(file.mesh).volume, 1, 1e-9);
}

/// A bar of length L that flies along itself with v, of which the end in front is held from time 0 on. The free end
/// goes on with v until the wave comes to it at t = L/c, c = sqrt(E/rho), then back with -v until 3 L/c, and so on: a
/// triangle of amplitude v L/c and period 4 L/c.
double displacement_of_free_end(double t, double v, double length, double c) {
  const double period = 4 * length / c,
               phase = std::fmod(t + length / c, period);  // 0 at the largest on the other side
  return v * (phase < period / 2 ? phase - period / 4 : 3 * period / 4 - phase);
}

/// Material and speed are those of the test of NimbleSM that the mesh is from: no Poisson ratio, waves of a bar.
TEST_F(PublicMeshes, TheBarFollowsTheWaveEquation) {
  std::filesystem::copy(meshes / "wave_in_bar.g", folder_ / "bar.g");
  const std::vector<std::string> lines{
      "units = \"cm-g-s\"",
      "time.end = 1e-5",
      "output.interval = 1e-8",
      "element.bulk_viscosity = false",
      "[[material]]",
      "name = \"steel\"",
      "model = \"elastic\"",
      "density = 7.8",
      "bulk_modulus = 1e12",
      "shear_modulus = 1.5e12",
      "[[body]]",
      "name = \"bar\"",
      "material = \"steel\"",
      "mesh = { type = \"file\", file = \"bar.g\" }",
      "velocity = [1000, 0, 0]",
      "[[constraint]]",
      "type = \"fixed\"",
      "directions = \"all\"",
      "set = \"2\"",
  };
  const Scene scene = read(lines);
  Simulation simulation(scene);
  const MeshFile mesh = read_file("wave_in_bar.g");
  EXPECT_EQ(mesh.mesh.hexahedra.size(), 100u);
  const Point& held = mesh.mesh.nodes[find_set(mesh.node_sets, "2")->members.front()];
  const auto away = [&](std::size_t n) { return std::abs(mesh.mesh.nodes[n][0] - held[0]); };
  std::size_t free_node = 0;
  for (std::size_t n = 0; n < mesh.mesh.nodes.size(); ++n) {
    if (away(n) > away(free_node)) free_node = n;
  }
  const double length = away(free_node);
  ASSERT_DOUBLE_EQ(length, 2);
  const double c = std::sqrt(3e12 / 7.8), amplitude = 1000 * length / c;
  double largest = 0, sum = 0;
  int count = 0;
  simulation.on_step([&](Simulation& s) {
    const double u = s.positions().number(s.place_of_node()[free_node], 0) - mesh.mesh.nodes[free_node][0];
    const double error = std::abs(u - displacement_of_free_end(s.time(), 1000, length, c)) / amplitude;
    largest = std::max(largest, error);
    sum += error;
    ++count;
    return AfterStep::go_on;
  });
  simulation.run();
  EXPECT_GT(count, 300);
  EXPECT_LT(largest, 0.03);
  EXPECT_LT(sum / count, 0.002);
}

}  // namespace
}  // namespace pinball::test::public_meshes_test
