#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <solver/device/body_elements.hpp>
#include <tests/support/collapsed_case.hpp>
#include <tests/support/solver_case.hpp>
#include <tests/support/wedge_layouts.hpp>

/// Which node of a wedge's triangles comes third is nothing that results depend on: all six have the same share of it.
namespace pinball::test::wedge_layouts_test {
namespace {

Scene with(const HostMesh& mesh, double end) {
  Scene scene = scene_of({body_of(mesh)}, end, false);
  scene.element.hourglass = HourglassControl::assumed_strain;
  return scene;
}

NodeSelection at(double place, std::size_t axis) {
  NodeSelection nodes;
  nodes.where = "here";
  Point on{}, normal{};
  on[axis] = place;
  normal[axis] = 1;
  nodes.plane = Plane{on, normal};
  return nodes;
}

/// Pulled, pressed on its top, loaded on one side, above a wall.
Scene worked(const HostMesh& mesh, const Material& material, HourglassControl form) {
  Scene scene = with(mesh, 4e-4);
  scene.materials = {material};
  scene.bodies[0].material = material.name;
  scene.element.hourglass = form;
  scene.element.bulk_viscosity = true;
  scene.bodies[0].velocity_gradient = {{{60, 20, 10}, {-30, 50, 20}, {15, -25, -90}}};
  scene.bodies[0].position = {0, 0, 1e-4};
  Pressure& pressure = scene.pressures.emplace_back();
  pressure.name = "top";
  pressure.faces = at(0.3 + 1e-4, 2);
  pressure.pressure = 2e8;
  NodalLoad load;
  load.nodes = at(0.3, 0);
  load.force = {1e7, -4e6, 2e6};
  scene.loads = {load};
  scene.rigid_walls = {{"floor", {{0, 0, 0}, {0, 0, 1}}, "", "here"}};
  scene.damping.mass = 100;
  return scene;
}

double size_of(const Point& x) { return std::sqrt(dot(x, x)); }

/// However the wedges of a block are listed, its nodes go the same ways, in as many steps.
TEST(WedgeLayouts, HaveTheSameResults) {
  const auto shape = [](int, int, int) { return Cut::across_z; };
  const auto all = [](int i, int j, int k) {
    return i == 0 ? Cut::none : (j + k) % 2 == 0 ? Cut::pyramids : Cut::across_z;
  };
  const Point size{0.3, 0.3, 0.3};
  const std::array meshes{block_cut({3, 3, 3}, size, shape), block_cut({3, 3, 3}, size, shape, 0.15),
                          block_cut({3, 3, 3}, size, all, 0.15)};
  for (const HostMesh& mesh : meshes) {
    for (const HourglassControl form : {HourglassControl::none, HourglassControl::viscous, HourglassControl::stiffness,
                                        HourglassControl::assumed_strain}) {
      for (const Material& material : {elastic_material(), plastic_material("plastic", 3e8, 0)}) {
        Solver<double> first(worked(mesh, material, form));
        run(first);
        ASSERT_GT(first.steps(), 30);
        double moved = 0;
        for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
          moved = std::max(moved, size_of(minus(position_of(first, n), mesh.nodes[n])));
        ASSERT_GT(moved, 1e-3);
        for (int way = 1; way <= mixed_layout; ++way) {
          const HostMesh other = listed(mesh, way);
          Solver<double> solver(worked(other, material, form));
          run(solver);
          EXPECT_EQ(solver.steps(), first.steps()) << way;
          double worst = 0;
          for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
            worst = std::max(worst, size_of(minus(position_of(solver, n), position_of(first, n))));
          EXPECT_LT(worst, 1e-11 * moved) << way << " " << material.name << " " << static_cast<int>(form);
        }
      }
    }
  }
}

/// A wedge by itself, as it is listed and as a roof, and one beside a hexahedron.
TEST(WedgeLayouts, GiveEachNodeASixthOfTheMass) {
  HostMesh mesh;
  mesh.nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 2}, {1, 0, 2}, {0, 1, 2}};
  mesh.elements = {wedge(0, 1, 2, 3, 4, 5)};
  HostMesh roof = mesh;
  roof.elements = {{0, 3, 4, 1, 2, 5, 5, 2}};
  for (const HostMesh& of : {mesh, listed(mesh, 1), listed(mesh, 5), roof}) {
    const Model<double> model = build_model<double>(with(of, 1));
    ASSERT_EQ(model.node_mass.size(), 6u);
    for (const double mass : model.node_mass) EXPECT_NEAR(mass, 7850 / 6.0, 1e-12 * 7850);
  }
  const HostMesh beside =
      block_cut({2, 1, 1}, {2, 1, 1}, [](int i, int, int) { return i == 0 ? Cut::none : Cut::across_z; });
  const Model<double> model = build_model<double>(with(beside, 1));
  for (std::size_t n = 0; n < beside.nodes.size(); ++n) {
    const Point& x = beside.nodes[n];
    const double wedges = x[0] == 0 ? 0 : (x[0] == 1) == (x[1] == 0) ? 2 : 1, cubes = x[0] < 1.5 ? 1 : 0;
    EXPECT_NEAR(model.node_mass[model.node_of_scene_node[n]], 7850 * (cubes / 8 + wedges / 12), 1e-9) << n;
  }
}

/// Sums over elements count nodes as masses do.
TEST(WedgeLayouts, HaveTheMomentumOfTheirNodes) {
  const HostMesh mesh = listed(block_of_shapes({3, 4, 3}, 0.1, 0.15), mixed_layout);
  Scene scene = with(mesh, 1);
  scene.bodies[0].velocity = {3, -5, 7};
  scene.bodies[0].velocity_noise = 20;
  const Solver<double> solver(scene);
  const Model<double>& model = solver.model();
  Point momentum{};
  double turned = 0;
  for (std::size_t n = 0; n < model.node_mass.size(); ++n) {
    for (std::size_t k = 0; k < 3; ++k) momentum[k] += model.node_mass[n] * model.nodes.velocity_of(n)[k];
    turned += model.node_mass[n];
  }
  const BodySum sum = solver.body_sums().front();
  EXPECT_NEAR(sum.mass, turned, 1e-12 * turned);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(sum.momentum[k], momentum[k], 1e-12 * size_of(momentum)) << k;
}

/// A body that turns about its centre has no momentum: its centre is that of the masses of its nodes.
TEST(WedgeLayouts, TurnAboutTheCentreOfTheirNodes) {
  const HostMesh mesh = listed(block_of_shapes({3, 4, 3}, 0.1, 0.15), mixed_layout);
  Scene scene = with(mesh, 1);
  scene.bodies[0].angular_velocity = {40, -70, 100};
  const Solver<double> solver(scene);
  const double mass = 7850 * 0.3 * 0.4 * 0.3;
  for (const double p : solver.momentum()) EXPECT_NEAR(p, 0, 1e-12 * mass * 100 * 0.3);
}

/// A column of cut cubes on a plane, loaded at its end, at rest in the end: the load goes to nodes by their masses, a
/// third to those that two wedges have at the end, a sixth to the others, as a uniform stress has it.
TEST(WedgeLayouts, CarryALoadAsAUniformStress) {
  const HostMesh mesh = block_cut({1, 1, 6}, {1, 1, 6}, Cut::across_z);
  for (int way = 0; way <= mixed_layout; ++way) {
    const HostMesh of = listed(mesh, way);
    Scene scene = with(of, 0.2);
    scene.constraints = {{{0, 0, 0}, {0, 0, 1}, ""}};
    NodalLoad load;
    load.nodes = at(6, 2);
    load.force = {0, 0, -100};
    scene.loads = {load};
    scene.damping.mass = 1500;
    Solver<double> solver(scene);
    run(solver);
    for (std::size_t e = 0; e < of.elements.size(); ++e) {
      const auto stress = stress_of(solver, e);
      EXPECT_NEAR(stress[2], -100, 1e-3) << way << " " << e;
      for (const std::size_t c : {0, 1, 3, 4, 5}) EXPECT_NEAR(stress[c], 0, 1e-3) << way << " " << e;
    }
  }
}

/// A bar of wedges between planes that strikes another one: the wave in it stays plane, and comes when it has to.
TEST(WedgeLayouts, CarryAPlaneWaveInItsTime) {
  const int layers = 60;
  const double h = 0.1, speed = -1, length = layers * h;
  const HostMesh mesh = block_cut({2, 2, layers}, {2 * h, 2 * h, length}, Cut::across_z);
  const Material material = elastic_material();
  const double c = std::sqrt((material.bulk_modulus + 4 / 3.0 * material.shear_modulus) / material.density);
  for (const int way : {0, 2, mixed_layout}) {
    const HostMesh of = listed(mesh, way);
    Scene scene = with(of, 0.75 * length / c);
    scene.bodies[0].velocity = {0, 0, speed};
    for (const Point& normal : {Point{1, 0, 0}, Point{0, 1, 0}, Point{0, 0, 1}})
      scene.constraints.push_back({{0, 0, 0}, normal, ""});
    for (const Point& normal : {Point{1, 0, 0}, Point{0, 1, 0}})
      scene.constraints.push_back({{2 * h, 2 * h, 0}, normal, ""});
    scene.element.bulk_viscosity = true;
    Solver<double> solver(scene);
    run(solver);
    std::vector<double> least(layers + 1, 1e9), most(layers + 1, -1e9);
    double aside = 0;
    for (std::size_t n = 0; n < of.nodes.size(); ++n) {
      const double* const v = solver.model().nodes.velocity_of(solver.model().node_of_scene_node[n]);
      const auto layer = static_cast<std::size_t>(std::lround(of.nodes[n][2] / h));
      least[layer] = std::min(least[layer], v[2] / speed);
      most[layer] = std::max(most[layer], v[2] / speed);
      aside = std::max({aside, std::abs(v[0]), std::abs(v[1])});
    }
    EXPECT_LT(aside, 1e-10) << way;
    double behind = 0, front = 0;
    for (std::size_t k = 0; k <= layers; ++k) {
      EXPECT_LT(most[k] - least[k], 1e-10) << way << " " << k;
      if (k < 30) behind += most[k] / 30;
      if (k > 52) {
        EXPECT_NEAR(most[k], 1, 0.02) << way << " " << k;
      }
      if (most[k] < 0.5) front = static_cast<double>(k) / layers;
    }
    EXPECT_NEAR(behind, 0, 0.01) << way;
    EXPECT_NEAR(front, 0.75, 0.02) << way;
  }
}

/// Shaken and let go, at almost all of the step that the bound allows, without viscosity and damping. One by itself is
/// wide beside its height, so that its nodes are what bounds the step: eight corners would allow 6 % too much.
TEST(WedgeLayouts, AreStableAtTheirStep) {
  const auto across_z = [](int, int, int) { return Cut::across_z; };
  HostMesh wide, flat = block_cut({4, 4, 1}, {0.4, 0.4, 0.02}, across_z);
  wide.nodes = {{0, 0, 0}, {0.4, 0, 0}, {0.2, 0.1, 0}, {0, 0, 1}, {0.4, 0, 1}, {0.2, 0.1, 1}};
  wide.elements = {wedge(0, 1, 2, 3, 4, 5)};
  for (Point& x : flat.nodes) x = {x[0] + 0.5 * x[1], std::sqrt(0.75) * x[1], x[2]};  // equal sides
  const HostMesh skew = block_cut({3, 3, 3}, {0.3, 0.3, 0.3}, across_z, 0.2);
  for (const HostMesh& mesh : {wide, flat, skew}) {
    for (const double poisson_ratio : {0.0, 0.3, 0.45}) {
      Scene scene = with(mesh, 1e-2);
      scene.materials = {elastic_material("steel", poisson_ratio)};
      scene.bodies[0].velocity_noise = 1;
      scene.time.cfl = 0.99;
      scene.guard.energy_error = 1e30;
      Solver<double> solver(scene);
      const double begun = kinetic_energy(solver);
      double most = 0;
      while (!solver.at_end()) {
        solver.step();
        most = std::max(most, kinetic_energy(solver));
      }
      solver.finish();
      ASSERT_GT(solver.steps(), 500);
      EXPECT_LT(most, 3 * begun) << mesh.elements.size() << " " << poisson_ratio;
    }
  }
}

}  // namespace
}  // namespace pinball::test::wedge_layouts_test
