#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include <solver/program/study/costs/run_times.hpp>

namespace pinball::run_times_test {
namespace {

struct Measured {
  std::string scene;
  std::vector<MadeRun> runs;
};

/// `pinball converge SCENE --threads 1 --only mesh`, alone on a virtual machine of two processors (AVX-512).
const std::vector<Measured> measured{
    {"two_bars", {{1, 20, 111, 0.00177}, {2, 160, 220, 0.00475}, {4, 1280, 439, 0.04293}, {8, 10240, 877, 0.42967}}},
    {"two_blocks", {{0.5, 16, 39, 0.0011}, {1, 128, 74, 0.00255}, {2, 1024, 148, 0.01688}, {4, 8192, 296, 0.1422}}},
    {"cantilever", {{1, 160, 8228, 0.14427}, {2, 1280, 16455, 1.60263}, {3, 4320, 24682, 8.39004}}},
    {"taylor_bar of 480",
     {{0.5, 60, 1775, 0.02216}, {1, 480, 5809, 0.37325}, {1.5, 1620, 11196, 2.18583}, {2, 3840, 16749, 6.15407}}},
    {"sphere_floor", {{1, 1116, 1547, 0.2078}, {2, 8928, 3271, 1.9209}, {3, 30132, 4964, 10.6396}}},
    {"rod_plate", {{1, 1842, 605, 0.11249}, {2, 14736, 1370, 1.8007}, {3, 49734, 2082, 9.62028}}},
    {"plate_impact",
     {{1, 100, 382, 0.00821}, {2, 800, 764, 0.06449}, {4, 6400, 1528, 0.88389}, {8, 51200, 3055, 12.88321}}},
    {"newtons_cradle", {{1, 50, 139, 0.00469}, {2, 400, 278, 0.01761}, {3, 1350, 417, 0.05449}}}};

TEST(RunTimes, TheNextFinerMeshIsForetoldWithinAFactorOfOneAndAHalf) {
  for (const Measured& scene : measured) {
    for (std::size_t made = 2; made < scene.runs.size(); ++made) {
      const MadeRun& next = scene.runs[made];
      const RunTimes times({scene.runs.begin(), scene.runs.begin() + static_cast<std::ptrdiff_t>(made)});
      const double ratio = times.expected(next.factor).value() / next.seconds;
      EXPECT_GT(ratio, 1 / 1.5) << scene.scene << ", mesh " << next.factor;
      EXPECT_LT(ratio, 1.5) << scene.scene << ", mesh " << next.factor;
    }
  }
}

TEST(RunTimes, AMeshBetweenTwoIsForetoldByBoth) {
  for (const Measured& scene : measured) {
    std::vector<MadeRun> others = scene.runs;
    const MadeRun middle = others[others.size() - 2];
    others.erase(others.end() - 2);
    const double ratio = RunTimes(others).expected(middle.factor).value() / middle.seconds;
    EXPECT_LT(std::abs(std::log(ratio)), std::log(2.0)) << scene.scene;
  }
}

TEST(RunTimes, OneRunGrowsWithTheFourthPower) {
  EXPECT_DOUBLE_EQ(RunTimes({{2, 80, 10, 3}}).expected(4).value(), 48);
  EXPECT_DOUBLE_EQ(RunTimes({{2, 80, 10, 3}}).elements(4).value(), 640);
  EXPECT_FALSE(RunTimes({}).expected(1));
}

TEST(RunTimes, WhatWasMadeIsKnown) {
  const RunTimes times({{2, 80, 10, 0.3}, {1, 10, 5, 0.1}});
  EXPECT_EQ(times.expected(1), 0.1);
  EXPECT_EQ(times.expected(2), 0.3);
}

/// A run that lasts no longer than the clock says: nothing is divided by zero.
TEST(RunTimes, RunsWithoutATimeHaveSome) {
  const double seconds = RunTimes({{1, 1, 1, 0}, {2, 8, 2, 0}}).expected(4).value();
  EXPECT_TRUE(std::isfinite(seconds));
  EXPECT_GT(seconds, 0);
}

}  // namespace
}  // namespace pinball::run_times_test
