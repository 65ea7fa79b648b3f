#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <utility>

#include <solver/base/state_hash.hpp>
#include <solver/elements/nodal_volumes.hpp>
#include <tests/support/law_materials.hpp>
#include <tests/support/output_case.hpp>
#include <tests/support/run_hash.hpp>
#include <tests/support/saved_state.hpp>
#include <tests/support/tetrahedra_case.hpp>

/// Tetrahedra in whole runs: against hexahedra of the same nodes, and against what is exact.
namespace pinball::test::tetrahedra_test {
namespace {

std::vector<Material> laws() {
  Material plastic = plastic_material("plastic", 3e8, 0), curve = plastic_material("curve", 3e8, 0);
  plastic.ultimate_stress = 3.2e8;
  curve.yield_curves = {{0, {0, 0.1, 0.5}, {3e8, 4e8, 5e8}}};
  return {elastic_material(), plastic, curve, with_equation_of_state(), rubber(), rubber_of_powers()};
}
bool is_rubber(const Material& material) { return material.mooney_rivlin || material.ogden; }

Scene one_block(const Material& material, bool tetrahedra, double end) {
  const Body body = block("a", {3, 2, 2}, 0.1, {0.1, 0.2, 0.3}, {}, material.name);
  Scene scene = scene_of({tetrahedra ? cut(body) : body}, end, false);
  scene.materials = {material};
  return scene;
}

std::array<double, 6> stress_after(const Scene& scene, const PrescribedMotion::Path& path, std::size_t element) {
  Solver<double> solver(scene);
  PrescribedMotion motion(solver, path);
  while (!solver.at_end()) motion.step();
  solver.finish();
  return stress_of(solver, element);
}

/// Where all strain alike, averages change nothing: the patch test at large strain and rotation, of each law.
TEST(Tetrahedra, HaveTheStressOfHexahedraWhereAllStrainAlike) {
  const auto path = [](const Point& x, double t) {
    const double a = 2e3 * t, c = std::cos(a), s = std::sin(a), e = 400 * t;
    const Point y{(1 + e) * x[0] + 2 * e * x[1], (1 - 0.3 * e) * x[1] - e * x[2], (1 - 0.5 * e) * x[2]};
    return Point{c * y[0] - s * y[1], s * y[0] + c * y[1], y[2]};
  };
  for (const Material& material : laws()) {
    Scene of_hexahedra = one_block(material, false, 2e-4), of_tetrahedra = one_block(material, true, 2e-4);
    for (Scene* scene : {&of_hexahedra, &of_tetrahedra}) {
      scene->time.cfl = 0.05;
      scene->guard.energy_error = 1e30;
    }
    const auto expected = stress_after(of_hexahedra, path, 0);
    const double size = std::sqrt(std::pow(expected[0], 2) + std::pow(expected[3], 2));
    ASSERT_GT(size, 1e4);
    for (const std::size_t element : {0, 20, 71}) {
      const auto found = stress_after(of_tetrahedra, path, element);
      for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(found[k], expected[k], 1e-4 * size) << material.name << " " << k;
    }
  }
}

TEST(Tetrahedra, CarryNoStressWhenTheyTurnAndFly) {
  for (const Material& material : laws()) {
    Scene scene = one_block(material, true, 1e-3);
    scene.time.cfl = 0.2;
    const auto path = [](const Point& x, double t) {
      const double a = 3e3 * t, c = std::cos(a), s = std::sin(a);
      return Point{c * x[0] - s * x[2] + 50 * t, x[1], s * x[0] + c * x[2]};
    };
    scene.guard.energy_error = 1e30;
    for (const double stress : stress_after(scene, path, 7)) EXPECT_NEAR(stress, 0, 1e-4 * material.shear_modulus + 30);
  }
}

/// A block that strikes a wall, with what else acts on elements.
Scene striking(const Material& material, bool tetrahedra, const std::array<int, 3>& elements = {4, 4, 10}) {
  const Body body =
      block("a", elements, 0.1, {0, 0, 0.001}, {0, 0, is_rubber(material) ? -10.0 : -150.0}, material.name);
  Scene scene = scene_of({tetrahedra ? cut(body) : body}, is_rubber(material) ? 0.05 : 1e-3, false);
  scene.element.bulk_viscosity = true;
  scene.materials = {material};
  scene.rigid_walls = {{"floor", {{0, 0, 0}, {0, 0, 1}}, "", "here"}};
  return scene;
}

TEST(Tetrahedra, KeepTheBalanceOfEnergyAndMomentum) {
  for (const Material& material : laws()) {
    Solver<double> solver(striking(material, true));
    EXPECT_LT(worst_balance_of_run(solver), 2e-3) << material.name;
    EXPECT_EQ(solver.counts().eroded_elements(), 0);
    // The wall pushes along z alone.
    const Point p = solver.momentum();
    EXPECT_NEAR(p[0], 0, 1e-6 * std::abs(p[2]));
    EXPECT_NEAR(p[1], 0, 1e-6 * std::abs(p[2]));
  }
}

double height_of(const Scene& scene) {
  Solver<double> solver(scene);
  run(solver);
  double low = 1e9, high = -1e9;
  for (std::size_t n = 0; n < solver.model().node_mass.size(); ++n) {
    const double z = solver.model().nodes.position[4 * n + 2];
    low = std::min(low, z);
    high = std::max(high, z);
  }
  return high - low;
}

/// Plastic flow keeps volumes. Elements that each keep theirs could not follow it: by the volumes of nodes they do.
TEST(Tetrahedra, DoNotLockWherePlasticFlowKeepsVolumes) {
  const Material soft = plastic_material("soft", 3e8, 0);
  const double of_hexahedra = height_of(striking(soft, false)), of_tetrahedra = height_of(striking(soft, true));
  ASSERT_LT(of_hexahedra, 0.93);  // of 1
  EXPECT_NEAR(of_tetrahedra, of_hexahedra, 0.03 * (1 - of_hexahedra));
}

TEST(Tetrahedra, HaveTheSameBitsForAnyNumberOfThreads) {
  for (Precision precision : {Precision::float64, Precision::float32, Precision::mixed}) {
    Scene scene = striking(plastic_material("soft", 3e8, 0), true, {8, 8, 12});
    scene.time.end = 1e-4;
    scene.precision = precision;
    if (precision == Precision::float32) {
      EXPECT_EQ(hash_of<float>(scene, 1), hash_of<float>(scene, 3));
    } else {
      EXPECT_EQ(hash_of<double>(scene, 1), hash_of<double>(scene, 3));
    }
  }
}

TEST(Tetrahedra, GoOnFromASavedState) {
  for (const Material& material : laws()) {
    const Scene scene = striking(material, true, {2, 2, 3});
    Solver<double> whole(scene), first(scene), rest(scene);
    for (int i = 0; i < 40; ++i) first.step();
    load(rest, saved(first));
    while (!whole.at_end()) whole.step();
    while (!rest.at_end()) rest.step();
    EXPECT_EQ(state_hash(rest.model()), state_hash(whole.model())) << material.name;
  }
}

/// Two that share a face, of two bodies of one file. What is pulled is one of them alone.
TEST(Tetrahedra, OfOneMaterialDoNotShareVolumesWithThoseOfAnother) {
  const TemporaryFolder folder("two_tetrahedra");
  const std::string path = folder / "two.msh";
  std::ofstream(path)
      << ("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
          "$PhysicalNames\n2\n3 1 \"a\"\n3 2 \"b\"\n$EndPhysicalNames\n"
          "$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 0 0 -1\n$EndNodes\n"
          "$Elements\n2\n1 4 2 1 1 1 2 3 4\n2 4 2 2 2 1 3 2 5\n$EndElements\n");
  Scene scene = scene_of({}, 1, false);
  scene.materials = {elastic_material("steel"), elastic_material("other")};
  for (const auto& [name, material] : {std::pair{"a", "steel"}, std::pair{"b", "other"}}) {
    Body body;
    body.name = name;
    body.material = material;
    body.mesh = FileMesh{.file = path, .part = name};
    scene.bodies.push_back(body);
  }
  const auto ratios = [](const Scene& of) {
    Solver<double> solver(of);
    Model<double>& model = solver.change_model();
    NodalVolumes<double> volumes(model);
    model.nodes.position_of(model.node_of_scene_node[3])[2] = 1.5;
    volumes.average(model);
    const auto ratio = [&](std::size_t e) {
      return double(model.elements.volume_ratio[model.elements.at(model.slot_of_element[e], 0, 2)]);
    };
    return std::pair{ratio(0), ratio(1)};
  };
  EXPECT_EQ(ratios(scene), (std::pair{1.5, 1.0}));
  // Of one material they do: 5/4 at the three nodes of the face.
  scene.bodies[1].material = "steel";
  EXPECT_EQ(ratios(scene), (std::pair{0.25 * (3 * 1.25 + 1.5), 0.25 * (3 * 1.25 + 1)}));
}

TEST(Tetrahedra, ErodeWithWhatTheyCarry) {
  Scene scene = striking(plastic_material("brittle", 3e8, 0.05), true);
  Solver<double> solver(scene);
  EXPECT_LT(worst_balance_of_run(solver), 2e-3);
  EXPECT_GT(solver.counts().eroded_elements(), 10);
  EXPECT_LT(solver.counts().eroded_elements(), 900);
}

}  // namespace
}  // namespace pinball::test::tetrahedra_test
