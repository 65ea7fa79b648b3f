#include <gtest/gtest.h>

#include <cmath>

#include <kernels/material/johnson_cook.hpp>

/// The equation for the increment, and damage, against the formulas of the papers.
namespace pinball::johnson_cook_test {
namespace {

/// 4340 steel (Johnson and Cook 1985) in MPa, s, K; heating over density is left to the element.
JohnsonCookConstants<double> steel(StrainRateMeasure measure) {
  JohnsonCookConstants<double> law;
  law.used = true;
  law.hardening = 510, law.exponent = 0.26;
  law.rate_sensitivity = 0.014, law.inverse_rate = 1;
  law.inverse_melting = 1 / (1793.0 - 294.0), law.softening_exponent = 1.03;
  law.measure = measure;
  const double d[5] = {0.05, 3.44, -2.12, 0.002, 0.61};
  std::copy(d, d + 5, law.failure);
  return law;
}

MaterialConstants<double> constants() {
  MaterialConstants<double> m{};
  m.lambda = 1.1e5, m.mu = 7.7e4, m.yield_stress = 792;
  return m;
}

/// Y of the paper.
double strength(double strain, double rate, double temperature) {
  const double h = temperature / 1499;
  return (792 + 510 * std::pow(strain, 0.26)) * (1 + 0.014 * std::log(std::max(1.0, rate))) * (1 - std::pow(h, 1.03));
}

constexpr Symmetric<double> shearing(double rate) { return {0, 0, 0, rate, 0, 0}; }

TEST(JohnsonCook, ReturnsToTheStrengthOfTheEnd) {
  const MaterialConstants<double> m = constants();
  const double dt = 1e-7, temperature = 200;
  for (const double shear : {1e-3, 1e2, 1e4, 1e6}) {  // rates of the tensor's component
    for (const double strain : {0.0, 1e-9, 1e-3, 0.03, 0.3, 2.0}) {
      for (const double q : {900.0, 1500.0, 8000.0}) {
        for (const StrainRateMeasure measure :
             {StrainRateMeasure::total, StrainRateMeasure::deviatoric, StrainRateMeasure::plastic}) {
          const JohnsonCookConstants<double> constants_of_law = steel(measure);
          JohnsonCookYield<double> law(m, constants_of_law, shearing(shear), dt, strain, temperature);
          law.apply_rate();
          const double dl = law.increment(q, strain);
          const double rate = measure == StrainRateMeasure::total        ? std::sqrt(2.0) * shear
                              : measure == StrainRateMeasure::deviatoric ? 2 / std::sqrt(3.0) * shear
                                                                         : dl / dt;
          const double yield = strength(strain + dl, rate, temperature);
          if (dl > 0) {
            EXPECT_NEAR(yield + 3 * m.mu * dl, q, 1e-13 * q) << shear << " " << strain;
          } else {
            EXPECT_LE(q, strength(strain, rate, temperature) * (1 + 1e-12));
          }
        }
      }
    }
  }
}

TEST(JohnsonCook, IsWeakenedInProportionToItsDamage) {
  JohnsonCookConstants<double> constants_of_law = steel(StrainRateMeasure::total);
  constants_of_law.weakening = 0.3;
  for (const double damage : {0.0, 0.5, 1.0, 2.0}) {
    JohnsonCookYield<double> law(constants(), constants_of_law, shearing(0), 1e-7, 0.1, 200.0);
    law.weaken(damage);
    EXPECT_NEAR(law.yield_stress(0.1), (1 - 0.3 * std::min(1.0, damage)) * strength(0.1, 1, 200), 1e-10);
  }
}

TEST(JohnsonCook, HasNoStrengthWhereItHasMelted) {
  const JohnsonCookConstants<double> constants_of_law = steel(StrainRateMeasure::total);
  JohnsonCookYield<double> law(constants(), constants_of_law, shearing(1), 1e-7, 0.1, 1600.0);
  EXPECT_EQ(law.yield_stress(0.1), 0);
  EXPECT_DOUBLE_EQ(law.increment(500.0, 0.1), 500 / (3 * 7.7e4));
}

TEST(JohnsonCook, IsDamagedByStrainOverThatAtFailure) {
  const JohnsonCookConstants<double> law = steel(StrainRateMeasure::total);
  for (const double mean : {-800.0, 0.0, 250.0, 500.0}) {
    const double q = 1000, rate = 2e3, temperature = 300;
    const Symmetric<double> stress{mean + 2 * q / 3, mean - q / 3, mean - q / 3, 0, 0, 0};  // of effective stress q
    const double at_failure =
        (0.05 + 3.44 * std::exp(-2.12 * mean / q)) * (1 + 0.002 * std::log(rate)) * (1 + 0.61 * temperature / 1499);
    EXPECT_NEAR(damage_increment(law, stress, 0.01, rate, temperature), 0.01 / at_failure, 1e-14 / at_failure);
  }
  EXPECT_EQ(damage_increment(law, Symmetric<double>{1, 1, 1, 0, 0, 0}, 0.0, 1.0, 0.0), 0);
}

}  // namespace
}  // namespace pinball::johnson_cook_test
