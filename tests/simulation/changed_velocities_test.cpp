#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <solver/scene.hpp>

#include "simulation_case.hpp"

/// Velocities that a host changes between steps act as impulses do.
namespace pinball::changed_velocities_test {
namespace {

const std::string bar = R"(time = { end = 10, steps = 60 }
units = "g-mm-ms"
contact.method = "none"
[[material]]
name = "steel"
model = "elastic"
density = 7.85e-3
young_modulus = 2e5
poisson_ratio = 0
[[body]]
name = "bar"
material = "steel"
mesh = { type = "block", size = [6, 1, 1], elements = [6, 1, 1] }
velocity = [1, 2, 0]
)";
const std::string held = R"([[constraint]]
type = "fixed"
directions = "all"
plane = { point = [0, 0, 0], normal = [1, 0, 0] }
[[load]]
force = [200, 0, 0]
plane = { point = [6, 0, 0], normal = [1, 0, 0] }
)";
const std::string more = R"([[body]]
name = "more"
material = "steel"
mesh = { type = "block", size = [2, 1, 1], elements = [2, 1, 1] }
position = [6, 0, 0]
velocity = [1, 2, 0]
)";

Scene scene_of_text(const std::string& text) { return read_scene(SceneSource{"changed.toml", text, {}}); }

/// By hand as by damping: what has come to rest under a force has the length that the force gives it.
TEST(VelocitiesOfAHost, ABarThatAHostBringsToRestIsAsLongAsItsStressSays) {
  Scene scene = scene_of_text(bar + held);
  scene.time.steps = -1;
  scene.time.end = 0.1;
  scene.bodies[0].velocity = {};
  Simulation simulation(scene);
  simulation.on_step([](Simulation& s) {
    if (s.complete()) return AfterStep::go_on;
    const ArrayView v = s.velocities_to_change();
    for (std::int64_t n = 0; n < v.count; ++n) {
      for (int k = 0; k < 3; ++k) *v.at<double>(n, k) *= 0.9;
    }
    return AfterStep::go_on;
  });
  simulation.run();
  const FieldSnapshot end = simulation.snapshot();
  double longest = 0;
  for (const Point& x : end.position) longest = std::max(longest, x[0]);
  EXPECT_NEAR(end.stress[3][0], 200, 0.5);  // of the area as it was: 1 + 1e-3
  EXPECT_NEAR(longest - 6, 200.0 / 2e5 * 6, 2e-5);
}

/// A change of each node's velocity, other for each.
Point kick(std::int64_t node) {
  return {std::sin(3.0 * static_cast<double>(node)), 0.5 * std::cos(7.0 * static_cast<double>(node)), 0.25};
}

struct Kicked {
  FieldSnapshot end;
  Energies energies;
  double balance_error = 0;  // of all energy
};

/// kicks: places of nodes, and what their velocities change by after ten steps: by the host itself, or by forces of the
/// next step that do the same.
template <class Change>
Kicked kicked(const Scene& scene, bool by_forces, const Change& change) {
  double lengths[2] = {};
  for (const bool measured : {false, true}) {
    Simulation simulation(scene);
    for (int step = 0; step < 10; ++step) simulation.step();
    lengths[0] = measured ? lengths[0] : simulation.dt();
    if (!by_forces || !measured) {
      const ArrayView v = simulation.velocities_to_change();
      for (std::int64_t n = 0; n < v.count; ++n) {
        for (int k = 0; k < 3; ++k) *v.at<double>(n, k) += change(simulation, n)[k];
      }
      simulation.step();
    } else {
      const ArrayView f = simulation.external_forces();
      const ConstArrayView m = simulation.masses();
      const double time = 0.5 * (lengths[0] + lengths[1]);
      for (std::int64_t n = 0; n < f.count; ++n) {
        for (int k = 0; k < 3; ++k) *f.at<double>(n, k) = *m.at<double>(n, 0) * change(simulation, n)[k] / time;
      }
      simulation.step();
      for (std::int64_t n = 0; n < f.count; ++n) {
        for (int k = 0; k < 3; ++k) *f.at<double>(n, k) = 0;
      }
    }
    lengths[1] = simulation.dt();
    if (by_forces && !measured) continue;
    simulation.run();
    return {simulation.snapshot(), simulation.energies(), simulation.balance_error()};
  }
  return {};
}

template <class Change>
void expect_alike(const Scene& scene, const Change& change) {
  const Kicked by_host = kicked(scene, false, change), by_forces = kicked(scene, true, change);
  ASSERT_GT(by_host.energies.external, 1e-3);
  EXPECT_NEAR(by_host.energies.external, by_forces.energies.external, 1e-9 * by_host.energies.external);
  EXPECT_NEAR(by_host.energies.kinetic, by_forces.energies.kinetic, 1e-9 * by_host.energies.kinetic);
  EXPECT_NEAR(by_host.energies.internal, by_forces.energies.internal, 1e-9 * by_host.energies.kinetic);
  for (std::size_t n = 0; n < by_host.end.position.size(); ++n) {
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(by_host.end.position[n][k], by_forces.end.position[n][k], 1e-11);
  }
}

Point own_kick(const Simulation& /*simulation*/, std::int64_t node) { return kick(node); }

TEST(VelocitiesOfAHost, AreImpulses) { expect_alike(scene_of_text(bar), own_kick); }

TEST(VelocitiesOfAHost, OfNodesThatAreHeldOrTiedAreImpulsesToo) {
  const std::string tie = "[[contact.tied]]\nfirst = \"more\"\nsecond = \"bar\"\n";
  expect_alike(scene_of_text(bar + held), own_kick);
  expect_alike(scene_of_text(bar + more + tie), [](const Simulation& simulation, std::int64_t node) {
    const double x =
        *simulation.positions().at<double>(node, 0);  // of faces with what is tied to them masses are others
    return x > 5.5 && x < 6.5 ? Point{} : kick(node);
  });
}

/// The whole of a rigid body moves, with the nodes that it shares with what deforms.
TEST(VelocitiesOfAHost, OfARigidBodyWithNodesOfOthersAreImpulsesToo) {
  const Scene scene = scene_of_text(bar + more + R"([[rigid_body]]
name = "hammer"
bodies = ["more"]
[[rigid_nodes]]
rigid_body = "hammer"
body = "bar"
plane = { point = [6, 0, 0], normal = [1, 0, 0] }
)");
  expect_alike(scene, [](const Simulation& simulation, std::int64_t node) {
    const ConstArrayView x = simulation.positions();
    if (*x.at<double>(node, 0) < 5.9) return Point{};
    return Point{0.5, -0.3 * *x.at<double>(node, 2), 0.3 * *x.at<double>(node, 1)};
  });
}

/// Its energy is that of its own mass, centre and inertia, which are none of the nodes.
TEST(VelocitiesOfAHost, OfARigidBodyWithAnInertiaOfItsOwnDoItsWork) {
  Simulation simulation(scene_of_text(bar + R"([[rigid_body]]
name = "hammer"
bodies = ["bar"]
mass = 0.2
centre = [2, 0.6, 0.4]
inertia = [[0.3, 0.01, 0], [0.01, 0.7, 0.02], [0, 0.02, 0.8]]
velocity = [1, 2, 0]
angular_velocity = [0.3, -0.2, 0.5]
)"));
  for (int step = 0; step < 30; ++step) simulation.step();
  const double before = simulation.energies().kinetic;
  const ArrayView v = simulation.velocities_to_change();
  const ConstArrayView x = simulation.positions();
  for (std::int64_t n = 0; n < v.count; ++n) {
    *v.at<double>(n, 0) += 3 - 2 * *x.at<double>(n, 1);
    *v.at<double>(n, 1) += 2 * *x.at<double>(n, 0);
  }
  simulation.run();
  const double gained = simulation.energies().kinetic - before;
  EXPECT_GT(gained, 1);
  EXPECT_NEAR(simulation.energies().external, gained, 1e-5 * gained);
}

TEST(VelocitiesOfAHost, DoTheSameOnADevice) {
  Scene scene = scene_of_text(bar + held);
  const Kicked on_host = kicked(scene, false, own_kick);
  scene.device = Device::mock;
  const Kicked on_device = kicked(scene, false, own_kick);
  EXPECT_NEAR(on_device.energies.external, on_host.energies.external, 1e-12 * on_host.energies.external);
  EXPECT_EQ(on_device.end.position, on_host.end.position);
}

TEST(VelocitiesOfAHost, LeaveEarlierPlacesAlone) {
  Scene scene = scene_of_text(bar + "[[probe]]\nname = \"end\"\npoint = [6, 0, 0]\nquantities = [\"position\"]\n");
  Simulation simulation(scene);
  for (int step = 0; step < 10; ++step) simulation.step();
  const std::vector<Point> before = simulation.snapshot().position;
  const double probed = simulation.probes().at(0).values.at(0).value;
  const ArrayView v = simulation.velocities_to_change();
  for (std::int64_t n = 0; n < v.count; ++n) *v.at<double>(n, 0) += 1000;
  EXPECT_EQ(simulation.snapshot().position, before);
  EXPECT_EQ(simulation.probes().at(0).values.at(0).value, probed);
}

}  // namespace
}  // namespace pinball::changed_velocities_test
