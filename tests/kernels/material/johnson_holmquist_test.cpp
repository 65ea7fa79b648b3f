#include <gtest/gtest.h>

#include <cmath>

#include <kernels/material/johnson_holmquist.hpp>

/// Strength, damage and pressure against the formulas of the paper.
namespace pinball::johnson_holmquist_test {
namespace {

/// Boron carbide in MPa and s, with a limit of the strength of fragments.
JohnsonHolmquistConstants<double> carbide() {
  JohnsonHolmquistConstants<double> law;
  law.used = true;
  law.intact = 0.927, law.intact_exponent = 0.67;
  law.fractured = 0.7, law.fractured_exponent = 0.85, law.most_fractured = 0.2;
  law.rate_sensitivity = 0.005, law.inverse_rate = 1;
  law.measure = StrainRateMeasure::deviatoric;
  law.tension = 260, law.inverse_pressure = 1 / 8710.0, law.stress = 1.5 * (19000 - 8710);
  law.failure = 0.001, law.failure_exponent = 0.5;
  law.modulus[0] = 233e3, law.modulus[1] = -593e3, law.modulus[2] = 2800e3;
  law.bulking = 0.8;
  return law;
}

MaterialConstants<double> constants() {
  MaterialConstants<double> m{};
  m.lambda = 1e5, m.mu = 197e3;
  return m;
}

/// Y of the paper.
double strength(double pressure, double rate, double damage) {
  const double over = pressure / 8710, above = over + 260 / 8710.0, factor = 1 + 0.005 * std::log(std::max(1.0, rate));
  const double intact = above > 0 ? 0.927 * std::pow(above, 0.67) : 0;
  const double fractured = over > 0 ? 0.7 * std::pow(over, 0.85) : 0;
  return 1.5 * (19000 - 8710) * ((1 - damage) * factor * intact + damage * std::min(0.2, factor * fractured));
}

TEST(JohnsonHolmquist, HasTheStrengthOfPressureRateAndDamage) {
  const MaterialConstants<double> m = constants();
  const JohnsonHolmquistConstants<double> law = carbide();
  for (const double pressure : {-300.0, -260.0, -100.0, 0.0, 500.0, 3000.0, 8710.0, 40000.0}) {
    for (const double shear : {0.0, 0.5, 1e5}) {
      for (const double damage : {0.0, 0.4, 1.0}) {
        JohnsonHolmquistYield<double> strong(m, law, {0, 0, 0, shear, 0, 0}, pressure, damage);
        EXPECT_NEAR(strong.yield_stress(0), strength(pressure, 0, damage), 1e-11 * 15000);
        strong.apply_rate();
        const double expected = strength(pressure, 2 / std::sqrt(3.0) * shear, damage), q = expected + 3 * m.mu * 1e-3;
        EXPECT_NEAR(strong.yield_stress(0), expected, 1e-11 * 15000) << pressure << " " << shear << " " << damage;
        EXPECT_NEAR(strong.increment(q, 0), 1e-3, 1e-12);
        EXPECT_EQ(strong.increment(0.99 * expected - 1, 0), 0);
      }
    }
  }
}

TEST(JohnsonHolmquist, BreaksByPlasticStrainOverThatOfItsPressure) {
  const MaterialConstants<double> m = constants();
  JohnsonHolmquistConstants<double> law = carbide();
  for (const double pressure : {-100.0, 0.0, 3000.0, 8710.0}) {
    const JohnsonHolmquistYield<double> strong(m, law, {0, 0, 0, 0, 0, 0}, pressure, 0.2);
    const double ductility = 0.001 * std::sqrt((pressure + 260) / 8710);
    EXPECT_NEAR(strong.damaged_by(0.3 * ductility), 0.5, 1e-12);
    EXPECT_EQ(strong.damaged_by(2 * ductility), 1);
    EXPECT_EQ(strong.damaged_by(0), 0.2);
  }
  const JohnsonHolmquistYield<double> torn(m, law, {0, 0, 0, 0, 0, 0}, -300, 0.2);
  EXPECT_EQ(torn.damaged_by(1e-9), 1);  // beyond its tensile strength
  EXPECT_EQ(torn.damaged_by(0), 0.2);
  law.failure = 0;  // where it yields
  const JohnsonHolmquistYield<double> brittle(m, law, {0, 0, 0, 0, 0, 0}, 3000, 0.2);
  EXPECT_EQ(brittle.damaged_by(1e-9), 1);
  EXPECT_EQ(brittle.damaged_by(0), 0.2);
}

TEST(JohnsonHolmquist, HasTheSlopeOfItsPressure) {
  const JohnsonHolmquistConstants<double> law = carbide();
  for (const double mu : {-0.01, 0.0, 0.02, 0.07, 0.2}) {
    const double h = 1e-6, compressed = std::max(0.0, mu);
    const double expected =
        233e3 * mu - 593e3 * compressed * compressed + 2800e3 * compressed * compressed * compressed;
    EXPECT_NEAR(brittle_pressure(law, mu).value, expected, 1e-9);
    const double slope = (brittle_pressure(law, mu + h).value - brittle_pressure(law, mu - h).value) / (2 * h);
    EXPECT_NEAR(brittle_pressure(law, mu).slope, slope, 1e-5 * 233e3);
  }
}

TEST(JohnsonHolmquist, PressesByTheEnergyThatDamageSetsFree) {
  const JohnsonHolmquistConstants<double> law = carbide();
  const double elastic = 4000, before = 300, freed = (9000.0 * 9000.0 - 5000.0 * 5000.0) / (6 * 197e3);
  const double after = bulking_after(law, 197e3, elastic, before, 9000.0, 5000.0);
  EXPECT_NEAR(std::pow(elastic + after, 2), std::pow(elastic + before, 2) + 2 * 0.8 * 233e3 * freed, 1e-6);
  EXPECT_GT(after, before);
  EXPECT_EQ(bulking_after(law, 197e3, -elastic, before, 9000.0, 5000.0), before);  // in tension
  EXPECT_EQ(bulking_after(law, 197e3, elastic, before, 5000.0, 9000.0), before);   // it never becomes stronger so
}

}  // namespace
}  // namespace pinball::johnson_holmquist_test
