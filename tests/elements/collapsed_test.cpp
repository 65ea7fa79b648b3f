#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include <kernels/hourglass.hpp>
#include <kernels/pinball.hpp>
#include <solver/base/error.hpp>
#include <solver/base/faces.hpp>
#include <solver/contact/algorithm/contact_algorithm.hpp>
#include <solver/contact/surface/surface.hpp>
#include <solver/mesh/generators.hpp>
#include <solver/mesh/quality.hpp>
#include <tests/support/solver_case.hpp>

/// Hexahedra with repeated nodes: wedges, and what is left of one that loses more.
namespace pinball::collapsed_test {
namespace {

using namespace test;
using Hexahedra = std::vector<std::array<std::int32_t, 8>>;

/// Wedges of a steel cylinder and a steel sphere; elements on the axis are collapsed.
Body wedge_cylinder(const std::string& name, double angle, int radial, int layers, const Point& position = {}) {
  Body body = block(name, {1, 1, 1}, 1, position);
  body.mesh = CylinderMesh{
      .radius = 0.4, .length = 0.6, .section = Section::wedge, .angle = angle, .radial = radial, .layers = layers};
  return body;
}

Body wedge_sphere(const std::string& name, const Point& position, double grading = 1) {
  Body body = block(name, {1, 1, 1}, 1, position);
  body.mesh =
      SphereMesh{.radius = 0.5, .section = Section::wedge, .angle = 20, .core = {4, 6}, .ring = 3, .grading = grading};
  return body;
}

TEST(Collapsed, FacesOfAWedgeAreTwoTrianglesAndThreeQuadrilaterals) {
  // Each edge of a hexahedron collapsed together with one that is opposite to it in a face.
  for (int face = 0; face < 6; ++face)
    for (int side = 0; side < 2; ++side) {
      std::array<std::int32_t, 8> wedge{10, 11, 12, 13, 14, 15, 16, 17};
      const auto& f = face_nodes[face];
      wedge[f[side]] = wedge[f[side + 1]];
      wedge[f[(side + 3) % 4]] = wedge[f[side + 2]];
      const auto neighbours = face_neighbours({wedge});
      EXPECT_EQ(std::count(neighbours[0].begin(), neighbours[0].end(), -1), 5);
      EXPECT_EQ(neighbours[0][face], collapsed_face);
    }
}

TEST(Collapsed, TrianglesMeetWhicheverNodeIsRepeated) {
  // Two prisms on each other, each triangle with another corner twice: 0 1 2 below, 3 4 5 between, 6 7 8 above.
  const Hexahedra lower{
      {0, 1, 2, 2, 3, 4, 5, 5}, {0, 0, 1, 2, 3, 3, 4, 5}, {0, 1, 1, 2, 3, 4, 4, 5}, {0, 1, 2, 0, 3, 4, 5, 3}};
  const Hexahedra upper{
      {3, 4, 5, 5, 6, 7, 8, 8}, {3, 3, 4, 5, 6, 6, 7, 8}, {3, 4, 4, 5, 6, 7, 7, 8}, {3, 4, 5, 3, 6, 7, 8, 6}};
  for (const auto& a : lower)
    for (const auto& b : upper) {
      const auto neighbours = face_neighbours({a, b});
      EXPECT_EQ(neighbours[0][5], 1);
      EXPECT_EQ(neighbours[1][4], 0);
      EXPECT_EQ(std::count(neighbours[0].begin(), neighbours[0].end(), -1), 4);
      EXPECT_EQ(std::count(neighbours[1].begin(), neighbours[1].end(), -1), 4);
    }
}

TEST(Collapsed, AFoldedFaceIsRefused) {
  try {
    face_neighbours({{0, 1, 0, 3, 4, 5, 6, 7}});
    FAIL() << "a face with the same node at opposite corners was accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("element 0"), std::string::npos) << error.what();
  }
}

TEST(Collapsed, QualityOfAPrismIsThatOfItsCorners) {
  Mesh prism;
  const double s = std::sqrt(0.75);
  prism.nodes = {{0, 0, 0}, {1, 0, 0}, {0.5, s, 0}, {0, 0, 2}, {1, 0, 2}, {0.5, s, 2}};
  prism.hexahedra = {{0, 1, 2, 2, 3, 4, 5, 5}};
  const MeshQuality q = measure_quality(prism);
  EXPECT_NEAR(q.volume, s, 1e-15);
  EXPECT_EQ(q.inverted, 0);
  EXPECT_NEAR(q.min_scaled_jacobian, s, 1e-15);  // the sine of 60 degrees
  EXPECT_NEAR(q.min_edge, 1, 1e-15);
  EXPECT_NEAR(q.max_aspect_ratio, 2, 1e-15);
  std::swap(prism.nodes[0], prism.nodes[1]);
  std::swap(prism.nodes[3], prism.nodes[4]);
  EXPECT_EQ(measure_quality(prism).inverted, 1);
}

TEST(Collapsed, LinearVelocityFieldsGiveTheirGradientAndNoHourglassRate) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(-1, 1);
  const Mesh mesh =
      generate_sphere({.radius = 2, .section = Section::wedge, .angle = 35, .core = {3, 5}, .ring = 2, .grading = 0.3});
  for (const auto& hexahedron : mesh.hexahedra) {
    double g[3][3];
    for (auto& row : g)
      for (double& c : row) c = number(random);
    Vec3<double> x[8], v[8];
    for (int i = 0; i < 8; ++i) {
      const Point& p = mesh.nodes[static_cast<std::size_t>(hexahedron[i])];
      const auto component = [&](int r) { return g[r][0] * p[0] + g[r][1] * p[1] + g[r][2] * p[2] + r; };
      x[i] = {p[0], p[1], p[2]};
      v[i] = {component(0), component(1), component(2)};
    }
    const auto xm = to_modes(x), vm = to_modes(v);
    const auto b = uniform_gradient(xm);
    const Tensor<double> L = velocity_gradient(b, vm, 1 / hexahedron_volume(b, xm));
    const Vec3<double> rows[3] = {L.row_x, L.row_y, L.row_z};
    for (int r = 0; r < 3; ++r) {
      EXPECT_NEAR(rows[r].x, g[r][0], 1e-11);
      EXPECT_NEAR(rows[r].y, g[r][1], 1e-11);
      EXPECT_NEAR(rows[r].z, g[r][2], 1e-11);
    }
    for (int a = 0; a < 4; ++a) {
      const Vec3<double> h = hourglass_rate(L, xm, vm, a);
      EXPECT_NEAR(dot(h, h), 0, 1e-24);
    }
  }
}

TEST(Collapsed, UniformStrainGivesUniformStressAndNoForceInside) {  // the patch test, on wedges
  Scene scene = scene_of({wedge_cylinder("a", 30, 4, 5)}, 1.0, false);
  scene.guard.energy_error = 1e30;
  Solver<double> solver(scene);
  const std::array<Point, 3> g{{{1e-4, 4e-5, 2e-5}, {-3e-5, -5e-5, 2e-5}, {3e-5, 1e-5, 2e-5}}};
  PrescribedMotion motion(solver, [&](const Point& x0, double t) {
    Point x = x0;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) x[i] += t / 1e-4 * g[i][j] * x0[j];
    }
    return x;
  });
  while (solver.force_time() < 2e-4) motion.step();
  const auto first = stress_of(solver, 0);
  double scale = 0, worst = 0;
  for (const double s : first) scale = std::max(scale, std::abs(s));
  ASSERT_GT(scale, 1e7);
  for (std::size_t e = 0; e < solver.mesh().hexahedra.size(); ++e) {
    for (std::size_t c = 0; c < 6; ++c) worst = std::max(worst, std::abs(stress_of(solver, e)[c] - first[c]));
  }
  EXPECT_LT(worst, 1e-9 * scale);
}

TEST(Collapsed, MassOfANodeIsThatOfAllItsCorners) {
  const Scene scene = scene_of({wedge_cylinder("a", 30, 1, 1)}, 1.0, false);
  const Solver<double> solver(scene);
  const auto& model = solver.model();
  ASSERT_EQ(model.mesh.hexahedra.size(), 1u);
  ASSERT_EQ(model.mesh.nodes.size(), 6u);
  const double mass = model.element_mass[0];
  EXPECT_NEAR(mass, 7850 * 0.5 * 0.16 * 0.5 * 0.6, 1e-9);
  double sum = 0;
  for (std::size_t n = 0; n < 6; ++n) {
    const bool on_axis = model.mesh.nodes[n][0] == 0;
    const double m = model.node_mass[static_cast<std::size_t>(model.node_of_scene_node[n])];
    EXPECT_NEAR(m, (on_axis ? 0.25 : 0.125) * mass, 1e-12 * mass);
    sum += m;
  }
  EXPECT_NEAR(sum, mass, 1e-12 * mass);
}

TEST(Collapsed, SurfaceHasTheOuterFacesAlone) {
  const Scene scene = scene_of({wedge_cylinder("a", 30, 3, 4)}, 1.0, false);
  const Model<double> model = build_model<double>(scene);
  const Surface surface(surface_topology(model));
  int exposed = 0;
  for (std::size_t e = 0; e < model.mesh.hexahedra.size(); ++e) {
    for (unsigned bits = surface.exposed(model.slot_of_element[e]); bits != 0; bits &= bits - 1) ++exposed;
  }
  EXPECT_EQ(exposed, 2 * 12 + 2 * 3 + 4);  // both sides of the wedge, its ends, and its rim
}

/// Kinetic energy may not grow and the balance not drift over many periods of the highest mode at the largest step.
template <class S>
void expect_stable(Scene scene, double cfl, int steps, double tolerance) {
  scene.time.cfl = cfl;
  scene.time.end = 1;
  scene.time.steps = steps;
  scene.bodies[0].velocity_noise = 0.01;  // strains of 1e-5: a linear vibration
  Solver<S> solver(scene);
  double worst = 0;
  for (int i = 0; i < steps; ++i) {
    solver.step();
    worst = std::max(worst, std::abs(static_cast<double>(solver.balance_error())));
  }
  EXPECT_LT(worst, tolerance) << "cfl " << cfl;
}

TEST(Collapsed, NoiseInAWedgeMeshKeepsItsEnergyAtTheLargestStep) {
  for (const HourglassControl control : {HourglassControl::none, HourglassControl::stiffness}) {
    for (const double angle : {5.0, 30.0, 60.0}) {
      Scene scene = scene_of({wedge_cylinder("a", angle, 3, 4)}, 1, false);
      scene.element.hourglass = control;
      expect_stable<double>(scene, 0.99, 5000, 1e-3);
    }
    Scene scene = scene_of({wedge_sphere("a", {}, 0.3)}, 1, false);
    scene.element.hourglass = control;
    expect_stable<double>(scene, 0.99, 5000, 1e-3);
  }
  expect_stable<float>(scene_of({wedge_cylinder("a", 10, 3, 4)}, 1, false), 0.99, 2000, 1e-2);
}

TEST(Collapsed, BoundOfASingleWedgeIsSafe) {  // nothing else holds it
  for (const double angle : {1.0, 10.0, 60.0})
    expect_stable<double>(scene_of({wedge_cylinder("a", angle, 1, 1)}, 1, false), 0.99, 20000, 1e-3);
}

TEST(Collapsed, VibratingWedgesKeepEnergyAndMomentum) {
  Scene scene = scene_of({wedge_sphere("a", {1, 2, 3})}, 3e-3, false);
  scene.bodies[0].velocity_gradient = {{{50, 20, 0}, {0, -30, 10}, {40, 0, 0}}};
  scene.bodies[0].velocity = {3, -2, 1};
  Solver<double> solver(scene);
  const Point before = solver.momentum();
  double worst = 0, mass = 0;
  run_to_end(solver, [&] { worst = std::max(worst, std::abs(solver.balance_error())); });
  for (const double m : solver.model().element_mass) mass += m;
  ASSERT_GT(solver.steps(), 300);
  EXPECT_LT(worst, 1e-4);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(solver.momentum()[k], before[k], 1e-12 * 4 * mass);
}

TEST(Collapsed, PinballsOfWedgesKeepMomentumAndEnergy) {
  Scene scene = scene_of({wedge_sphere("a", {0, 0, 0}), wedge_sphere("b", {0, 0, 1})}, 6e-3);
  scene.bodies[0].velocity = {0, 0, 20};
  scene.time.cfl = 0.3;
  Solver<double> solver(scene);
  const Point before = solver.momentum();
  double worst = 0, stored = 0;
  run_to_end(solver, [&] {
    worst = std::max(worst, std::abs(solver.balance_error()));
    stored = std::max(stored, solver.energies().contact_stored);
  });
  EXPECT_GT(stored, 0);
  EXPECT_EQ(solver.energies().contact_stored, 0);
  EXPECT_LT(worst, 2e-2);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(solver.momentum()[k], before[k], 1e-12 * before[2]);
  EXPECT_GT(history_row(solver).bodies[1].velocity[2], 10);
}

TEST(Collapsed, PlanesOfSymmetryThroughTheAxisHoldIt) {
  Scene scene = scene_of({wedge_cylinder("a", 30, 3, 6)}, 1e-3, false);
  scene.bodies[0].velocity_gradient = {{{-30, 0, 0}, {0, -30, 0}, {0, 0, 60}}};
  scene.constraints.push_back({{}, {0, 1, 0}, ""});
  scene.constraints.push_back({{}, {-0.5, std::sqrt(0.75), 0}, ""});
  Solver<double> solver(scene);
  run(solver);
  for (std::size_t n = 0; n < solver.mesh().nodes.size(); ++n) {
    const Point x = position_of(solver, n), start = solver.mesh().nodes[n];
    if (start[0] == 0) {
      EXPECT_NEAR(x[0], 0, 1e-15);
      EXPECT_NEAR(x[1], 0, 1e-15);
    } else {
      EXPECT_NEAR(x[1] * start[0], x[0] * start[1], 1e-14);
    }
  }
}

}  // namespace
}  // namespace pinball::collapsed_test
