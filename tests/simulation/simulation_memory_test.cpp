#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <new>

#include <tests/support/failing_memory.hpp>

#include "simulation_case.hpp"

/// Memory that runs out anywhere: std::bad_alloc in the thread that called, also where other threads have asked for it.
namespace pinball::simulation_memory_test {
namespace {

using test::Memory;

/// Steps of a simulation; false: it ran out of memory.
bool lives(const Scene& scene) {
  try {
    Simulation simulation(scene, {3});
    for (int step = 0; step < 3; ++step) simulation.step();
    return simulation.energies().kinetic > 0;
  } catch (const std::bad_alloc&) {
    return false;
  }
}

void expect_no_harm(const Scene& scene) {
  ASSERT_TRUE(lives(scene));  // the threads are there now
  const std::int64_t before = Memory::alive;
  int refused = 0;
  const std::int64_t requests = Memory::refuse_each([&] {
    refused += lives(scene) ? 0 : 1;
    EXPECT_EQ(Memory::alive, before) << "left behind";
  });
  EXPECT_GT(requests, 100);
  EXPECT_GT(refused, 100);
}

Scene slow_impact() {
  Scene scene = test::impact();
  scene.time.steps = 2;
  return scene;
}

TEST(SimulationMemory, Penalty) { expect_no_harm(slow_impact()); }
TEST(SimulationMemory, ImpulsesBetweenFaces) {
  Scene scene = slow_impact();
  scene.contact.enforcement = Enforcement::lagrange;
  scene.contact.gap = ContactGap::face;
  expect_no_harm(scene);
}
TEST(SimulationMemory, Slideline) {
  Scene scene = slow_impact();
  scene.contact.method = ContactMethod::slideline;
  expect_no_harm(scene);
}
TEST(SimulationMemory, Subcycling) {
  Scene scene = slow_impact();
  scene.time.subcycling = true;
  expect_no_harm(scene);
}

}  // namespace
}  // namespace pinball::simulation_memory_test
