#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include <solver/base/state_hash.hpp>
#include <solver/elements/nodal_volumes.hpp>
#include <solver/mesh/generators.hpp>
#include <solver/model/step_levels.hpp>
#include <tests/support/collapsed_case.hpp>
#include <tests/support/law_materials.hpp>
#include <tests/support/run_hash.hpp>
#include <tests/support/saved_state.hpp>

/// Wedges in whole runs, with volumes that are averaged over nodes, and pyramids beside them.
namespace pinball::test::averaged_wedges_test {
namespace {

std::vector<Material> laws() {
  Material curve = plastic_material("curve", 3e8, 0);
  curve.yield_curves = {{0, {0, 0.1, 0.5}, {3e8, 4e8, 5e8}}};
  return {elastic_material(), plastic_material("plastic", 3e8, 0), curve, with_equation_of_state(), rubber()};
}

Scene with(const HostMesh& mesh, const Material& material, double end) {
  Scene scene = scene_of({body_of(mesh, material.name)}, end, false);
  scene.materials = {material};
  scene.element.hourglass = HourglassControl::assumed_strain;
  return scene;
}

/// The patch test of forces: between hexahedra, wedges and pyramids of any shape a linear field lasts, until waves from
/// outside come in. (It does not between hexahedra and pairs of tetrahedra: their faces bend in other ways. Bulk
/// viscosity goes by the size of elements.)
TEST(AveragedWedges, KeepLinearFieldsBesideHexahedra) {
  const std::array<int, 3> cubes{10, 9, 11};
  const HostMesh mesh = block_of_shapes(cubes, 0.1, 0.15);
  for (const HourglassControl form : {HourglassControl::none, HourglassControl::viscous, HourglassControl::stiffness,
                                      HourglassControl::assumed_strain}) {
    for (const Material& material : laws()) {
      Scene scene = with(mesh, material, 1);
      scene.element.hourglass = form;
      scene.bodies[0].velocity_gradient = {{{60, 20, 10}, {-30, 50, 20}, {15, -25, 40}}};
      Solver<double> solver(scene);
      const auto node_of = [&](std::size_t n) { return solver.model().node_of_scene_node[n]; };
      const std::vector<Point> velocity = [&] {
        std::vector<Point> v;
        for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
          const double* const of = solver.model().nodes.velocity_of(node_of(n));
          v.push_back({of[0], of[1], of[2]});
        }
        return v;
      }();
      // In the second step the surface begins to move, in the third what is within two cubes of it: averages reach
      // further.
      for (int i = 0; i < 3; ++i) solver.step();
      const double time = solver.time();
      ASSERT_GT(time, 0);
      int inside = 0;
      double worst = 0, outside = 0;
      for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
        const Point &x0 = mesh.nodes[n], x = position_of(solver, n);
        bool deep = true;
        for (std::size_t k = 0; k < 3; ++k) deep = deep && x0[k] > 0.1 * 2.7 && x0[k] < 0.1 * (cubes[k] - 2.7);
        double away = 0;
        for (std::size_t k = 0; k < 3; ++k) away += std::abs(x[k] - x0[k] - time * velocity[n][k]);
        inside += deep ? 1 : 0;
        (deep ? worst : outside) = std::max(deep ? worst : outside, away);
      }
      EXPECT_GT(inside, 50);
      EXPECT_GT(outside, 1e-7) << material.name;  // there are stresses
      // Round-off of places of 1. Laws of rates see the strain of the averaged volume, which is that of the trace but
      // for the third power of a step's.
      const bool of_rates = material.plastic || material.mooney_rivlin.has_value();
      EXPECT_LT(worst, of_rates ? 1e-7 * outside : 1e-13) << material.name;
    }
  }
}

/// Where all strain alike, averages change nothing, at large strain and rotation.
TEST(AveragedWedges, HaveTheStressOfHexahedraWhereAllStrainAlike) {
  const auto path = [](const Point& x, double t) {
    const double a = 2e3 * t, c = std::cos(a), s = std::sin(a), e = 400 * t;
    const Point y{(1 + e) * x[0] + 2 * e * x[1], (1 - 0.3 * e) * x[1] - e * x[2], (1 - 0.5 * e) * x[2]};
    return Point{c * y[0] - s * y[1], s * y[0] + c * y[1], y[2]};
  };
  const HostMesh hexahedra = block_cut({3, 2, 2}, {0.3, 0.2, 0.2}, Cut::none), shapes = block_of_shapes({3, 2, 2}, 0.1);
  const auto stress_after = [&](const HostMesh& mesh, const Material& material, std::size_t element) {
    Scene scene = with(mesh, material, 2e-4);
    scene.time.cfl = 0.05;
    scene.guard.energy_error = 1e30;
    Solver<double> solver(scene);
    PrescribedMotion motion(solver, path);
    while (!solver.at_end()) motion.step();
    solver.finish();
    return stress_of(solver, element);
  };
  for (const Material& material : laws()) {
    const auto expected = stress_after(hexahedra, material, 0);
    const double size = std::sqrt(std::pow(expected[0], 2) + std::pow(expected[3], 2));
    ASSERT_GT(size, 1e4);
    for (std::size_t element = 0; element < shapes.elements.size(); element += 3) {
      const auto found = stress_after(shapes, material, element);
      for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(found[k], expected[k], 1e-4 * size) << material.name << " " << k;
    }
  }
}

/// A block that strikes a wall.
Scene striking(const HostMesh& mesh, const Material& material) {
  Scene scene = with(mesh, material, material.mooney_rivlin ? 0.05 : 1e-3);
  scene.bodies[0].position = {0, 0, 0.001};
  scene.bodies[0].velocity = {0, 0, material.mooney_rivlin ? -10.0 : -150.0};
  scene.element.bulk_viscosity = true;
  scene.rigid_walls = {{"floor", {{0, 0, 0}, {0, 0, 1}}, "", "here"}};
  return scene;
}

TEST(AveragedWedges, KeepTheBalanceOfEnergyAndMomentum) {
  const HostMesh mesh = block_of_shapes({4, 4, 10}, 0.1);
  for (const Material& material : laws()) {
    Solver<double> solver(striking(mesh, material));
    EXPECT_LT(worst_balance_of_run(solver), 2e-3) << material.name;
    // The wall pushes along z alone.
    const Point p = solver.momentum();
    EXPECT_NEAR(p[0], 0, 1e-9 * std::abs(p[2]));
    EXPECT_NEAR(p[1], 0, 1e-9 * std::abs(p[2]));
  }
}

TEST(AveragedWedges, ErodeWithWhatTheyCarry) {
  Solver<double> solver(striking(block_of_shapes({4, 4, 10}, 0.1), plastic_material("brittle", 3e8, 0.05)));
  EXPECT_LT(worst_balance_of_run(solver), 2e-3);
  EXPECT_GT(solver.counts().eroded_elements(), 10);
  EXPECT_LT(solver.counts().eroded_elements(), 400);
}

/// The tip of the cantilever, of height 1 and length 10, over that of the Timoshenko beam.
double deflection(const HostMesh& mesh, double poisson_ratio) {
  Scene scene = read_scene(find_scene("cantilever"));
  scene.bodies[0].mesh = body_of(mesh).mesh;
  scene.element.hourglass = HourglassControl::assumed_strain;
  scene.element.hourglass_coefficient = 1;
  Material& m = scene.materials[0];
  m.bulk_modulus = 1 / (3 * (1 - 2 * poisson_ratio));
  m.shear_modulus = 1 / (2 * (1 + poisson_ratio));
  Solver<double> solver(scene);
  run(solver);
  double sum = 0;
  int count = 0;
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    if (mesh.nodes[n][0] < 10 - 1e-9) continue;
    sum += position_of(solver, n)[1] - mesh.nodes[n][1];
    ++count;
  }
  const double force = scene.loads[0].force[1];
  return sum / count / (force * (1000 / (3 / 12.0) + 10 / (5.0 / 6.0 * m.shear_modulus)));
}

/// Statics of the same elements, by an independent program. With volumes of their own wedges across z were at 0.209
/// with a Poisson ratio of 0.49.
TEST(AveragedWedges, BendAsStaticsSays) {
  const auto expect = [](Cut how, double poisson_ratio, double expected) {
    EXPECT_NEAR(deflection(block_cut({20, 2, 2}, {10, 1, 1}, how), poisson_ratio), expected, 2e-3)
        << static_cast<int>(how) << " " << poisson_ratio;
  };
  expect(Cut::across_z, 0.3, 0.664);
  expect(Cut::across_y, 0.3, 0.979);
  expect(Cut::across_x, 0.3, 1.087);
  expect(Cut::across_z, 0.49, 0.626);
  expect(Cut::across_y, 0.49, 0.887);
  expect(Cut::across_x, 0.49, 0.916);
  expect(Cut::pyramids, 0.49, 0.788);
}

double height_of(const HostMesh& mesh) {
  Solver<double> solver(striking(mesh, plastic_material("soft", 3e8, 0)));
  run(solver);
  double low = 1e9, high = -1e9;
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    low = std::min(low, position_of(solver, n)[2]);
    high = std::max(high, position_of(solver, n)[2]);
  }
  return high - low;
}

TEST(AveragedWedges, DoNotLockWherePlasticFlowKeepsVolumes) {
  const double of_hexahedra = height_of(block_cut({4, 4, 10}, {0.4, 0.4, 1}, Cut::none));
  ASSERT_LT(of_hexahedra, 0.93);  // of 1
  for (const Cut how : {Cut::across_x, Cut::across_y, Cut::across_z, Cut::pyramids}) {
    EXPECT_NEAR(height_of(block_cut({4, 4, 10}, {0.4, 0.4, 1}, how)), of_hexahedra, 0.03 * (1 - of_hexahedra))
        << static_cast<int>(how);
  }
}

/// Length and radius of the foot of the copper bar, of a coarse mesh.
std::pair<double, double> taylor_bar(Cut how, bool hexahedra) {
  Scene scene = read_scene(find_scene("taylor_tetrahedra"));
  CylinderMesh cylinder = std::get<CylinderMesh>(scene.bodies[0].mesh);
  cylinder.core = 4;
  cylinder.ring = 2;
  cylinder.layers = 40;
  const Mesh generated = generate_cylinder(cylinder);
  HostMesh mesh{generated.nodes, {}};
  for (const Corners8& corners : generated.hexahedra) add_cut(corners, how, mesh);
  scene.bodies[0].mesh = body_of(mesh).mesh;
  scene.bodies[0].elements = ElementShape::hexahedra;
  if (hexahedra) scene.bodies[0].mesh = cylinder;
  Solver<double> solver(scene);
  run(solver);
  double length = 0, radius = 0;
  for (std::size_t n = 0; n < generated.nodes.size(); ++n) {
    const Point x = position_of(solver, n);
    length = std::max(length, x[2]);
    radius = std::max(radius, std::hypot(x[0], x[1]));
  }
  return {length, radius};
}

/// Converged results: length 21.42, radius 7.22.
TEST(AveragedWedges, FlowAsHexahedraDo) {
  const auto [length, radius] = taylor_bar(Cut::none, true);
  const auto [found, foot] = taylor_bar(Cut::across_z, false);
  EXPECT_NEAR(length, 21.42, 0.05);
  EXPECT_NEAR(found, 21.42, 0.05);
  EXPECT_NEAR(radius, 7.22, 0.15);
  EXPECT_NEAR(foot, 7.22, 0.15);
}

/// Their volumes are those that they share with tetrahedra: of the two that meet in a triangle one alone is stretched.
TEST(AveragedWedges, ShareVolumesWithTetrahedraOfTheirMaterial) {
  HostMesh mesh;
  mesh.nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {0, 0, 2}};
  mesh.elements = {wedge(0, 1, 2, 3, 4, 5), tetrahedron(3, 4, 5, 6)};
  Solver<double> solver(with(mesh, elastic_material(), 1));
  Model<double>& model = solver.change_model();
  NodalVolumes<double> volumes(model);
  model.nodes.position_of(model.node_of_scene_node[6])[2] = 2.5;  // 1/6 becomes 1/4, beside 1/2
  volumes.average(model);
  const auto ratio = [&](std::size_t e) {
    return double(model.elements.volume_ratio[model.elements.at(model.slot_of_element[e], 0, 2)]);
  };
  // At a node of the triangle the tetrahedron has a quarter of its volume, the wedge a sixth.
  const double together = (1 / 12.0 + 1 / 16.0) / (1 / 12.0 + 1 / 24.0);
  EXPECT_NEAR(ratio(0), (3 + 3 * together) / 6, 1e-15);
  EXPECT_NEAR(ratio(1), (3 * together + 1.5) / 4, 1e-15);
}

/// At the axis of a generated wedge elements are wedges, and keep volumes of their own: nothing locks there. Nor do
/// pyramids.
TEST(AveragedWedges, AreNeitherThoseOfGeneratedMeshesNorPyramids) {
  Body body = block("a", {1, 1, 1}, 1, {});
  body.mesh =
      CylinderMesh{.radius = 0.4, .length = 0.6, .section = Section::wedge, .angle = 30, .radial = 3, .layers = 4};
  const Model<double> generated = build_model<double>(scene_of({body}, 1, false));
  EXPECT_FALSE(generated.averages_volumes());
  const HostMesh mesh{generated.mesh.nodes, generated.mesh.hexahedra};
  const Model<double> given = build_model<double>(scene_of({body_of(mesh)}, 1, false));
  EXPECT_TRUE(given.averages_volumes());
  EXPECT_EQ(given.parts.size(), 2u);
  const HostMesh pyramids = block_cut({1, 1, 1}, {1, 1, 1}, Cut::pyramids);
  EXPECT_FALSE(build_model<double>(scene_of({body_of(pyramids)}, 1, false)).averages_volumes());
}

TEST(AveragedWedges, MakeTheSmallestStepOfSubcycling) {
  const auto how = [](int, int, int k) { return k < 4 ? Cut::across_z : Cut::none; };
  HostMesh mesh = block_cut({2, 2, 12}, {0.2, 0.2, 1.2}, how);
  for (Point& x : mesh.nodes) {
    if (x[2] < 0.45) x[2] *= 0.3;
  }
  Scene scene = with(mesh, elastic_material(), 1e-5);
  scene.time.subcycling = true;
  const ElementLevels levels = element_step_levels(scene, build_mesh(scene));
  for (std::size_t e = 0; e < 2 * 2 * 2 * 4; ++e) EXPECT_EQ(levels.own[e], 0) << e;
  EXPECT_GT(levels.level.back(), 0);
}

TEST(AveragedWedges, HaveTheSameBitsForAnyNumberOfThreads) {
  EXPECT_EQ(hash_of<double>(torn_shapes(), 1), hash_of<double>(torn_shapes(), 3));
  EXPECT_EQ(hash_of<float>(torn_shapes(Precision::float32), 1), hash_of<float>(torn_shapes(Precision::float32), 3));
  EXPECT_EQ(hash_of<double>(torn_shapes(Precision::mixed), 1), hash_of<double>(torn_shapes(Precision::mixed), 3));
}

TEST(AveragedWedges, GoOnFromASavedState) {
  const HostMesh mesh = block_of_shapes({2, 2, 3}, 0.1);
  for (const Material& material : laws()) {
    const Scene scene = striking(mesh, material);
    Solver<double> whole(scene), first(scene), rest(scene);
    for (int i = 0; i < 40; ++i) first.step();
    load(rest, saved(first));
    while (!whole.at_end()) whole.step();
    while (!rest.at_end()) rest.step();
    EXPECT_EQ(state_hash(rest.model()), state_hash(whole.model())) << material.name;
  }
}

}  // namespace
}  // namespace pinball::test::averaged_wedges_test
