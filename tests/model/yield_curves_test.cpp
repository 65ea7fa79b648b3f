#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include <solver/model/material/yield_curves.hpp>

/// The numbers that the general yield law gets of a material: each of them, against what can be worked out by hand.
namespace pinball::yield_curves_test {
namespace {

using testing::ElementsAre;
using testing::Pointwise;

MATCHER(IsNearTo, "") {
  const auto [found, expected] = arg;
  return std::abs(found - expected) <= 1e-12 * std::abs(expected);
}

Material hardening(double share, double ultimate) {
  Material m;
  m.plastic = true;
  m.yield_stress = 3e8;
  m.plastic_modulus = 2e9;
  m.isotropic_share = share;
  m.ultimate_stress = ultimate;
  return m;
}

void expect_curves(const Material& m, const std::vector<double>& strain, const std::vector<double>& stress,
                   const std::vector<double>& slope) {
  const YieldCurves<double> curves = yield_curves<double>(m);
  EXPECT_THAT(curves.strain, Pointwise(IsNearTo(), strain));
  EXPECT_THAT(curves.stress, Pointwise(IsNearTo(), stress));
  EXPECT_THAT(curves.slope, Pointwise(IsNearTo(), slope));
}

TEST(YieldCurves, OfLinearHardeningGrowByTheirShareUpToTheUltimateStress) {
  expect_curves(hardening(0.25, 4e8), {0, 0.2, 1.2}, {3e8, 4e8, 4e8}, {5e8, 0, 0});
  expect_curves(hardening(0.25, 0), {0, 1}, {3e8, 8e8}, {5e8, 5e8});
  expect_curves(hardening(1, 0), {0, 1}, {3e8, 2.3e9}, {2e9, 2e9});
  expect_curves(hardening(0, 4e8), {0}, {3e8}, {0});
}

TEST(YieldCurves, OfSeveralRatesHaveThePointsOfAll) {
  Material m = hardening(1, 0);
  m.yield_curves = {{1, {0, 0.01, 0.1}, {3e8, 4e8, 4.9e8}}, {1000, {0, 0.04}, {4e8, 6e8}}};
  expect_curves(m, {0, 0.01, 0.04, 0.1}, {3e8, 4e8, 4.3e8, 4.9e8, 4e8, 4.5e8, 6e8, 9e8},
                {1e10, 1e9, 1e9, 1e9, 5e9, 5e9, 5e9, 5e9});
  EXPECT_THAT(yield_curves<double>(m).rate, ElementsAre(1, 1000));
  m.rate_interpolation = RateInterpolation::logarithmic;
  EXPECT_THAT(yield_curves<double>(m).rate, ElementsAre(0, std::log(1000.0)));
  m.yield_curves.pop_back();
  EXPECT_THAT(yield_curves<double>(m).rate, ElementsAre(1)) << "the rate of one is not used";
}

TEST(YieldCurves, ThatFallAtTheirEndGoOnLevel) {
  Material m = hardening(1, 0);
  m.yield_curves = {{1, {0, 0.1}, {3e8, 2e8}}, {1000, {0, 0.2}, {4e8, 6e8}}};
  expect_curves(m, {0, 0.1, 0.2}, {3e8, 2e8, 2e8, 4e8, 5e8, 6e8}, {-1e9, 0, 0, 1e9, 1e9, 1e9});
}

TEST(HardeningConstants, AreThoseOfTheMaterial) {
  Material m = hardening(0.25, 0);
  m.yield_curves = {{1, {0, 0.01, 0.1}, {3e8, 4e8, 4.9e8}}, {1000, {0, 0.04}, {4e8, 6e8}}};
  m.rate_constant = 40;
  m.rate_exponent = 5;
  const YieldCurves<double> curves = yield_curves<double>(m);
  HardeningConstants<double> h = hardening_constants(m, curves);
  EXPECT_EQ(h.kinematic_modulus, 1.5e9);
  EXPECT_EQ(h.points, 4);
  EXPECT_EQ(h.curves, 2);
  EXPECT_EQ(h.strain, curves.strain.data());
  EXPECT_EQ(h.stress, curves.stress.data());
  EXPECT_EQ(h.slope, curves.slope.data());
  EXPECT_EQ(h.rate, curves.rate.data());
  EXPECT_FALSE(h.logarithmic);
  EXPECT_EQ(h.rate_constant, 40);
  EXPECT_EQ(h.rate_exponent, 5);
  EXPECT_EQ(h.rate_share, 1);
  EXPECT_EQ(h.rate_stress, 0);
  m.rate_stress = 2e8;
  m.rate_interpolation = RateInterpolation::logarithmic;
  h = hardening_constants(m, curves);
  EXPECT_EQ(h.rate_share, 0) << "what is added is not in proportion to the yield stress";
  EXPECT_EQ(h.rate_stress, 2e8);
  EXPECT_TRUE(h.logarithmic);
}

TEST(HardeningConstants, MeasureTheRateWhereTheYieldStressDependsOnIt) {
  Material m = hardening(0.25, 0);
  const auto measure = [&](StrainRate rate) {
    m.strain_rate = rate;
    return hardening_constants(m, yield_curves<double>(m)).measure;
  };
  for (const StrainRate rate : {StrainRate::total, StrainRate::deviatoric, StrainRate::plastic})
    EXPECT_EQ(measure(rate), StrainRateMeasure::total) << "it does not";
  m.rate_constant = 40;
  for (int way = 0; way < 2; ++way) {
    EXPECT_EQ(measure(StrainRate::total), StrainRateMeasure::total);
    EXPECT_EQ(measure(StrainRate::deviatoric), StrainRateMeasure::deviatoric);
    EXPECT_EQ(measure(StrainRate::plastic), StrainRateMeasure::plastic);
    m.rate_constant = 0;
    m.yield_curves = {{1, {0}, {3e8}}, {1000, {0}, {4e8}}};
  }
}

TEST(GeneralYield, IsForWhatMovesDependsOnTheRateOrHasCurves) {
  EXPECT_FALSE(has_general_yield(hardening(1, 4e8)));
  EXPECT_TRUE(has_general_yield(hardening(0.5, 4e8)));
  Material m = hardening(1, 0);
  m.rate_constant = 1;
  EXPECT_TRUE(has_general_yield(m));
  m.plastic = false;
  EXPECT_FALSE(has_general_yield(m));
  m = hardening(1, 0);
  m.yield_curves = {{0, {0}, {1}}};
  EXPECT_TRUE(has_general_yield(m));
}

}  // namespace
}  // namespace pinball::yield_curves_test
