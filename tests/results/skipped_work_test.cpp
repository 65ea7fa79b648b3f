#include <gtest/gtest.h>

#include <solver/results/skipped_work.hpp>
#include <tests/support/solver_case.hpp>

/// What a run says that leaving out work has saved.
namespace pinball::skipped_work_test {
namespace {

TEST(SkippedWork, CountsWhatTheFeaturesOfASceneNeedNotStore) {
  ElementStoreFeatures all;
  all.plastic = all.erosion = all.bulk_viscosity = all.hourglass_state = true;
  for (const bool single : {false, true}) {
    const ElementStore full(3, all, single), least(3, ElementStoreFeatures{}, single);
    EXPECT_EQ(bytes_not_stored(full), 0);
    EXPECT_EQ(bytes_not_stored(least), static_cast<double>(full.bytes() - least.bytes()));
  }
}

TEST(SkippedWork, NothingSkippedSavesNothing) {
  const SkippedSeconds none = estimate_skipped(WorkCounts{}, Timers{}, 0);
  EXPECT_EQ(none.resting, 0);
  EXPECT_EQ(none.searches, 0);
  EXPECT_EQ(none.inner_elements, 0);
}

TEST(SkippedWork, ARunTellsWhatItSkipped) {
  const Scene scene = read_scene(find_scene("two_blocks"));
  Solver<double> solver(scene);
  test::run(solver);
  RunSummary s;
  fill_summary(solver, s);
  EXPECT_GT(s.element_steps_resting, 0);
  EXPECT_GT(s.skipped_seconds.resting, 0);
  EXPECT_GT(s.searches_skipped, 0);
  EXPECT_GE(s.skipped_seconds.searches, 0);
  EXPECT_EQ(s.inner_element_steps, s.steps * (s.elements - s.pinballs));
  EXPECT_GT(s.skipped_seconds.inner_elements, 0);
  EXPECT_GT(s.bytes_not_stored, 0);
}

}  // namespace
}  // namespace pinball::skipped_work_test
