#include <gtest/gtest.h>

#include <cmath>

#include <kernels/material/drucker_prager.hpp>

/// Strength over the pressure, against its formula.
namespace pinball::drucker_prager_test {
namespace {

DruckerPragerConstants<double> soil(double constant, double linear, double quadratic) {
  DruckerPragerConstants<double> law;
  law.used = true;
  law.constant = constant, law.linear = linear, law.quadratic = quadratic;
  if (quadratic > 0) law.apex = -linear / (2 * quadratic);
  return law;
}

TEST(DruckerPrager, HasTheStrengthOfItsPolynomialAndNoneBeyondItsRoot) {
  for (const double p : {-1.0, 0.0, 0.3, 2.0, 50.0}) {
    EXPECT_DOUBLE_EQ(strength_square(soil(4, 3, 0.5), p), 4 + 3 * p + 0.5 * p * p) << p;
  }
  EXPECT_EQ(strength_square(soil(4, 3, 0.5), -2.5), 0);  // the roots are -2 and -4
  EXPECT_EQ(strength_square(soil(4, 3, 0.5), -10.0), 0);
  EXPECT_EQ(strength_square(soil(4, 3, 0), -2.0), 0);
  EXPECT_EQ(strength_square(soil(0, 0, 0.5), -1.0), 0);
  EXPECT_EQ(strength_square(soil(4, 0, 0), -100.0), 4);
  EXPECT_DOUBLE_EQ(strength_square(soil(4, 2, 0.5), -2.0), 2);  // without a root: the least is at -2
  EXPECT_DOUBLE_EQ(strength_square(soil(4, 2, 0.5), -9.0), 2);
}

TEST(DruckerPrager, EndsAtItsLimits) {
  DruckerPragerConstants<double> law = soil(4, 3, 0.5);
  law.most = 20, law.none = -0.5;
  EXPECT_DOUBLE_EQ(strength_square(law, 3.0), 17.5);
  EXPECT_EQ(strength_square(law, 30.0), 20);
  EXPECT_GT(strength_square(law, -0.49), 2);
  EXPECT_EQ(strength_square(law, -0.5), 0);
}

/// A cone sqrt(J) = k + b p.
TEST(DruckerPrager, IsACone) {
  const double k = 0.7, b = 0.4;
  const DruckerPragerConstants<double> law = soil(k * k, 2 * k * b, b * b);
  for (const double p : {-1.7, 0.0, 3.0}) EXPECT_NEAR(std::sqrt(strength_square(law, p)), k + b * p, 1e-12);
  EXPECT_NEAR(strength_square(law, -1.8), 0, 1e-12);
}

TEST(DruckerPrager, ReturnsToItsEffectiveStress) {
  MaterialConstants<double> material{};
  material.mu = 80;
  const IdealYield<double> law(material, effective_strength(soil(4, 3, 0.5), 2.0));
  const double yield = std::sqrt(3 * 12.0);
  EXPECT_DOUBLE_EQ(law.yield_stress(0.3), yield);
  EXPECT_NEAR(law.increment(yield + 240 * 1e-3, 0), 1e-3, 1e-15);
  EXPECT_EQ(law.increment(0.9 * yield, 0), 0);
}

}  // namespace
}  // namespace pinball::drucker_prager_test
