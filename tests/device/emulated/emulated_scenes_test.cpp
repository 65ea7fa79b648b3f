#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <solver/device/device_run.hpp>
#include <solver/step/report.hpp>
#include <solver/step/solver.hpp>
#include <tests/support/every_input.hpp>

#include "emulated_device.hpp"

/// All that comes along and a device can do, on the emulated GPU (emulated_device.hpp): the same bits whatever the
/// order in which its threads take turns, and the host's answer.
namespace pinball::emulated_scenes_test {
namespace {

std::vector<std::string> inputs_for_devices() {
  std::vector<std::string> paths = test::every_input();
  std::erase_if(paths, [](const std::string& path) {
    const Scene scene = test::read_input(path);
    // Where nothing is said of contact, its bodies decide.
    const bool may_touch = scene.contact.method == ContactMethod::not_set && scene.bodies.size() > 1;
    return may_touch || !missing_on_device(scene).empty();
  });
  return paths;
}

class EmulatedScene : public testing::TestWithParam<std::string> {
 protected:
  ~EmulatedScene() override { emulated::set_order(emulated::Order::forward); }
};

/// tolerance: over the largest number, of rounding that the host's packs do in another order.
template <class Numbers>
void expect_near(const Numbers& found, const Numbers& expected, double tolerance) {
  double largest = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) largest = std::max<double>(largest, std::abs(expected[i]));
  for (std::size_t i = 0; i < expected.size(); ++i) ASSERT_NEAR(found[i], expected[i], tolerance * largest) << i;
}

template <class S>
void expect_same_in_any_order(Scene scene) {
  Solver<S> host(scene);
  constexpr std::int64_t most_element_steps = 20'000;
  const std::int64_t most = std::clamp<std::int64_t>(most_element_steps / host.element_count(), 4, 60);
  const auto run_some = [most](Solver<S>& solver) {
    while (!solver.at_end() && solver.steps() < most) solver.step();
  };
  run_some(host);
  scene.device = Device::cuda;
  std::vector<std::uint64_t> hashes;
  for (const auto& [order, seed] : {std::pair(emulated::Order::forward, 1), std::pair(emulated::Order::reverse, 1),
                                    std::pair(emulated::Order::shuffled, 7)}) {
    emulated::set_order(order, seed);
    Solver<S> device(scene);
    run_some(device);
    hashes.push_back(state_hash(device.model()));
    ASSERT_EQ(device.steps(), host.steps());
    constexpr bool is_double = sizeof(S) == sizeof(double);
    expect_near(device.model().nodes.position, host.model().nodes.position, is_double ? 1e-12 : 1e-6);
    expect_near(device.model().nodes.velocity, host.model().nodes.velocity, is_double ? 1e-9 : 1e-3);
  }
  EXPECT_EQ(hashes[1], hashes[0]);
  EXPECT_EQ(hashes[2], hashes[0]);
}

TEST_P(EmulatedScene, HasTheSameBitsInAnyOrderOfThreads) {
  Scene scene = test::read_input(GetParam());
  expect_same_in_any_order<double>(scene);
  scene.precision = Precision::float32;
  expect_same_in_any_order<float>(scene);
}

INSTANTIATE_TEST_SUITE_P(All, EmulatedScene, testing::ValuesIn(inputs_for_devices()), test::name_of_input);

}  // namespace
}  // namespace pinball::emulated_scenes_test
