#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <tests/device/device_case.hpp>

/// Contact of faces in steps on a device whose lists hold: of the surface only the nodes that it says it reads
/// (ContactAlgorithm::read_nodes) are shown to the host.
namespace pinball::read_nodes_test {
namespace {

using namespace test;

Scene faces(Scene scene) {
  scene.contact.gap = ContactGap::face;
  scene.contact.enforcement = Enforcement::lagrange;
  return scene;
}

/// With friction, self-contact and erosion.
Scene eroding() {
  Scene scene = faces(eroding_rod());
  scene.contact.friction = 0.3;
  return scene;
}

/// Corners and edges across a plate that is held.
Scene turned_block() {
  Scene scene = faces(scene_of(
      {block("low", {6, 6, 2}, 0.1, {0, 0, 0}), block("high", {3, 3, 3}, 0.09, {0.1, 0.1, 0.35}, {10, 5, -60})}, 3e-3));
  scene.bodies[1].axis = {0.5, 0.3, 0.812403840463596};
  return scene;
}

/// Two beams that cross with their edges.
Scene crossed_beams() {
  Scene scene = faces(scene_of(
      {block("low", {8, 2, 2}, 0.1, {0, 0, 0}), block("high", {2, 8, 2}, 0.1, {0.31, -0.33, 0.205}, {0, 0, -40})},
      1e-3));
  return scene;
}

struct Case {
  std::string name;
  std::function<Scene()> scene;
};
const std::vector<Case>& cases() {
  static const std::vector<Case> all = {{"eroding", eroding}, {"turned", turned_block}, {"crossed", crossed_beams}};
  return all;
}

/// Makes the motion of all nodes of the surface that it does not read no numbers, in the host's memory. Returns how
/// many of how many it reads.
template <class S>
std::pair<std::size_t, std::size_t> forget_others(const ContactAlgorithm<S>& contact, NodeStore<S>& nodes) {
  std::vector<std::int32_t> all = contact.nodes(), read(contact.read_nodes().begin(), contact.read_nodes().end()),
                            others;
  for (auto* list : {&all, &read}) std::ranges::sort(*list);
  all.erase(std::ranges::unique(all).begin(), all.end());
  std::ranges::set_difference(all, read, std::back_inserter(others));
  for (const std::int32_t node : others) {
    std::fill_n(nodes.position_of(node), 4, std::numeric_limits<S>::quiet_NaN());
    std::fill_n(nodes.velocity_of(node), 4, std::numeric_limits<S>::quiet_NaN());
  }
  return {read.size(), all.size()};
}

template <class S>
std::uint64_t hash_of_run(const Scene& scene, bool forgets) {
  Solver<S> solver(scene);
  auto& model = const_cast<Model<S>&>(solver.model());  // what is no longer brought up to date in it
  std::size_t steps_with_some = 0;
  while (!solver.at_end()) {
    solver.step();
    if (solver.contact()->choices_of_read_nodes() == 0) continue;
    if (!forgets) continue;
    const auto [read, all] = forget_others(*solver.contact(), model.nodes);
    steps_with_some += read > 0 && read < all ? 1 : 0;
  }
  if (forgets) {
    EXPECT_GT(steps_with_some, 10U);
    EXPECT_GT(solver.contact()->searches_skipped(), 10);
    EXPECT_GT(solver.counts().pairs_max(), 0);
  }
  return state_hash(solver.model());
}

class ReadNodes : public testing::TestWithParam<std::tuple<Case, Device>> {};

TEST_P(ReadNodes, AreAllThatIsRead) {
  Scene scene = std::get<0>(GetParam()).scene();
  scene.device = std::get<1>(GetParam());
  EXPECT_EQ(hash_of_run<double>(scene, true), hash_of_run<double>(scene, false));
  scene.precision = Precision::float32;
  EXPECT_EQ(hash_of_run<float>(scene, true), hash_of_run<float>(scene, false));
}

INSTANTIATE_TEST_SUITE_P(All, ReadNodes, testing::Combine(testing::ValuesIn(cases()), testing::ValuesIn(devices())),
                         [](const auto& of) {
                           return std::get<0>(of.param).name + "_on_" + device_name(std::get<1>(of.param));
                         });

}  // namespace
}  // namespace pinball::read_nodes_test
