#pragma once

#include <gtest/gtest.h>

#include <cstdint>

#include <solver/simulation.hpp>
#include <tests/support/solver_case.hpp>

/// What the tests of simulations share.
namespace pinball::test {

/// Two blocks in impact, of a few elements.
inline Scene impact(Precision precision = Precision::float64) {
  Scene scene =
      scene_of({block("a", {3, 3, 3}, 0.1, {0, 0, 0}, {0, 0, 100}), block("b", {3, 3, 3}, 0.1, {0, 0, 0.302})}, 1e-4);
  scene.precision = precision;
  return scene;
}

inline std::uint64_t hash_of_run(const Scene& scene) {
  Simulation simulation(scene);
  EXPECT_TRUE(simulation.run());
  return simulation.state_hash();
}

}  // namespace pinball::test
