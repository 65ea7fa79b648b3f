#include <gtest/gtest.h>

#include <cstdint>
#include <utility>

#include <tests/support/solver_case.hpp>
#include <tests/support/support.hpp>

/// Whole runs with lists that outlast erosions, against runs that build lists anew.
namespace pinball::kept_lists_test {
namespace {

using namespace test;

/// State at the end, and what happened on the way.
struct Outcome {
  std::uint64_t hash = 0;
  std::int64_t searches = 0, erosions = 0;  ///< steps in which elements erode
};
Outcome outcome(Scene scene, bool keep_lists) {
  scene.skip.contact_search = keep_lists;
  Solver<double> solver(scene);
  Outcome result;
  std::int64_t eroded = 0;
  run_to_end(solver, [&] {
    result.erosions += solver.counts().eroded_elements() != std::exchange(eroded, solver.counts().eroded_elements());
  });
  result.hash = state_hash(solver.model());
  result.searches = solver.contact()->searches();
  return result;
}

TEST(KeptLists, LastOverErosionsOfARodAndAPlateAndMissNothing) {
  const double h = 0.1;
  Scene scene = scene_of(
      {block("plate", {8, 8, 3}, h, {0, 0, 0}), block("rod", {2, 2, 8}, h, {0.27, 0.31, 3.1 * h}, {300, 0, -2000})},
      4e-4);
  scene.materials = {plastic_material("steel", 1e9, 0.6)};
  scene.contact.gap = ContactGap::face;
  for (const Enforcement enforcement : {Enforcement::lagrange, Enforcement::projection}) {
    scene.contact.enforcement = enforcement;
    const Outcome kept = outcome(scene, true), anew = outcome(scene, false);
    EXPECT_EQ(kept.hash, anew.hash);
    EXPECT_EQ(kept.erosions, anew.erosions);
    EXPECT_GT(kept.erosions, 20);
    EXPECT_LT(kept.searches, kept.erosions);
  }
}

}  // namespace
}  // namespace pinball::kept_lists_test
