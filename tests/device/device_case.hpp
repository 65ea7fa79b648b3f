#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include <solver/device/devices.hpp>
#include <solver/step/report.hpp>
#include <tests/support/saved_state.hpp>
#include <tests/support/solver_case.hpp>

/// Runs on a device beside those of the host: on the mock one, threads of the host on memory that nothing else may
/// touch, and where the compiler can make it on an emulated GPU (emulated/emulated_device.hpp).
namespace pinball::test {

/// A rod that erodes on a plate, and the plate under it: balls with penalty.
inline Scene eroding_rod() {
  Scene scene = scene_of({block("rod", {3, 3, 8}, 5e-3, {12.5e-3, 12.5e-3, 10.3e-3}, {0, 20, -700}, "soft"),
                          block("plate", {8, 8, 2}, 5e-3, {0, 0, 0}, {}, "soft")},
                         40e-6);
  scene.materials = {plastic_material("soft", 2e8, 0.3)};
  return scene;
}

template <class S>
std::uint64_t hash_on(Scene scene, Device device) {
  scene.device = device;
  Solver<S> solver(scene);
  run(solver);
  return state_hash(solver.model());
}

/// Where the compiler may not fuse a multiplication and an addition here and not there, the bits are the same.
inline constexpr bool same_bits =
#if defined(PINBALL_STRICT)
    true;
#else
    false;
#endif

/// Of two runs, the second of the host alone.
template <class S>
void expect_same_state(Solver<S>& device, Solver<S>& host) {
  if (same_bits) {
    EXPECT_EQ(state_hash(device.model()), state_hash(host.model()));
  }
  const double tolerance = sizeof(S) == sizeof(double) ? 1e-9 : 1e-4;
  EXPECT_EQ(device.steps(), host.steps());
  EXPECT_EQ(device.counts().eroded_elements(), host.counts().eroded_elements());
  const double scale = host.energies().kinetic + host.energies().internal;  // the total of a driven body is near zero
  EXPECT_NEAR(device.energies().kinetic, host.energies().kinetic, tolerance * scale);
  EXPECT_NEAR(device.energies().internal, host.energies().internal, tolerance * scale);
  EXPECT_NEAR(device.energies().hourglass, host.energies().hourglass, tolerance * scale);
  for (std::size_t i = 0; i < host.model().nodes.position.size(); ++i) {
    ASSERT_NEAR(device.model().nodes.position[i], host.model().nodes.position[i], tolerance);
  }
}

template <class S>
void expect_same_run(const Scene& scene, Device on) {
  Scene on_device = scene;
  on_device.device = on;
  Solver<S> host(scene), device(on_device);
  run(host);
  run(device);
  expect_same_state(device, host);
}

/// Begins with one device, goes on with another from what the first has saved after some steps.
inline std::uint64_t hash_of_parts(Scene scene, Device first, Device second, int steps = 20) {
  scene.device = first;
  Solver<double> before(scene);
  for (int i = 0; i < steps; ++i) before.step();
  const StateBytes bytes = test::saved(before);
  scene.device = second;
  Solver<double> after(scene);
  test::load(after, bytes);
  run(after);
  return state_hash(after.model());
}

inline std::vector<Device> devices() {
  std::vector<Device> there = {Device::mock};
  if (report_of(Device::cuda).is_there) there.push_back(Device::cuda);
  return there;
}

inline std::string name_of_device(const testing::TestParamInfo<Device>& info) { return device_name(info.param); }

}  // namespace pinball::test
