#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include <solver/device/device_run.hpp>
#include <tests/device/device_case.hpp>
#include <tests/support/collapsed_case.hpp>
#include <tests/support/law_materials.hpp>
#include <tests/support/pressed_block.hpp>
#include <tests/support/tetrahedra_case.hpp>
#include <tests/support/torn_block.hpp>

/// Steps on a device beside those of the host (device_case.hpp).
namespace pinball::device_run_test {
namespace {

using namespace test;

class DeviceRun : public testing::TestWithParam<Device> {};

TEST_P(DeviceRun, TearsABlockAsTheHostDoes) {
  const Scene scene = torn_block();
  Solver<double> host(scene);
  run(host);
  EXPECT_GT(host.counts().eroded_elements(), 0);  // else nothing of it is tested
  expect_same_run<double>(scene, GetParam());
}

TEST_P(DeviceRun, TearsABlockAsTheHostDoesInSinglePrecision) {
  expect_same_run<float>(torn_block(Precision::float32), GetParam());
}

/// What corners about to turn over need is worked by a kernel of its own.
TEST_P(DeviceRun, FoldsElementsAsTheHostDoes) {
  Scene scene = pressed_block(ElementSettings{}.folding_resistance);
  scene.bodies.push_back(block("far", {8, 8, 8}, 5e-3, {1, 0, 0}));
  scene.materials[0].erosion_strain = 4;
  scene.time.end = 7e-5;
  Solver<double> host(scene);
  double folding = 0;
  run_to_end(host, [&] { folding = std::max(folding, host.energies().folding); });
  EXPECT_GT(folding, 0);
  expect_same_run<double>(scene, GetParam());
  scene.precision = Precision::float32;
  expect_same_run<float>(scene, GetParam());
}

TEST_P(DeviceRun, HasEachFormOfHourglassControl) {
  for (const HourglassControl form : {HourglassControl::none, HourglassControl::viscous, HourglassControl::stiffness,
                                      HourglassControl::assumed_strain}) {
    Scene scene = torn_block();
    scene.element.hourglass = form;
    scene.time.end = 10e-6;
    expect_same_run<double>(scene, GetParam());
  }
}

/// Of those that erode volumes are no longer averaged.
TEST_P(DeviceRun, TearsTetrahedraAsTheHostDoes) {
  Solver<double> host(torn_tetrahedra());
  run(host);
  EXPECT_GT(host.counts().eroded_elements(), 10);
  expect_same_run<double>(torn_tetrahedra(), GetParam());
  expect_same_run<float>(torn_tetrahedra(Precision::float32), GetParam());
}

TEST_P(DeviceRun, TearsWedgesAndPyramidsAsTheHostDoes) {
  for (const HourglassControl form : {HourglassControl::none, HourglassControl::assumed_strain}) {
    Scene scene = torn_shapes();
    scene.element.hourglass = form;
    expect_same_run<double>(scene, GetParam());
  }
  expect_same_run<float>(torn_shapes(Precision::float32), GetParam());
}

/// Contact asks where walls will stop nodes, and how these rub there.
TEST_P(DeviceRun, HasImpulsesOfContactBesideRigidWalls) {
  Scene scene = scene_of({block("a", {2, 2, 2}, 0.1, {0, 0, 1e-3}, {0, 0, -20}),
                          block("b", {2, 2, 2}, 0.1, {0.03, 0.02, 0.202}, {0, 0, -60})},
                         4e-4);
  scene.contact = ContactSettings();
  scene.rigid_walls = {{"floor", {{0, 0, 0}, {0, 0, 1}}, "", "here"}};
  scene.rigid_walls[0].friction = 0.2;
  scene.constraints = {{{0, 0, 0}, {0, 1, 0}, ""}};
  Solver<double> host(scene);
  run(host);
  EXPECT_GT(host.boundary().walls()[0].impulse, 0);
  expect_same_run<double>(scene, GetParam());
  expect_same_run<float>(scene, GetParam());
  // Side by side, so that nodes rub on the wall that touch the other block, too.
  scene.bodies[1].position = {0.201, 0.02, 1e-3};
  scene.bodies[1].velocity = {-60, 0, -20};
  scene.constraints = {};
  expect_same_run<double>(scene, GetParam());
  expect_same_run<float>(scene, GetParam());
}

TEST_P(DeviceRun, HasTetrahedraBesideHexahedra) {
  expect_same_run<double>(striking_bar_of_both(), GetParam());
  expect_same_run<float>(striking_bar_of_both(Precision::float32), GetParam());
}

TEST_P(DeviceRun, HasElasticMaterialsAndThoseWithCurves) {
  Scene scene = torn_block();
  scene.time.end = 10e-6;
  scene.materials.push_back(elastic_material("elastic"));
  Material curved = plastic_material("curved", 4e8, 0);
  curved.isotropic_share = 0.5;
  curved.rate_constant = 40;
  curved.rate_exponent = 5;
  scene.materials.push_back(curved);
  for (const char* name : {"elastic", "curved"}) {
    Body more = block(name, {3, 4, 5}, 0.01, {0.5, name[0] == 'e' ? 0.0 : 0.5, 0}, {}, name);
    more.velocity_gradient = scene.bodies[0].velocity_gradient;
    scene.bodies.push_back(more);
    more.name += "_of_tetrahedra";
    more.position[2] = 0.5;
    scene.bodies.push_back(cut(more));
  }
  expect_same_run<double>(scene, GetParam());
}

TEST_P(DeviceRun, HasPowersFluidsSoilFoamRubberAndAxes) {
  Scene scene = torn_block();
  scene.element.hourglass = HourglassControl::viscous;
  scene.time.end = 10e-6;
  Material power = plastic_material("power", 4e8, 0), fluid = power, rubber = elastic_material("rubber");
  Material wood = orthotropic();
  wood.name = "wood";
  power.plastic_modulus = 0;
  power.power_hardening = PowerHardeningSettings{8e8, 0.2};
  fluid.name = "fluid";
  fluid.shear_modulus = fluid.yield_stress = fluid.plastic_modulus = 0;
  fluid.fluid = FluidSettings{10};
  fluid.equation_of_state.emplace();
  fluid.equation_of_state->sound_speed = 4000;
  rubber.mooney_rivlin = MooneyRivlinSettings{3e10, 1e10, 0.3};
  Material powers = elastic_material("powers");
  powers.ogden = OgdenSettings{{3e10, -1e10}, {2.5, -1.5}, 0.3, false};
  for (const Material& material : {power, fluid, soil_material("soil"), foam_material("foam"), rubber, powers, wood}) {
    scene.materials.push_back(material);
    Body more = block(material.name, {3, 4, 5}, 0.01, {0.5 * scene.bodies.size(), 0, 0}, {}, material.name);
    more.velocity_gradient = scene.bodies[0].velocity_gradient;
    scene.bodies.push_back(more);
    more.name += "_of_tetrahedra";
    more.position[2] = 0.5;
    scene.bodies.push_back(cut(more));
  }
  expect_same_run<double>(scene, GetParam());
}

TEST_P(DeviceRun, HasBoundaryConditionsOfAllKinds) {
  Scene scene = pressed_blocks(2e-3);
  scene.contact.method = ContactMethod::none;
  Pressure pressure;
  pressure.name = "top";
  pressure.faces.body = "a";
  pressure.pressure = 1e6;
  scene.pressures = {pressure};
  scene.gravities = {Gravity{}};
  scene.gravities[0].acceleration = {0, 0, -9.81};
  expect_same_run<double>(scene, GetParam());
  expect_same_run<float>(scene, GetParam());
}

/// A bar in flight meets a wall after some steps; a wave goes through it.
Scene flying_bar(bool leaves_out = true) {
  Scene scene = scene_of({block("bar", {40, 5, 5}, 0.01, {})}, 40e-6, false);
  scene.bodies[0].velocity = {-100.3, 20.7, 0};
  RigidWall wall;
  wall.name = "wall";
  wall.plane = {{-1e-3, 0, 0}, {1, 0, 0}};
  scene.rigid_walls = {wall};
  scene.skip.resting = leaves_out;
  return scene;
}

/// A part of the bar that no wave has reached is not worked; its stable step is the one that it began with, as on the
/// host: in flight rounding would give it another one.
TEST_P(DeviceRun, LeavesOutTilesAtRestUntilSomethingReachesThem) {
  Scene on_device = flying_bar();
  on_device.device = GetParam();
  Solver<double> host(flying_bar()), device(on_device);
  int steps_with_some = 0;
  while (!host.at_end()) {
    host.step();
    device.step();
    const std::int64_t resting = host.counts().work().resting_element_steps;
    EXPECT_EQ(device.counts().work().resting_element_steps, resting) << host.steps();
    if (resting > 0) ++steps_with_some;
  }
  EXPECT_GT(steps_with_some, 5);
  expect_same_run<double>(flying_bar(), GetParam());
  expect_same_run<float>(flying_bar(), GetParam());
}

TEST_P(DeviceRun, HasTheSameBitsWhenTilesAtRestAreWorked) {
  EXPECT_EQ(hash_on<double>(flying_bar(false), GetParam()), hash_on<double>(flying_bar(), GetParam()));
}

TEST_P(DeviceRun, HasTheSameBitsForAnyNumberOfThreads) {
  const std::uint64_t one = hash_on<double>(torn_block(), GetParam());
  for (const int threads : {2, 3, 8}) {
    DefaultExecutionSpace::set_concurrency(threads);
    EXPECT_EQ(hash_on<double>(torn_block(), GetParam()), one) << threads;
  }
  DefaultExecutionSpace::set_concurrency(1);
}

TEST_P(DeviceRun, TakesChangesOfTheHostBetweenSteps) {
  Scene scene = torn_block();
  scene.materials[0] = elastic_material();
  Scene on_device = scene;
  on_device.device = GetParam();
  Solver<double> host(scene), device(on_device);
  for (Solver<double>* solver : {&host, &device}) {
    for (int i = 0; i < 5; ++i) solver->step();
    for (std::int32_t n = 0; n < solver->model().nodes.count; ++n) solver->change_velocities()[4 * n] += 100;
    for (int i = 0; i < 5; ++i) solver->step();
  }
  const double moved = host.momentum()[0];
  EXPECT_GT(moved, 0);
  EXPECT_NEAR(device.momentum()[0], moved, 1e-9 * moved);
}

/// Also where nobody has read the state before, of which work is the difference.
TEST_P(DeviceRun, CountsTheWorkOfWhoChangesVelocities) {
  Scene on_device = flying_bar();
  on_device.device = GetParam();
  Solver<double> host(flying_bar()), device(on_device);
  for (Solver<double>* solver : {&host, &device}) {
    for (int i = 0; i < 30; ++i) solver->step();
    solver->change_velocities()[4 * 100] += 50;
    solver->step();
  }
  EXPECT_GT(std::abs(host.energies().external), 0);
  EXPECT_NEAR(device.energies().external, host.energies().external, 1e-9 * std::abs(host.energies().external));
}

/// What rested before stresses were changed does not rest in what is saved after it.
TEST_P(DeviceRun, SavesNoTilesAtRestThatWereChanged) {
  Scene scene = flying_bar();
  scene.device = GetParam();
  const auto hash = [&scene](bool saves) {
    Solver<double> solver(scene);
    for (int i = 0; i < 5; ++i) solver.step();
    EXPECT_GT(solver.counts().work().resting_element_steps, 0);
    Array<double>& stress = solver.change_model().elements.stress.in<double>();
    for (std::size_t i = 0; i < stress.size(); i += 5) stress[i] += 1e6;
    if (saves) test::saved(solver);
    for (int i = 0; i < 5; ++i) solver.step();
    return state_hash(solver.model());
  };
  EXPECT_EQ(hash(true), hash(false));
}

/// The state is copied for who reads it, and for nobody else: a line of progress must not cost a copy of all of it.
TEST_P(DeviceRun, BringsTheStateBackForWhoReadsItAlone) {
  Scene scene = torn_block();
  scene.device = GetParam();
  Solver<double> solver(scene);
  const auto x = [](const Model<double>& model) { return model.nodes.position[0]; };
  const Model<double>& mirror = solver.model();
  const double before = x(mirror);
  for (int i = 0; i < 5; ++i) solver.step();
  EXPECT_EQ(progress_state(solver).elements, solver.element_count());
  EXPECT_EQ(solver.scene().device, GetParam());
  EXPECT_EQ(solver.mesh().element_count(), solver.element_count());
  EXPECT_GT(history_row(solver).bodies.at(0).mass_remaining, 0);
  EXPECT_EQ(x(mirror), before);
  EXPECT_NE(x(solver.model()), before);
}

TEST_P(DeviceRun, GoesOnFromWhatAnotherDeviceHasSaved) {
  for (const Scene& scene : {torn_block(), flying_bar(), torn_tetrahedra()}) {
    const std::uint64_t on_host = hash_on<double>(scene, Device::none), on_device = hash_on<double>(scene, GetParam());
    EXPECT_EQ(hash_of_parts(scene, GetParam(), GetParam()), on_device);
    if (!same_bits) continue;
    EXPECT_EQ(hash_of_parts(scene, GetParam(), Device::none), on_host);
    EXPECT_EQ(hash_of_parts(scene, Device::none, GetParam()), on_host);
  }
}

TEST_P(DeviceRun, RefusesByNameWhatNoDeviceCanDo) {
  Scene scene = scene_of({block("a", {1, 1, 1}, 1, {}), block("b", {1, 1, 1}, 1, {2, 0, 0})}, 1e-3, true);
  scene.time.subcycling = true;
  scene.device = GetParam();
  EXPECT_EQ(missing_on_device(scene), "subcycling");
  scene.precision = Precision::mixed;
  EXPECT_EQ(missing_on_device(scene), "subcycling, precision = \"mixed\"");
  EXPECT_THAT(error_of([&] { Solver<double>{scene}; }), testing::HasSubstr("it has subcycling, precision"));
}

TEST_P(DeviceRun, TellsWhereAnElementHasTurnedInsideOut) {
  Scene scene = torn_block();
  scene.materials[0] = elastic_material();
  scene.bodies[0].velocity_gradient = {Point{-3e5, 0, 0}, Point{0, -3e5, 0}, Point{0, 0, -3e5}};
  Scene on_device = scene;
  on_device.device = GetParam();
  const auto failure = [](const Scene& of) {
    Solver<double> solver(of);
    return error_of<RunError>([&] { run(solver); });
  };
  EXPECT_FALSE(failure(scene).empty());
  EXPECT_EQ(failure(on_device), failure(scene));
}

INSTANTIATE_TEST_SUITE_P(On, DeviceRun, testing::ValuesIn(devices()), name_of_device);

}  // namespace
}  // namespace pinball::device_run_test
