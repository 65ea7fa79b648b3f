#include <gtest/gtest.h>

#include <functional>
#include <ostream>

#include <tests/boundary/space_run.hpp>
#include <tests/support/solver_case.hpp>

/// Boundary conditions in the memory of a device: the same bits as on the host.
namespace pinball::space_test {
namespace {

using namespace test;

/// 507 nodes, 169 of them on the floor: sums have several pieces.
Scene plate() {
  Scene scene = scene_of({block("a", {12, 12, 2}, 0.1, {0, 0, 0}, {3, 1, -20})}, 1, false);
  scene.bodies[0].angular_velocity = {20, 10, 30};
  return scene;
}

NodeSelection on_plane(const Point& point, const Point& normal) {
  NodeSelection nodes;
  nodes.plane = Plane{point, normal};
  return nodes;
}
NodeSelection floor_nodes() { return on_plane({0, 0, 0}, {0, 0, 1}); }
NodeSelection side_nodes() { return on_plane({0, 0, 0}, {1, 0, 0}); }

struct Case {
  const char* name;
  std::function<void(Scene&)> add;
  bool does_work = true;
};
std::ostream& operator<<(std::ostream& out, const Case& of) { return out << of.name; }

void add_loads(Scene& scene) {
  NodalLoad shared, each;
  shared.nodes = floor_nodes();
  shared.force = {1e6, 2e5, -3e5};
  shared.table = {{0, 1e-3}, {0, 1}};
  each.nodes = side_nodes();
  each.force = {1e4, 0, 1e3};
  each.each = true;
  scene.loads = {shared, each};
}
void add_pressures(Scene& scene) {
  Pressure gas, late;
  gas.name = "gas";
  gas.faces.body = "a";
  gas.pressure = 1e8;
  late.name = "late";
  late.faces = floor_nodes();
  late.pressure = -3e7;
  late.start = 4e-4;
  scene.pressures = {gas, late};
}
void add_gravity(Scene& scene) {
  scene.bodies.push_back(block("b", {3, 3, 3}, 0.1, {0, 0, 5}, {0, 9, 0}));
  Gravity all, some;
  all.acceleration = {0, 0, -9.81e3};
  some.acceleration = {1e3, 0, 0};
  some.table = {{0, 1e-3}, {1, 2}};
  some.bodies = {"b"};
  some.name = "some";
  scene.gravities = {all, some};
}
void add_constraints(Scene& scene) {
  scene.constraints = {{{0, 0, 0}, {0, 1, 0}, ""}};
  FixedConstraint oblique, turning;
  oblique.nodes = side_nodes();
  oblique.directions = {{0.6, 0, 0.8}};
  oblique.when = {3e-4, 7e-4};
  turning.nodes = floor_nodes();
  turning.frame = Frame::cylindrical;
  turning.axis = {{0.61, 0.57, 0}, {0, 0, 1}};
  turning.directions = {{0, 1, 0}, {1, 0, 0}};
  turning.name = "turning";
  scene.fixed_constraints = {oblique, turning};
}
void add_prescribed(Scene& scene) {
  PrescribedVelocity pull, shift;
  pull.nodes = floor_nodes();
  pull.velocity = {1, 5, -2};
  pull.table = {{0, 3e-4, 1e-3}, {0, 1, -1}};
  shift.nodes = side_nodes();
  shift.direction = Point{0.6, 0, 0.8};
  shift.velocity = {6e-4, 0, 8e-4};
  shift.table = {{0, 1e-3}, {0, 1}};
  shift.quantity = MotionQuantity::displacement;
  shift.when = {2e-4, 8e-4};
  pull.name = "pull";
  scene.prescribed_velocities = {pull, shift};
}
void add_walls(Scene& scene) {
  RigidWall floor{"floor", {{0, 0, 0}, {0, 0, 1}}, "", "here"}, slope{"slope", {{0, 0, 0}, {0.6, 0, 0.8}}, "", "here"};
  floor.friction = 0.3;
  slope.friction = 0.1;
  slope.sliding = false;
  scene.rigid_walls = {floor, slope};
}
void add_moving_walls(Scene& scene) {
  RigidWall pushed{"pushed", {{0, 0, 0}, {0, 0, 1}}, "", "here"}, given{"given", {{0, 0, 0}, {1, 0, 0}}, "", "here"};
  pushed.mass = 100;
  pushed.speed = 2;
  given.speed = 4;
  given.table = {{0, 1e-3}, {0, 1}};
  scene.rigid_walls = {pushed, given};
}
void add_finite_wall(Scene& scene) {
  RigidWall small{"small", {{0.25, 0.25, 0}, {0, 0, 1}}, "", "here"};
  small.edge = Point{1, 0.2, 0};
  small.size = {0.6, 0};
  small.when = {0, 8e-4};
  small.friction = 0.2;
  scene.rigid_walls = {small};
  scene.constraints = {{{0, 0, 0}, {1, 0, 0}, ""}};
  FixedConstraint oblique;
  oblique.nodes = on_plane({0.6, 0, 0}, {1, 0, 0});
  oblique.directions = {{0.6, 0, 0.8}};
  scene.fixed_constraints = {oblique};
}
void add_damping(Scene& scene) { scene.damping.mass = 800; }
void add_symmetry(Scene& scene) {
  scene.materials = {plastic_material("steel", 1e8, 0.5)};
  scene.constraints = {{{0, 0, 0}, {0, 0, 1}, "", "", 0, "", "mirror"}};
  scene.bodies[0].velocity = {0, 0, -300};
}
void add_everything(Scene& scene) {
  for (const auto& add : {add_loads, add_pressures, add_gravity, add_prescribed, add_walls, add_damping}) add(scene);
}

class OnADevice : public testing::TestWithParam<Case> {};

template <class S>
void expect_same_bits(const Case& of, bool given_forces) {
  Scene scene = plate();
  of.add(scene);
  SpaceRun<S, DefaultExecutionSpace> host(scene);
  SpaceRun<S, Mock> device(scene);
  const auto give = [&](Array<S>& forces) {
    for (std::size_t i = 0; i < forces.size(); ++i) forces[i] = S(i % 13) * S(1e3);
  };
  if (given_forces) {
    give(host.boundary().host_forces(host.model()));
    give(device.boundary().host_forces(device.model()));
  }
  for (int step = 0; step < 12; ++step) {
    if (step == 6) {
      host.erode(5);
      device.erode(5);
    }
    const double length = step % 3 == 0 ? 1e-4 : 8e-5;
    host.step(length);
    Mock::set_concurrency(3);
    device.step(length);
    Mock::set_concurrency(1);
    ASSERT_EQ(host.forces(), device.forces()) << step;
    ASSERT_EQ(host.velocities(), device.velocities()) << step;
    ASSERT_EQ(host.positions(), device.positions()) << step;
    ASSERT_EQ(host.boundary().work(), device.boundary().work()) << step;
  }
  const auto results = [](auto& run) {
    std::vector<double> numbers;
    for (const WallResult& wall : run.boundary().walls()) {
      numbers.insert(numbers.end(), {wall.force, wall.force_max, wall.impulse, wall.displacement, wall.velocity});
    }
    for (const PressureResult& pressure : run.boundary().pressures()) {
      numbers.insert(numbers.end(), pressure.force.begin(), pressure.force.end());
      numbers.push_back(pressure.work);
    }
    for (const ForceResult& named : run.named_forces()) {
      numbers.insert(numbers.end(), named.force.begin(), named.force.end());
    }
    return numbers;
  };
  EXPECT_EQ(results(host), results(device));
}

TEST_P(OnADevice, HasTheBitsOfTheHost) {
  expect_same_bits<double>(GetParam(), false);
  expect_same_bits<float>(GetParam(), false);
}

TEST_P(OnADevice, DoesSomething) {
  Scene scene = plate();
  GetParam().add(scene);
  SpaceRun<double, Mock> run(scene);
  Scene without = scene_of(scene.bodies, 1, false);
  without.materials = scene.materials;
  SpaceRun<double, DefaultExecutionSpace> free(without);
  for (int step = 0; step < 12; ++step) {
    run.step(1e-4);
    free.step(1e-4);
  }
  EXPECT_NE(run.velocities(), free.velocities());
  EXPECT_EQ(run.boundary().work() != 0, GetParam().does_work);
}

INSTANTIATE_TEST_SUITE_P(Conditions, OnADevice,
                         testing::Values(Case{"loads", add_loads}, Case{"pressures", add_pressures},
                                         Case{"gravity", add_gravity}, Case{"constraints", add_constraints},
                                         Case{"prescribed", add_prescribed}, Case{"walls", add_walls},
                                         Case{"moving_walls", add_moving_walls}, Case{"finite_wall", add_finite_wall},
                                         Case{"damping", add_damping}, Case{"symmetry", add_symmetry},
                                         Case{"everything", add_everything}),
                         [](const auto& of) { return std::string(of.param.name); });

TEST(OnADevice, ForcesOfTheHostGoThereInEveryStep) {
  expect_same_bits<double>({"given", [](Scene&) {}}, true);
  expect_same_bits<float>({"given", [](Scene&) {}}, true);
  Scene scene = plate();
  SpaceRun<double, Mock> run(scene);
  Array<double>& forces = run.boundary().host_forces(run.model());
  run.step(1e-4);
  SpaceRun<double, Mock> other(scene);
  other.boundary().host_forces(other.model());
  other.step(1e-4);
  forces[4] = 3e3;
  run.step(1e-4);
  other.step(1e-4);
  EXPECT_EQ(run.forces()[4], other.forces()[4] + 3e3);
}

}  // namespace
}  // namespace pinball::space_test
