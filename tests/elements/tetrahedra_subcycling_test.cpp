#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include <solver/model/step_levels.hpp>
#include <tests/support/saved_state.hpp>
#include <tests/support/tetrahedra_case.hpp>

/// Tetrahedra beside hexahedra that make larger steps.
namespace pinball::test::tetrahedra_subcycling_test {
namespace {

/// The bar of both, whose foot of flat tetrahedra is held on a plane.
Scene subcycled(bool subcycling, Precision precision = Precision::float64) {
  static const HostMesh mesh = half_of_tetrahedra(0.01, 0.3);
  Scene scene = striking_bar_of(mesh, precision);
  scene.rigid_walls.clear();
  scene.constraints = {{{0, 0, 0}, {0, 0, 1}, ""}};
  scene.time.subcycling = subcycling;
  return scene;
}

TEST(TetrahedraSubcycling, MakeTheSmallestStep) {
  const Scene scene = subcycled(true);
  const ModelMesh mesh = build_mesh(scene);
  const ElementLevels levels = element_step_levels(scene, mesh);
  constexpr std::size_t tetrahedra = 5 * 5 * 6 * 6, of_layer = 5 * 5;
  for (std::size_t e = 0; e < tetrahedra + of_layer; ++e) EXPECT_EQ(levels.level[e], 0) << e;
  for (std::size_t e = 0; e < tetrahedra; ++e) EXPECT_EQ(levels.own[e], 0) << e;
  for (std::size_t e = tetrahedra + of_layer; e < mesh.hexahedra.size(); ++e) EXPECT_GT(levels.level[e], 0) << e;
}

/// Also where hexahedra need smaller ones.
TEST(TetrahedraSubcycling, MakeTheSmallestStepWhateverTheirSize) {
  Scene scene = scene_of({cut(block("coarse", {2, 2, 2}, 0.1, {0, 0, 0})), block("fine", {2, 2, 2}, 0.01, {1, 0, 0})},
                         1e-5, false);
  scene.time.subcycling = true;
  const ElementLevels levels = element_step_levels(scene, build_mesh(scene));
  EXPECT_THAT(levels.level, testing::Each(0));
}

struct End {
  double height = 0, width = 0, balance = 0;
  std::int64_t left_out = 0;
};

End end_of(const Scene& scene) {
  Solver<double> solver(scene);
  End end;
  end.balance = worst_balance_of_run(solver);
  end.left_out = solver.counts().work().subcycled_element_steps;
  for (std::size_t n = 0; n < solver.model().node_mass.size(); ++n) {
    const double* const x = solver.model().nodes.position_of(n);
    end.height = std::max(end.height, x[2]);
    end.width = std::max(end.width, x[0]);
  }
  return end;
}

TEST(TetrahedraSubcycling, ComeToTheSameAnswer) {
  const End together = end_of(subcycled(false)), apart = end_of(subcycled(true));
  EXPECT_EQ(together.left_out, 0);
  EXPECT_GT(apart.left_out, 1000);
  EXPECT_LT(apart.balance, 5e-3);
  ASSERT_LT(together.height, 0.075);  // of 0.078
  EXPECT_NEAR(apart.height, together.height, 0.01 * (0.078 - together.height));
  EXPECT_NEAR(apart.width, together.width, 0.01 * (together.width - 0.05));
}

TEST(TetrahedraSubcycling, GoOnFromASavedState) {
  for (const Precision precision : {Precision::float64, Precision::mixed}) {
    const Scene scene = subcycled(true, precision);
    Solver<double> whole(scene), first(scene), rest(scene);
    for (int i = 0; i < 20; ++i) first.step();
    ASSERT_FALSE(first.at_end());
    load(rest, saved(first));
    run(whole);
    run(rest);
    EXPECT_EQ(state_hash(rest.model()), state_hash(whole.model()));
  }
}

TEST(TetrahedraSubcycling, HaveTheSameBitsForAnyNumberOfThreads) {
  const auto hash = [](int threads) {
    DefaultExecutionSpace::set_concurrency(threads);
    Solver<double> solver(subcycled(true));
    run(solver);
    DefaultExecutionSpace::set_concurrency(1);
    return state_hash(solver.model());
  };
  EXPECT_EQ(hash(3), hash(1));
}

/// What erodes lets what is around it make the smallest step, too.
TEST(TetrahedraSubcycling, GoWithErosion) {
  Scene scene = subcycled(true);
  scene.materials = {plastic_material("steel", 3e8, 0.08)};
  Solver<double> solver(scene);
  EXPECT_LT(worst_balance_of_run(solver), 5e-3);
  EXPECT_GT(solver.counts().eroded_elements(), 10);
}

}  // namespace
}  // namespace pinball::test::tetrahedra_subcycling_test
