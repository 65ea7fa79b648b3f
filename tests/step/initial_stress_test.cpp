#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <solver/step/report.hpp>
#include <tests/support/law_materials.hpp>
#include <tests/support/saved_state.hpp>
#include <tests/support/solver_case.hpp>

/// [[initial_stress]]: stays where it is in equilibrium, and sets off the waves of theory where it is not.
namespace pinball::initial_stress_test {
namespace {

using namespace test;
using testing::HasSubstr;

constexpr double young = 2.1e11, poisson = 0.3, density = 7850;

InitialStress stress_in(const std::string& body, const Point& stress, const Point& shear = {}) {
  InitialStress given;
  given.nodes.body = body;
  given.nodes.where = "here";
  given.stress = stress;
  given.shear_stress = shear;
  return given;
}

/// A block that lies askew under a pressure on all of its faces, with the stress of that.
Scene pressed_all_around(const Material& material, ElementShape shape) {
  Scene scene = scene_of({block("a", {3, 4, 5}, 0.1, {0.1, 0.2, 0.3})}, 1e-3, false);
  scene.materials = {material};
  scene.bodies[0].material = material.name;
  scene.bodies[0].elements = shape;
  scene.bodies[0].axis = Point{1 / std::sqrt(14.0), 2 / std::sqrt(14.0), 3 / std::sqrt(14.0)};
  scene.initial_stresses = {stress_in("a", {-1e8, -1e8, -1e8})};
  Pressure around;
  around.name = "around";
  around.faces.body = "a";
  around.pressure = 1e8;
  scene.pressures = {around};
  return scene;
}

TEST(InitialStress, StaysStillUnderTheForcesThatItBears) {
  const double wave = std::sqrt(young / density), speed = 1e8 / (density * wave);
  Material hard = plastic_material("hard", 1e9, 0);
  Material granular = soil_material("granular");
  granular.equation_of_state.reset();
  for (const Material& material : {elastic_material(), hard, granular}) {
    for (const ElementShape shape : {ElementShape::hexahedra, ElementShape::tetrahedra}) {
      for (const HourglassControl control : {HourglassControl::assumed_strain, HourglassControl::viscous}) {
        Scene scene = pressed_all_around(material, shape);
        scene.element.hourglass = control;
        Solver<double> solver(scene);
        run(solver);
        EXPECT_GT(solver.steps(), 10);
        const FieldSnapshot state = snapshot(solver);
        for (const Point& v : state.velocity) EXPECT_LT(norm(v), 1e-10 * speed) << material.name;
        EXPECT_NEAR(solver.energies().internal, 60e-3 * 1e16 / (2 * material.bulk_modulus),
                    1e-9 * solver.energies().internal);
      }
    }
  }
}

/// A bar of 100 elements whose nodes move along it alone, with a stress that its first end bears and its last does not.
Scene released_bar(double stress, const Material& material = elastic_material()) {
  Scene scene = scene_of({block("bar", {1, 1, 100}, 0.01, {0, 0, 0}, {}, material.name)}, 1.4e-4, false);
  scene.materials = {material};
  const double lateral = stress * poisson / (1 - poisson);
  scene.initial_stresses = {stress_in("bar", {lateral, lateral, stress})};
  FixedConstraint along;
  along.nodes.body = "bar";
  along.directions = {{1, 0, 0}, {0, 1, 0}};
  FixedConstraint end;
  end.nodes.plane = Plane{{0, 0, 0}, {0, 0, 1}};
  end.directions = {{0, 0, 1}};
  scene.fixed_constraints = {along, end};
  return scene;
}

/// Its last end moves with sigma/(rho c) until the wave has come back, which is after 3.4e-4 s.
TEST(InitialStress, LeavesTheFreeEndOfABarWithTheSpeedOfTheory) {
  const double modulus = young * (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson)),
               wave = std::sqrt(modulus / density);
  for (const Material& material : {elastic_material(), plastic_material("hard", 1e9, 0)}) {
    for (const double stress : {1e7, -1e7}) {
      Solver<double> solver(released_bar(stress, material));
      solver.step();
      const double energy = 1e-4 * stress * stress / (2 * modulus);  // of the volume
      EXPECT_NEAR(solver.energies().internal / energy, 1, 1e-6);
      const auto end_of = [&] { return snapshot(solver).position.back()[2]; };
      while (solver.time() < 0.2e-4) solver.step();
      const double begun = solver.time(), before = end_of();
      while (solver.time() < 1.2e-4) solver.step();
      const double speed = (end_of() - before) / (solver.time() - begun);
      EXPECT_NEAR(speed / (-stress / (density * wave)), 1, 5e-3) << material.name << " " << stress;
      EXPECT_LT(std::abs(solver.balance_error()), 1e-2);
    }
  }
}

/// What is not borne is gone at rest: the bar is shorter by s/E, and nothing is stored.
TEST(InitialStress, RelaxesInABarThatNothingHolds) {
  constexpr double stress = 1e8, length = 1.2;
  for (const Material& material : {elastic_material(), plastic_material("hard", 1e9, 0)}) {
    Scene scene = scene_of({block("bar", {2, 2, 12}, 0.1, {0, 0, 0}, {}, material.name)}, 6e-3, false);
    scene.materials = {material};
    scene.initial_stresses = {stress_in("bar", {0, 0, stress})};
    scene.damping.mass = 6000;
    Solver<double> solver(scene);
    solver.step();
    const double stored = solver.energies().internal;
    EXPECT_NEAR(stored / (0.04 * length * stress * stress / (2 * young)), 1, 1e-9);
    run(solver);
    const FieldSnapshot state = snapshot(solver);
    for (const auto& s : state.stress) EXPECT_LT(std::abs(s[2]), 1e-4 * stress) << material.name;
    const double shorter = length - (state.position.back()[2] - state.position.front()[2]);
    EXPECT_NEAR(shorter / (length * stress / young), 1, 2e-3) << material.name;
    EXPECT_LT(std::abs(solver.energies().internal), 5e-3 * stored) << material.name;
  }
}

/// Turned with its body, an unequal state moves in the same way.
TEST(InitialStress, KnowsNoDirection) {
  const Point axis{1 / std::sqrt(14.0), 2 / std::sqrt(14.0), 3 / std::sqrt(14.0)};
  const auto kinetic = [](const std::optional<Point>& along, const Point& stress, const Point& shear) {
    Scene scene = scene_of({block("a", {3, 4, 5}, 0.1, {0, 0, 0})}, 2e-4, false);
    scene.bodies[0].axis = along;
    scene.initial_stresses = {stress_in("a", stress, shear)};
    Solver<double> solver(scene);
    run(solver);
    return solver.energies().kinetic;
  };
  // The shortest rotation of z onto the axis: R = 1 + K + K^2/(1 + z . axis), K of z x axis.
  const double c = 1 / (1 + axis[2]), x = axis[0], y = axis[1];
  const double r[3][3] = {{1 - c * x * x, -c * x * y, x}, {-c * x * y, 1 - c * y * y, y}, {-x, -y, axis[2]}};
  const double s[3][3] = {{1e8, 3e7, -2e7}, {3e7, -5e7, 4e7}, {-2e7, 4e7, 2e8}};
  double t[3][3] = {};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      for (int k = 0; k < 3; ++k) {
        for (int l = 0; l < 3; ++l) t[i][j] += r[i][k] * s[k][l] * r[j][l];
      }
    }
  }
  const double plain = kinetic({}, {s[0][0], s[1][1], s[2][2]}, {s[0][1], s[1][2], s[2][0]});
  const double turned = kinetic(axis, {t[0][0], t[1][1], t[2][2]}, {t[0][1], t[1][2], t[2][0]});
  EXPECT_GT(plain, 1);
  EXPECT_NEAR(turned / plain, 1, 1e-10);
}

/// Energies of bodies and of eroded elements have what was there at the start, and a run that is broken off goes on.
TEST(InitialStress, IsInTheEnergiesAndInTheStateOfARun) {
  Scene scene = released_bar(1e8, plastic_material("hard", 1e9, 0.5));
  scene.materials[0].erosion.emplace().time = 1e-4;
  scene.output.body_energies = true;
  scene.initial_stresses[0].plastic_strain = 0.02;
  Solver<double> solver(scene);
  solver.step();
  const double stored = solver.energies().internal;
  EXPECT_GT(stored, 0);
  EXPECT_DOUBLE_EQ(solver.body_shares().at(0).internal, stored);
  for (const double strain : snapshot(solver).plastic_strain) EXPECT_EQ(strain, 0.02);
  while (solver.time() < 0.5e-4) solver.step();
  const StateBytes state = saved(solver);
  run(solver);
  EXPECT_GT(solver.energies().eroded, 0.2 * stored);
  EXPECT_NEAR(solver.energies().internal, 0, 1e-9 * stored) << "all is eroded";
  Solver<double> rest(scene);
  EXPECT_EQ(load(rest, state), 0U);
  run(rest);
  EXPECT_EQ(state_hash(std::as_const(rest).model()), state_hash(std::as_const(solver).model()));
  EXPECT_EQ(rest.energies().eroded, solver.energies().eroded);
}

/// The last table that selects an element counts; a box takes elements that are in it with all corners.
TEST(InitialStress, IsOfTheElementsThatAreSelected) {
  Scene scene = scene_of({block("a", {2, 2, 4}, 0.1, {0, 0, 0}), block("b", {1, 1, 1}, 0.1, {5, 0, 0})}, 1e-6, false);
  InitialStress box = stress_in("a", {0, 0, 2e6});
  box.nodes.box = Box{{-1, -1, 0.05}, {1, 1, 0.35}};
  scene.initial_stresses = {stress_in("a", {1e6, 0, 0}), box};
  const Model<double> model = build_model<double>(scene);
  int first = 0, second = 0, none = 0;
  for (std::int64_t e = 0; e < model.mesh.element_count(); ++e) {
    const auto s = model.elements.stress_of(model.slot_of_element[e]);
    first += s[0] == 1e6 && s[2] == 0;
    second += s[0] == 0 && s[2] == 2e6;
    none += s[0] == 0 && s[2] == 0;
  }
  EXPECT_EQ(first, 8);
  EXPECT_EQ(second, 8);
  EXPECT_EQ(none, 1);
}

TEST(InitialStress, IsRefusedWhereALawHasNone) {
  const auto error = [](const Material& material, const Point& stress, double strain = 0) {
    Scene scene = scene_of({block("a", {1, 1, 1}, 0.1, {0, 0, 0}, {}, material.name)}, 1e-6, false);
    scene.materials = {material};
    scene.initial_stresses = {stress_in("a", stress)};
    scene.initial_stresses[0].plastic_strain = strain;
    return error_of([&] { build_model<double>(scene); });
  };
  const Point pressed{-1e5, -1e5, -1e5}, sheared{2e5, -1e5, -1e5};
  EXPECT_THAT(error(rubber(), sheared), HasSubstr("here: expected no such stress in material rubber: that of "
                                                  "mooney_rivlin is one of the whole deformation"));
  EXPECT_THAT(error(rubber_of_powers(), sheared), HasSubstr("that of ogden"));
  EXPECT_THAT(error(orthotropic(), sheared), HasSubstr("that of orthotropic"));
  EXPECT_THAT(error(with_equation_of_state(), pressed), HasSubstr("its pressure is that of its equation of state"));
  EXPECT_EQ(error(with_equation_of_state(), sheared), no_error);
  EXPECT_THAT(error(elastic_material(), sheared, 0.1), HasSubstr("which does not yield"));
  EXPECT_THAT(error(elastic_material(), {-9e10, 0, 0}), HasSubstr("presses with more than its shear modulus"));
  Scene scene = scene_of({block("a", {1, 1, 1}, 0.1, {0, 0, 0})}, 1e-6, false);
  scene.initial_stresses = {stress_in("a", sheared)};
  scene.initial_stresses[0].nodes.box = Box{{0, 0, 0}, {0.05, 1, 1}};
  EXPECT_THAT(error_of([&] { build_model<double>(scene); }), HasSubstr("here: expected at least one element"));
  scene.initial_stresses = {stress_in("a", sheared)};
  RigidBody rigid;
  rigid.name = "r";
  rigid.bodies = {"a"};
  scene.rigid_bodies = {rigid};
  EXPECT_THAT(error_of([&] { build_model<double>(scene); }),
              HasSubstr("here: expected no element of body a, which is rigid"));
}

}  // namespace
}  // namespace pinball::initial_stress_test
