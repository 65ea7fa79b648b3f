#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include <solver/step/start_checks.hpp>
#include <tests/support/error_of.hpp>
#include <tests/support/solver_case.hpp>

/// Numbers that the meshes show to be too large before a run begins, and steps that they shorten.
namespace pinball::start_checks_test {
namespace {

using namespace test;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A cube in free flight; its stable step is 1.42e-5.
Scene flying_cube() { return scene_of({block("a", {1, 1, 1}, 0.1, {0, 0, 0}, {0, 0, 20})}, 1e-3, false); }

double stable_step() {
  Solver<double> solver(flying_cube());
  solver.step();
  return solver.clock().dt_min() / solver.scene().time.cfl;
}

TEST(StartChecks, AnEndThatNoStepReachesIsRefused) {
  Scene scene = flying_cube();
  for (const double end : {1e308, 1e20, 1e12}) {
    scene.time.end = end;
    EXPECT_THAT(input_error_of(scene),
                AllOf(testing::StartsWith("time.end: expected at most 4.96e+10"), HasSubstr("time.steps")));
  }
  scene.time.end = 1e9;
  EXPECT_EQ(input_error_of(scene), no_error);
}

TEST(StartChecks, AnImpactTooFastForTheEndIsRefused) {
  Scene scene =
      scene_of({block("a", {1, 1, 1}, 0.1, {0, 0, 0}, {0, 0, 1e30}), block("b", {1, 1, 1}, 0.1, {0, 0, 1})}, 1e-3);
  EXPECT_THAT(input_error_of(scene), HasSubstr("(set by the speed of impact)"));
  scene.bodies[0].velocity = {0, 0, 1e6};
  EXPECT_EQ(input_error_of(scene), no_error);
}

/// Squeezed on and on, without a guard.
TEST(StartChecks, AStepThatCollapsesBesideTheEndEndsTheRun) {
  Scene scene = flying_cube();
  scene.guard = {1e300, 0};
  scene.time.end = 1e9;
  Solver<double> solver(scene);
  solver.step();
  auto& model = solver.change_model();
  Array<double>& mass = model.elements.mass.in<double>();
  for (std::size_t i = 0; i < mass.size(); ++i) mass[i] *= 1e-12;
  try {
    solver.step();
    FAIL() << "a step of " << solver.dt();
  } catch (const RunError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("no number of steps of"), HasSubstr("reaches time.end = 1e+09")));
  }
}

TEST(StartChecks, StepsThatAreCountedMayHaveAnyEnd) {
  Scene scene = flying_cube();
  scene.time.steps = 20;
  Solver<double> near(scene);
  run(near);
  for (const double end : {1e20, 1e308}) {
    scene.time.end = end;
    Solver<double> solver(scene);
    run(solver);
    EXPECT_EQ(solver.steps(), 20);
    EXPECT_NEAR(solver.time(), near.time(), 0.02 * near.time());
  }
}

TEST(StartChecks, ElementsWithoutAStableStepAreRefused) {
  Scene scene = flying_cube();
  scene.element.bulk_viscosity = true;
  scene.element.linear_viscosity = 1e300;
  EXPECT_THAT(input_error_of(scene), HasSubstr("the stable step of element 0 of body a is 0"));
}

TEST(StartChecks, DampingThatTurnsMotionRoundIsRefused) {
  Scene scene = flying_cube();
  const double most = 2 / stable_step();
  scene.damping.mass = 1.001 * most;
  EXPECT_THAT(input_error_of(scene),
              AllOf(testing::StartsWith("damping.mass: expected at most"), HasSubstr("of body a")));
  scene.damping.mass = 0.999 * most;
  EXPECT_EQ(input_error_of(scene), no_error);
}

/// Lagged damping a is stable if w^2 dt^2/4 + a dt/2 <= 1: at time.cfl = 0.9 only up to 0.38/dt.
TEST(StartChecks, DampingShortensTheStepUntilItIsStable) {
  Scene scene = flying_cube();
  scene.bodies[0].velocity_noise = 5;
  scene.time.end = 200 * stable_step();
  for (const double part : {0.3, 0.6, 0.9, 0.999}) {
    scene.damping.mass = part * 2 / stable_step();
    Solver<double> solver(scene);
    solver.step();
    const double first = solver.energies().kinetic;
    while (!solver.at_end()) {
      solver.step();
      EXPECT_LE(scene.damping.mass * solver.dt(), 1 + 1e-12);
    }
    EXPECT_LT(std::abs(solver.energies().kinetic), 1e-6 * first) << part;
    EXPECT_LT(solver.ledger().balance_error_in_motion_max(), 0.5) << part;
  }
}

TEST(StartChecks, WeakDampingLeavesTheStepAsItIs) {
  Scene scene = flying_cube();
  Solver<double> free(scene);
  free.step();
  scene.damping.mass = 0.1 / stable_step();
  Solver<double> damped(scene);
  damped.step();
  EXPECT_EQ(damped.dt(), free.dt());
}

TEST(StartChecks, AViscousHourglassCoefficientOfAnotherCodeIsTold) {
  Scene scene = flying_cube();
  scene.element.hourglass = HourglassControl::viscous;
  const auto told = [&scene](double coefficient) {
    scene.element.hourglass_coefficient = coefficient;
    return Solver<double>(scene).unstable_hourglass();
  };
  EXPECT_THAT(told(0.025), IsEmpty());
  EXPECT_THAT(told(0.046), IsEmpty());
  EXPECT_THAT(told(0.1), AllOf(HasSubstr("element.hourglass_coefficient = 0.1 is beyond 0.0473"), HasSubstr("QH/4"),
                               HasSubstr("0.025")));
  scene.time.cfl = 0.4;
  EXPECT_THAT(told(0.1), IsEmpty());
}

/// The bound of the warning is that of the forces: a twisted cube comes to rest below it, and gains energy above.
TEST(StartChecks, TheViscousBoundIsThatOfTheForces) {
  for (const double part : {0.97, 1.03}) {
    Scene scene = flying_cube();
    scene.bodies[0].velocity = {0, 0, 0};
    scene.element.hourglass = HourglassControl::viscous;
    scene.element.hourglass_coefficient = part * 0.0473;
    scene.guard.energy_error = 1e300;
    scene.time.end = 200 * stable_step();
    Solver<double> solver(scene);
    Array<double>& velocity = solver.change_velocities();
    for (std::size_t n = 0; n < 8; ++n) {
      const double* x = solver.model().nodes.position_of(static_cast<std::int32_t>(n));
      velocity[4 * n] = 1e-6 * (x[1] > 0.05 ? 1 : -1) * (x[2] > 0.05 ? 1 : -1);
    }
    solver.step();
    const double first = solver.energies().kinetic;
    while (!solver.at_end()) solver.step();
    if (part < 1) {
      EXPECT_LT(std::abs(solver.energies().kinetic), 1e-4 * first);
    } else {  // turned round in each step: the product of two velocities is negative
      EXPECT_GT(std::abs(solver.energies().kinetic), 1e4 * first);
    }
  }
}

TEST(StartChecks, OtherFormsAreSureUpToOne) {
  Scene scene = flying_cube();
  const auto told = [&scene](HourglassControl form, double coefficient) {
    scene.element.hourglass = form;
    scene.element.hourglass_coefficient = coefficient;
    return Solver<double>(scene).unstable_hourglass();
  };
  for (const HourglassControl form : {HourglassControl::stiffness, HourglassControl::assumed_strain}) {
    EXPECT_THAT(told(form, 1), IsEmpty());
    EXPECT_THAT(told(form, 10), HasSubstr("= 10 is beyond 1.23"));
  }
  EXPECT_THAT(told(HourglassControl::none, 10), IsEmpty());
}

TEST(StartChecks, ALimitThatErodesWhatIsSoundIsTold) {
  Scene scene = flying_cube();
  const auto told = [&scene](double share) {
    scene.materials[0].erosion = ErosionSettings{.smallest_step = share * stable_step()};
    return Solver<double>(scene).look().unlikely;
  };
  EXPECT_THAT(told(0.5), IsEmpty());
  EXPECT_THAT(told(2), ElementsAre(AllOf(HasSubstr("erosion.smallest_step"), HasSubstr("1 of 1 element at the start"),
                                         HasSubstr("the first step erodes them"))));
}

TEST(StartChecks, AMillionStepsAreTold) {
  Scene scene = flying_cube();
  scene.time.end = 0.9 * 0.99e6 * stable_step();
  EXPECT_THAT(Solver<double>(scene).many_steps(), IsEmpty());
  scene.time.end = 0.9 * 1.01e6 * stable_step();
  EXPECT_THAT(Solver<double>(scene).many_steps(),
              AllOf(HasSubstr("takes 1.01e+06 steps"), HasSubstr("element 0 of body")));
  scene.time.steps = 100;
  EXPECT_THAT(Solver<double>(scene).many_steps(), IsEmpty());
}

/// Steel in kg and m, its scene in g and mm.
TEST(StartChecks, AFailureNamesTheUnitsOfAMaterial) {
  Scene scene = flying_cube();
  scene.units = "g-mm-ms";
  Solver<double> solver(scene);
  solver.step();
  Array<double>& position = solver.change_model().nodes.position;
  for (std::size_t n = 0; n < 8; ++n) {
    if (position[4 * n + 2] > 0.05) position[4 * n + 2] -= 0.2;  // turned inside out
  }
  EXPECT_THAT(error_of<RunError>([&] { solver.step(); }),
              AllOf(HasSubstr(" no volume left"), HasSubstr(": material steel: density 7850"),
                    HasSubstr("both are those of steel in kg-m-s"), testing::Not(HasSubstr("erosion_strain"))));
}

TEST(StartChecks, AFailureNamesTheHourglassCoefficient) {
  Scene scene = scene_of(
      {block("a", {4, 4, 4}, 0.025, {0, 0, 0}, {0, 0, 20}), block("b", {4, 4, 4}, 0.025, {0, 0, 0.1065}, {0, 0, -20})},
      2e-4);
  scene.element.hourglass = HourglassControl::viscous;
  scene.element.hourglass_coefficient = 0.1;
  Solver<double> solver(scene);
  try {
    run(solver);
    FAIL() << "stable";
  } catch (const RunError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("energy balance is off"), HasSubstr("QH/4"),
                                    testing::Not(HasSubstr("try a smaller time.cfl"))));
  }
}

}  // namespace
}  // namespace pinball::start_checks_test
