#include <gtest/gtest.h>

#include <kernels/exec.hpp>
#include <tests/support/solver_case.hpp>

/// Masses of nodes are sums, and have the bits of one order.
namespace pinball::test::node_masses_test {
namespace {

/// Elements of all sizes, in several tiles: no two orders of a sum have the same bits.
Scene graded_scene() {
  Body body = block("a", {1, 1, 1}, 1, {0, 0, 0});
  const auto sections = [](double first, double second) {
    return std::vector<BlockSection>{{first, 7}, {second, 9}, {1 - first - second, 8}};
  };
  BlockMesh mesh{{1, 1, 1}, {24, 24, 24}};
  mesh.sections = {sections(0.1, 0.7), sections(0.31, 0.57), sections(0.47, 0.17)};
  body.mesh = mesh;
  Body other = body;
  other.name = "b";
  other.position = {2.1, 0.3, 0.7};
  return scene_of({body, other}, 1, false);
}

std::vector<double> masses_in_the_order_of_slots(const Model<double>& model) {
  std::vector<double> mass(model.node_mass.size(), 0.0);
  for (std::int64_t slot = 0; slot < model.elements.slots; ++slot) {
    if (model.is_padding(slot)) continue;
    for (const std::int32_t node : model.elements.corners(slot))
      mass[node] += model.element_mass[model.element_of_slot[slot]] / 8;
  }
  return mass;
}

TEST(NodeMasses, AreSumsInTheOrderOfSlotsForAnyNumberOfThreads) {
  const int before = DefaultExecutionSpace::concurrency();
  for (const bool subcycling : {false, true}) {
    Scene scene = graded_scene();
    scene.time.subcycling = subcycling;
    for (const int threads : {1, 2, 3}) {
      DefaultExecutionSpace::set_concurrency(threads);
      const Model<double> model = build_model<double>(scene);
      ASSERT_GT(model.tile_packs.size(), 4U);
      EXPECT_EQ(model.node_mass, masses_in_the_order_of_slots(model)) << threads << " threads";
    }
  }
  DefaultExecutionSpace::set_concurrency(before);
}

TEST(NodeMasses, OfAddedMassAreSumsInTheSameOrder) {
  Scene scene = graded_scene();
  scene.time.smallest_step = 2e-2;
  const Model<double> model = build_model<double>(scene);
  ASSERT_FALSE(model.added_mass.empty());
  EXPECT_EQ(model.node_mass, masses_in_the_order_of_slots(model));
  double of_nodes = 0, of_elements = 0;
  for (const double mass : model.added_node_mass) of_nodes += mass;
  for (const double mass : model.added_mass) of_elements += mass;
  EXPECT_GT(of_elements, 0);
  EXPECT_NEAR(of_nodes, of_elements, 1e-12 * of_elements);
}

}  // namespace
}  // namespace pinball::test::node_masses_test
