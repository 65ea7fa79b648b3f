#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include <kernels/material/crushable_foam.hpp>

/// Strength, air and stiffness of foams, against their formulas.
namespace pinball::crushable_foam_test {
namespace {

/// Y of 2 at the compaction 0, 3 at 0.1 and 13 at 0.5.
struct Curve {
  Curve() {
    constants.points = 3;
    constants.curves = 1;
    constants.strain = strain.data();
    constants.stress = stress.data();
    constants.slope = slope.data();
  }
  std::array<double, 3> strain{0, 0.1, 0.5}, stress{2, 3, 13}, slope{10, 25, 25};
  HardeningConstants<double> constants{};
};

TEST(CrushableFoam, HasTheStrengthOfItsCurve) {
  const Curve curve;
  using Point = std::array<double, 2>;
  for (const auto& [x, stress] :
       {Point{-0.3, 2.0}, Point{0.0, 2.0}, Point{0.04, 2.4}, Point{0.2, 5.5}, Point{0.7, 18}}) {
    EXPECT_DOUBLE_EQ(foam_strength(curve.constants, x).stress, stress) << x;
  }
}

TEST(CrushableFoam, IsNeverStrongerThanNothing) {
  Curve curve;
  curve.stress = {2, 1, 0.5};
  curve.slope = {-10, -1.25, -1.25};
  EXPECT_EQ(foam_strength(curve.constants, 0.95).stress, 0);
}

TEST(CrushableFoam, PressesItsAirAtConstantTemperature) {
  CrushableFoamConstants<double> law;
  law.air_pressure = 3, law.open_share = 0.8;
  EXPECT_EQ(air_pressure(law, -0.2).value, 0);
  for (const double x : {0.0, 0.1, 0.5, 0.7}) {
    // p + P_0 over the volume of the air is what it was
    EXPECT_NEAR((air_pressure(law, x).value + 3) * (0.8 - x), 3 * 0.8, 1e-14) << x;
    const double slope = (air_pressure(law, x + 2e-6).value - air_pressure(law, x).value) / 2e-6;
    EXPECT_NEAR(air_pressure(law, x + 1e-6).slope, slope, 1e-6 * slope) << x;
  }
  EXPECT_GT(air_pressure(law, 0.9).value, air_pressure(law, 0.85).value) << "without air it goes on";
}

TEST(CrushableFoam, IsAsStiffAsItsCurveAndItsAir) {
  const Curve curve;
  CrushableFoamConstants<double> law;
  EXPECT_DOUBLE_EQ(foam_bulk_modulus(law, curve.constants, 40.0, 0.2), 40);
  EXPECT_DOUBLE_EQ(foam_bulk_modulus(law, curve.constants, 4.0, 0.2), 0.8 * 25);
  law.air_pressure = 3, law.open_share = 0.8;
  EXPECT_DOUBLE_EQ(foam_bulk_modulus(law, curve.constants, 40.0, 0.2), 40 + 0.8 * 3 * 0.8 / 0.36);
}

/// Of a bar that is pressed by 0.03 with a Poisson's ratio of 0, of a pressure, and of a shear.
TEST(CrushableFoam, CountsThePlasticStrainOfWhatIsTaken) {
  MaterialConstants<double> m{};
  m.mu = 50;
  EXPECT_NEAR(crushing_increment(m, Symmetric<double>{-3, 0, 0, 0, 0, 0}), std::sqrt(2.0 / 3) * 0.03, 1e-15);
  m.lambda = 30;
  EXPECT_NEAR(crushing_increment(m, Symmetric<double>{-3, -3, -3, 0, 0, 0}), std::sqrt(2.0) * 3 / 190, 1e-15);
  EXPECT_NEAR(crushing_increment(m, Symmetric<double>{0, 0, 0, 3, 0, 0}), 2 / std::sqrt(3.0) * 0.03, 1e-15);
}

}  // namespace
}  // namespace pinball::crushable_foam_test
