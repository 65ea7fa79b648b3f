#include <gtest/gtest.h>

#include <cmath>

#include <solver/program/study/study_quantities.hpp>

namespace pinball::study_quantities_test {
namespace {

const std::vector<double> times{0, 1, 3};

/// Of a column q: what elements of no size give, and a part of another curve.
StudyRun run_of(double part) {
  StudyRun run;
  run.results = RunResults{};
  run.results->status = "done";
  run.results->rows = {{"time", times}, {"q", {2 + part, 5 - 2 * part, 3 + 4 * part}}};
  run.results->columns = {"time", "q"};
  return run;
}

double norm_of_part() { return norm({times, {1, -2, 4}}); }

/// Meshes of elements of sizes 3, 2, 1 and 1/2, whose curves err by 0.1 h^2.
ConvergenceStudy study_of_curves() {
  ConvergenceStudy study;
  study.meshes = {
      {{1, 3}, "", run_of(0.9)}, {{1, 2}, "", run_of(0.4)}, {{1, 1}, "", run_of(0.1)}, {{2, 1}, "", run_of(0.025)}};
  study.sources_mesh = 2;
  study.sources = {{ErrorSource::step, "time step", "", {run_of(0.13)}},
                   {ErrorSource::chance, "chance", "", {run_of(0.12), run_of(0.14)}}};
  return study;
}

TEST(StudyQuantities, CurvesAreAsFarFromWhatFinerMeshesGiveAsTheyErr) {
  ConvergenceStudy study = study_of_curves();
  draw_quantities(Scene{}, {"q:curve"}, study);
  const StudyQuantity& q = study.quantities.at(0);
  ASSERT_TRUE(q.convergence && q.limit);
  EXPECT_EQ(q.convergence->verdict, Convergence::monotone);
  EXPECT_NEAR(q.convergence->order, 2, 1e-9);
  const double parts[] = {0.9, 0.4, 0.1, 0.025};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(q.values[i].value(), parts[i] * norm_of_part(), 1e-9) << i;
  const std::vector<double> limit{2, 5, 3};
  for (std::size_t i = 0; i < limit.size(); ++i) EXPECT_NEAR(q.limit->values[i], limit[i], 1e-9) << i;
  EXPECT_NEAR(q.moved.at(0).value(), 0.03 * norm_of_part(), 1e-12);
  EXPECT_NEAR(q.moved.at(1).value(), 0.02 * norm_of_part(), 1e-12);  // of 0.10, 0.12 and 0.14
}

/// The finest three that have come to their end.
TEST(StudyQuantities, CurvesOfRunsThatFailedDoNotCount) {
  ConvergenceStudy study = study_of_curves();
  study.meshes[3].run = {};
  study.sources.clear();
  draw_quantities(Scene{}, {"q:curve", "q"}, study);
  const StudyQuantity &curve = study.quantities.at(0), &last = study.quantities.at(1);
  EXPECT_NEAR(curve.values[2].value(), 0.1 * norm_of_part(), 1e-9);
  EXPECT_FALSE(curve.values[3]);
  EXPECT_NEAR(last.convergence->extrapolated, 3, 1e-9);
  study.meshes[1].run = {};
  draw_quantities(Scene{}, {"q:curve"}, study);
  EXPECT_FALSE(study.quantities.at(0).convergence);
  EXPECT_EQ(study.quantities.at(0).values[2], 0);  // the finest one is the best that there is
}

}  // namespace
}  // namespace pinball::study_quantities_test
