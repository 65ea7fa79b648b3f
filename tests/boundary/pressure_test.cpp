#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <utility>

#include <kernels/boundary/face_pressure.hpp>
#include <solver/base/point.hpp>
#include <solver/model/selection/pressed_faces.hpp>
#include <tests/support/solver_case.hpp>

/// Pressure on faces: against closed forms, and following what it presses on.
namespace pinball::pressure_test {
namespace {

using namespace test;

Pressure pressure_on(const std::string& body, double value) {
  Pressure pressure;
  pressure.name = "gas";
  pressure.faces.where = "here";
  pressure.faces.body = body;
  pressure.pressure = value;
  return pressure;
}

std::vector<Point> positions(const Solver<double>& solver) {
  std::vector<Point> all;
  for (std::size_t n = 0; n < solver.mesh().nodes.size(); ++n) all.push_back(position_of(solver, n));
  return all;
}

Point area_of(const std::vector<Point>& x, const std::array<int, 4>& corners) {
  const Point a = cross(minus(x[corners[2]], x[corners[0]]), minus(x[corners[3]], x[corners[1]]));
  return {a[0] / 2, a[1] / 2, a[2] / 2};
}

/// Whatever it had before: all numbers of the face of an element that has eroded.
TEST(Pressure, OfAFaceWhoseElementIsErodedIsNone) {
  const std::vector<double> position{0, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0.5, 0, 0, 1, 0, 0}, mass{0.0, 2.0};
  const std::vector<std::int64_t> element{0, 1};
  const std::vector<std::int32_t> corners{0, 1, 2, 3, 0, 1, 2, 3};
  std::vector<double> force(24, 7.0), x = position;
  NodeArrays<double> nodes;
  nodes.position = x.data();
  nodes.element_mass = mass.data();
  const PressFaces<double> press{nodes, element.data(), corners.data(), 3.0, force.data()};
  for (const std::int64_t face : {0, 1}) press(face);
  for (std::size_t i = 0; i < 12; ++i) EXPECT_EQ(force[i], 0) << i;
  double along = 0;
  for (std::size_t i = 0; i < 4; ++i) along += force[12 + 3 * i + 2];
  EXPECT_NEAR(along, -3, 1e-14) << "the other one is of area 1 seen along z";
}

/// Of a block by itself each face that looks out, once, with its corners counterclockwise seen from there.
TEST(Pressure, OnABodyIsOnEveryExposedFaceOnce) {
  const double h = 0.1;
  const Model<double> model =
      build_model<double>(scene_of({block("other", {1, 1, 1}, h, {-1, 0, 0}), block("a", {2, 3, 2}, h, {0, 0, 0})}, 1));
  const std::vector<PressedFace> faces = pressed_faces(model.mesh, {}, pressure_on("a", 1));
  EXPECT_EQ(faces.size(), 2U * (6 + 6 + 4));
  std::set<std::pair<std::int64_t, std::array<std::int32_t, 4>>> different;
  Point outwards{};
  double volume = 0;
  for (const PressedFace& face : faces) {
    std::array<std::int32_t, 4> key = face.corners;
    std::sort(key.begin(), key.end());
    different.insert({face.element, key});
    Point middle{};
    for (const std::int32_t node : face.corners) {
      for (std::size_t k = 0; k < 3; ++k) middle[k] += model.mesh.nodes[static_cast<std::size_t>(node)][k] / 4;
    }
    const auto corner = [&](std::size_t i) { return model.mesh.nodes[static_cast<std::size_t>(face.corners[i])]; };
    Point area = cross(minus(corner(2), corner(0)), minus(corner(3), corner(1)));
    for (double& component : area) component /= 2;
    EXPECT_NEAR(norm(area), h * h, 1e-15);
    EXPECT_EQ(model.mesh.body[static_cast<std::size_t>(face.element)], 1);
    EXPECT_NEAR(dot(area, minus(middle, element_centre(model.mesh, static_cast<std::size_t>(face.element)))),
                h * h * h / 2, 1e-15);
    for (std::size_t k = 0; k < 3; ++k) outwards[k] += area[k];
    volume += dot(area, middle) / 3;
  }
  EXPECT_EQ(different.size(), faces.size());
  EXPECT_NEAR(norm(outwards), 0, 1e-15);
  EXPECT_NEAR(volume, 12 * h * h * h, 1e-15);
}

/// Two cubes, one on the other, of which the upper one is cut into six tetrahedra: there two triangles lie on a
/// quadrangle.
ModelMesh half_cut_mesh() {
  ModelMesh mesh = build_model<double>(scene_of({block("a", {1, 1, 2}, 1, {0, 0, 0})}, 1)).mesh;
  const std::array<std::int32_t, 8> upper = mesh.hexahedra[1];
  mesh.hexahedra.pop_back();
  for (const auto& [a, b] : {std::pair{1, 2}, {2, 3}, {3, 7}, {7, 4}, {4, 5}, {5, 1}}) {
    mesh.hexahedra.push_back({upper[0], upper[a], upper[b], upper[b], upper[6], upper[6], upper[6], upper[6]});
  }
  mesh.body.assign(mesh.hexahedra.size(), 0);
  return mesh;
}

/// The outside is that of a box of height 2, closed: what lies inside is no face of it.
TEST(Pressure, IsNotBetweenAQuadrangleAndItsTwoTriangles) {
  ModelMesh mesh = half_cut_mesh();
  const std::vector<PressedFace> faces = pressed_faces(mesh, {}, pressure_on("a", 1));
  EXPECT_EQ(faces.size(), 5U + 10U);
  for (const PressedFace& face : faces) {
    const bool inside = std::ranges::all_of(face.corners, [&](std::int32_t n) { return mesh.nodes[n][2] == 1; });
    EXPECT_FALSE(inside) << "of element " << face.element;
  }
  const auto node = [&](const Point& x) {
    return static_cast<std::int32_t>(std::ranges::find(mesh.nodes, x) - mesh.nodes.begin());
  };
  const std::int32_t a = node({0, 0, 1}), b = node({1, 0, 1}), c = node({1, 1, 1}), d = node({0, 1, 1});
  FileNodes file;
  file.path = "a.k";
  file.face_sets = {{1, "quadrangle", {{a, b, c, d}}, ""},
                    {2, "triangles", {{a, b, c, c}, {a, c, d, d}}, ""},
                    {3, "top", {{node({0, 0, 2}), node({1, 0, 2}), node({1, 1, 2}), node({1, 1, 2})}}, ""}};
  mesh.files = {file};
  mesh.file_of_body = {0};
  Pressure pressure = pressure_on("a", 1);
  for (const char* const set : {"quadrangle", "triangles"}) {
    pressure.faces.set = set;
    EXPECT_THAT(error_of([&] { pressed_faces(mesh, {}, pressure); }), testing::HasSubstr("lies between two")) << set;
  }
  pressure.faces.set = "top";
  EXPECT_EQ(pressed_faces(mesh, {}, pressure).size(), 1U);
}

/// The faces of a set, whatever a set of nodes of the same name has, and of them those that all else selects.
TEST(Pressure, OnASetOfFacesIsOnThese) {
  ModelMesh mesh = build_model<double>(scene_of({block("a", {2, 1, 1}, 1, {0, 0, 0})}, 1)).mesh;
  const auto node = [&](const Point& x) {
    return static_cast<std::int32_t>(std::ranges::find(mesh.nodes, x) - mesh.nodes.begin());
  };
  const std::array<std::int32_t, 4> left{node({0, 0, 1}), node({1, 0, 1}), node({1, 1, 1}), node({0, 1, 1})},
      right{node({1, 0, 1}), node({2, 0, 1}), node({2, 1, 1}), node({1, 1, 1})};
  FileNodes file;
  file.path = "a.k";
  file.sets = {{1, "1", {0}}};
  file.face_sets = {{1, "1", {left, right}, ""}};
  mesh.files = {file};
  mesh.file_of_body = {0};
  Pressure pressure = pressure_on("a", 1);
  pressure.faces.set = "1";
  const std::vector<PressedFace> both = pressed_faces(mesh, {}, pressure);
  ASSERT_EQ(both.size(), 2U);
  EXPECT_EQ(both[0].element, 0);
  EXPECT_EQ(both[1].element, 1);
  pressure.faces.plane = Plane{{1, 0, 0}, {1, 0, 0}};
  EXPECT_THROW(pressed_faces(mesh, {}, pressure), InputError);
}

/// Of any warped face, by Gauss' rule with 3 x 3 points, exact for it: p N_i over dx/dxi x dx/deta, inwards.
TEST(Pressure, OnEachCornerOfAWarpedFaceIsItsIntegral) {
  std::mt19937 random(17);
  std::uniform_real_distribution<double> any(-1, 1);
  const double point[3] = {-std::sqrt(0.6), 0, std::sqrt(0.6)}, weight[3] = {5.0 / 9, 8.0 / 9, 5.0 / 9};
  const double xi_of[4] = {-1, 1, 1, -1}, eta_of[4] = {-1, -1, 1, 1}, p = 2.5;
  for (int sample = 0; sample < 20; ++sample) {
    std::vector<double> position(16);
    for (double& x : position) x = 5 + any(random);
    const std::vector<std::int32_t> corners{2, 0, 3, 1};
    double force[12];
    pressure_on_corners(position.data(), corners.data(), p, force);
    double expected[12] = {};
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) {
        Point along_xi{}, along_eta{};
        for (std::size_t i = 0; i < 4; ++i) {
          for (std::size_t k = 0; k < 3; ++k) {
            const double x = position[4 * static_cast<std::size_t>(corners[i]) + k];
            along_xi[k] += 0.25 * xi_of[i] * (1 + eta_of[i] * point[b]) * x;
            along_eta[k] += 0.25 * eta_of[i] * (1 + xi_of[i] * point[a]) * x;
          }
        }
        const Point area = cross(along_xi, along_eta);
        for (std::size_t i = 0; i < 4; ++i) {
          const double shape = 0.25 * (1 + xi_of[i] * point[a]) * (1 + eta_of[i] * point[b]);
          for (std::size_t k = 0; k < 3; ++k) expected[3 * i + k] -= p * shape * weight[a] * weight[b] * area[k];
        }
      }
    }
    for (std::size_t i = 0; i < 12; ++i) EXPECT_NEAR(force[i], expected[i], 1e-13) << i;
  }
}

/// Faces of a sphere's mesh are warped, and trapezoids: a quarter of the area on each corner has a moment.
TEST(Pressure, OnAClosedSurfaceHasNeitherForceNorMoment) {
  Body ball;
  ball.name = "ball";
  ball.material = "steel";
  SphereMesh mesh;
  mesh.radius = 0.5;
  mesh.section = Section::full;
  mesh.core = {3, 3};
  mesh.ring = 2;
  mesh.grading = 0.7;
  ball.mesh = mesh;
  ball.position = {0.3, -2, 1};
  Scene scene = scene_of({ball}, 1e-4, false);
  scene.pressures = {pressure_on("ball", 1e7)};
  Solver<double> solver(scene);
  solver.step();
  const double impulse = 1e7 * 4 * M_PI * 0.25 * solver.dt() / 2;
  Point moment{}, sum{};
  double radial = 0;
  for (std::size_t n = 0; n < solver.mesh().nodes.size(); ++n) {
    const double mass = solver.model().node_mass[solver.model().node_of_scene_node[n]];
    const Point v = velocity_of(solver, n), turn = cross(solver.mesh().nodes[n], v);
    for (std::size_t k = 0; k < 3; ++k) {
      sum[k] += mass * v[k];
      moment[k] += mass * turn[k];
    }
    radial += mass * dot(v, minus(solver.mesh().nodes[n], ball.position));
  }
  EXPECT_LT(norm(sum), 1e-13 * impulse);
  EXPECT_LT(norm(moment), 1e-13 * impulse);
  double volume = 0;
  for (const double mass : solver.model().element_mass) volume += mass / 7850;
  EXPECT_NEAR(radial, -1e7 * 3 * volume * solver.dt() / 2, 1e-12 * impulse) << "inwards";
  EXPECT_LT(norm(solver.boundary().pressures().at(0).force), 1e-13 * impulse / solver.dt());
}

/// An end of a long bar in uniaxial strain: the wave has the stress p, and what it has passed the velocity p/(rho c).
TEST(Pressure, OnABarMakesTheWaveOfTheWaveEquation) {
  const double h = 0.05, p = 1e6, c = std::sqrt(2.1e11 / 7850);
  const int elements = 100;
  Scene scene = scene_of({block("a", {1, 1, elements}, h, {0, 0, 0})}, 0.6 * elements * h / c, false);
  scene.materials = {elastic_material("steel", 0.0)};
  scene.element.bulk_viscosity = true;
  FixedConstraint sides;  // the viscosity presses sideways
  sides.nodes.body = "a";
  sides.directions = {{1, 0, 0}, {0, 1, 0}};
  scene.fixed_constraints = {sides};
  Pressure end = pressure_on("a", p);
  end.faces.plane = Plane{{0, 0, 0}, {0, 0, 1}};
  scene.pressures = {end};
  Solver<double> solver(scene);
  const double worst = worst_balance_of_run(solver);
  EXPECT_LT(worst, 1e-3);
  EXPECT_NEAR(solver.momentum()[2], p * h * h * scene.time.end, 1e-12 * p * h * h * scene.time.end);
  double velocity = 0, stress = 0;
  for (std::size_t e = 10; e < 50; ++e) {  // behind the front, which is at 60, and not at the end
    velocity += velocity_of(solver, 4 * e)[2] / 40;
    stress += stress_of(solver, e)[2] / 40;
  }
  EXPECT_NEAR(velocity, p / (7850 * c), 1e-3 * p / (7850 * c));
  EXPECT_NEAR(stress, -p, 1e-3 * p);
  EXPECT_NEAR(solver.boundary().pressures()[0].work, solver.energies().external, 1e-12 * solver.energies().external);
}

TEST(Pressure, FollowsTheFaceThatItActsOn) {
  Scene scene = scene_of({block("a", {1, 1, 1}, 0.1, {0, 0, 0})}, 1e-3, false);
  scene.bodies[0].angular_velocity = {300, 200, -900};
  Pressure side = pressure_on("a", 2e5);
  side.faces.plane = Plane{{0.1, 0, 0}, {1, 0, 0}};
  scene.pressures = {side};
  Solver<double> solver(scene);
  const double worst = [&] {
    double largest = 0;
    while (!solver.at_end()) {
      const std::vector<Point> x = positions(solver);
      solver.step();
      const Point area = area_of(x, {1, 3, 7, 5}), force = solver.boundary().pressures()[0].force;
      for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(force[k], -2e5 * area[k], 1e-9 * 2e5 * 0.01);
      largest = std::max(largest, std::abs(solver.balance_error()));
    }
    return largest;
  }();
  const Point area = area_of(positions(solver), {1, 3, 7, 5});
  EXPECT_LT(area[0], 0.008) << "it has turned";
  EXPECT_LT(worst, 1e-3);
}

TEST(Pressure, BeginsWhenItArrivesAndVariesFromThenOn) {
  Scene scene = scene_of({block("a", {1, 1, 1}, 0.1, {0, 0, 0})}, 1e-3, false);
  Pressure side = pressure_on("a", 1e5);
  side.faces.plane = Plane{{0.1, 0, 0}, {1, 0, 0}};
  side.table = {{0, 1e-3}, {1, 0}};
  side.start = 4e-4;
  scene.pressures = {side};
  Solver<double> solver(scene);
  while (!solver.at_end()) {
    solver.step();
    const double t = solver.force_time(), factor = t < 4e-4 ? 0 : 1 - (t - 4e-4) / 1e-3;
    const bool begins = std::abs(t - 4e-4) < 0.5 * solver.dt();  // with its part of the step
    if (!begins) {
      EXPECT_NEAR(solver.boundary().pressures()[0].force[0], -factor * 1e3, 1e-2) << t;
    }
  }
  const double of_last_half_step = solver.dt() * solver.dt() / 8 * 1e6;  // it has the value at its end
  solver.finish();
  EXPECT_NEAR(solver.momentum()[0], -1e3 * 0.7 * 6e-4 + of_last_half_step, 1e-7) << "of a mean factor of 0.7";
}

TEST(Pressure, GoesWithErodedElements) {
  Scene scene = scene_of({block("a", {4, 1, 1}, 0.1, {0, 0, 0})}, 1e-4, false);
  scene.materials = {plastic_material("steel", 1e12, 1)};
  Pressure top = pressure_on("a", 1e5);
  top.faces.plane = Plane{{0, 0, 0.1}, {0, 0, 1}};
  scene.pressures = {top};
  Solver<double> solver(scene);
  solver.step();
  EXPECT_NEAR(solver.boundary().pressures()[0].force[2], -4e3, 1e-6);
  strain_to_failure(solver, {1});
  solver.step();
  solver.step();
  EXPECT_EQ(solver.counts().eroded_elements(), 1);
  EXPECT_NEAR(solver.boundary().pressures()[0].force[2], -3e3, 1e-1);
}

Scene pressed_plate() {
  Scene scene = scene_of({block("a", {40, 30, 2}, 0.1, {0, 0, 0})}, 2e-4, false);
  Pressure top = pressure_on("a", 5e7);
  top.faces.plane = Plane{{0, 0, 0.2}, {0, 0, 1}};
  Pressure side = pressure_on("a", -3e7);
  side.name = "other";
  side.faces.plane = Plane{{0, 0, 0}, {1, 0, 0}};
  scene.pressures = {top, side};
  return scene;
}

TEST(Pressure, HasTheSameBitsForAnyNumberOfThreads) {
  const auto outcome = [](int threads) {
    DefaultExecutionSpace::set_concurrency(threads);
    Solver<double> solver(pressed_plate());
    run(solver);
    DefaultExecutionSpace::set_concurrency(1);
    return std::pair{state_hash(solver.model()), solver.energies().external};
  };
  const auto one = outcome(1);
  for (const int threads : {2, 3, 8}) EXPECT_EQ(outcome(threads), one) << threads;
}

TEST(Pressure, ActsWithSubcyclingToo) {
  Scene scene = pressed_plate();
  scene.bodies[0].mesh = BlockMesh{{1, 1, 1}, {4, 4, 20}};
  scene.pressures.resize(1);
  scene.pressures[0].faces.plane = Plane{{0, 0, 1}, {0, 0, 1}};
  scene.time.subcycling = true;
  Solver<double> solver(scene);
  run(solver);
  // The face shrinks as the plate bulges: a pressure that were lost in some steps would miss far more.
  EXPECT_NEAR(solver.momentum()[2], -5e7 * 2e-4, 1e-3 * 5e7 * 2e-4);
}

TEST(Pressure, WithoutFacesIsAnError) {
  Scene scene = scene_of({block("a", {2, 2, 2}, 0.1, {0, 0, 0})}, 1e-4, false);
  Pressure inside = pressure_on("a", 1);
  inside.faces.plane = Plane{{0.1, 0, 0}, {1, 0, 0}};
  scene.pressures = {inside};
  EXPECT_THAT(input_error_of(scene),
              testing::HasSubstr("here: expected at least one face, there is none on the plane"));
}

}  // namespace
}  // namespace pinball::pressure_test
