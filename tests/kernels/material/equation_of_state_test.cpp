#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include <kernels/material/equation_of_state.hpp>

/// Against jump conditions, differences and an independent integration of isentropes.
namespace pinball::equation_of_state_test {
namespace {

/// Copper in g, mm, ms: density 8.93e-3, stresses in MPa (Steinberg 1996).
EquationOfState<double> copper() {
  EquationOfState<double> eos;
  eos.law = PressureLaw::mie_grueneisen;
  eos.modulus = 8.93e-3 * 3940 * 3940;
  eos.slope[0] = 1.489;
  eos.gamma = 2.02;
  eos.gamma_slope = 0.47;
  eos.tension_limit = std::numeric_limits<double>::infinity();
  return eos;
}

EquationOfState<double> with_all_slopes() {
  EquationOfState<double> eos = copper();
  eos.slope[0] = 1.3, eos.slope[1] = 0.6, eos.slope[2] = -0.4;
  return eos;
}

EquationOfState<double> polynomial() {
  EquationOfState<double> eos;
  eos.law = PressureLaw::polynomial;
  const double c[7] = {0, 72e3, 172e3, 40e3, 1.9, 0.6, 0.3};
  std::copy(c, c + 7, eos.polynomial);
  eos.tension_limit = std::numeric_limits<double>::infinity();
  return eos;
}

/// Points at 0.2, 0, -0.1, -0.4 of ln V.
EquationOfState<double> table() {
  EquationOfState<double> eos;
  eos.law = PressureLaw::tabulated;
  eos.pieces = 3;
  const double strain[3] = {-0.2, 0, 0.1}, cold[3] = {-20e3, 0, 14e3}, rise[3] = {100e3, 140e3, 200e3};
  const double thermal[3] = {1.8, 2, 2}, thermal_rise[3] = {1, 0, -0.5};
  std::copy(strain, strain + 3, eos.strain);
  std::copy(cold, cold + 3, eos.cold);
  std::copy(rise, rise + 3, eos.cold_rise);
  std::copy(thermal, thermal + 3, eos.thermal);
  std::copy(thermal_rise, thermal_rise + 3, eos.thermal_rise);
  eos.tension_limit = std::numeric_limits<double>::infinity();
  return eos;
}

TEST(TabulatedPressure, IsStraightBetweenItsPointsAndGoesOn) {
  const auto at = [](double strain) { return pressure_parts(table(), std::expm1(strain)); };
  EXPECT_NEAR(at(-0.1).cold, -10e3, 1e-9);
  EXPECT_NEAR(at(-0.1).thermal, 1.9, 1e-14);
  EXPECT_NEAR(at(0.05).cold, 7e3, 1e-9);
  EXPECT_NEAR(at(0.2).cold, 34e3, 1e-9);
  EXPECT_NEAR(at(0.2).thermal, 1.95, 1e-14);
  EXPECT_NEAR(at(-0.3).cold, -30e3, 1e-9) << "before the first point";
  EXPECT_NEAR(at(0.9).cold, 174e3, 1e-9) << "behind the last";
}

/// Behind a shock u_s = c + (s1 + s2 x + s3 x^2) u_p, x = u_p/u_s = 1 - V/V_0, p = rho_0 u_s u_p and e = p x/2.
TEST(MieGrueneisen, HasTheHugoniotThatItIsMadeFrom) {
  for (const auto& eos : {copper(), with_all_slopes()}) {
    for (const double x : {1e-4, 0.01, 0.1, 0.2, 0.3}) {
      // u_s (1 - s x) = c with s = s1 + s2 x + s3 x^2, and so p = rho_0 c^2 x / (1 - s x)^2
      const double s = eos.slope[0] + eos.slope[1] * x + eos.slope[2] * x * x;
      const double p = eos.modulus * x / ((1 - s * x) * (1 - s * x)), mu = x / (1 - x);
      const PressureParts<double> at = pressure_parts(eos, mu);
      EXPECT_NEAR(at.cold + at.thermal * 0.5 * p * x, p, 1e-12 * p) << x;
    }
  }
}

TEST(EquationsOfState, HaveTheSlopesOfTheirParts) {
  for (const auto& eos : {copper(), with_all_slopes(), polynomial(), table()}) {
    for (const double mu : {-0.2, -0.01, 0.01, 0.1, 0.4, 2.5}) {  // the last: beyond the pole of copper()
      const double h = 1e-5;
      const PressureParts<double> at = pressure_parts(eos, mu), above = pressure_parts(eos, mu + h),
                                  below = pressure_parts(eos, mu - h);
      EXPECT_NEAR(at.cold_slope, (above.cold - below.cold) / (2 * h), 1e-7 * std::abs(at.cold_slope)) << mu;
      EXPECT_NEAR(at.thermal_slope, (above.thermal - below.thermal) / (2 * h), 1e-8) << mu;
    }
  }
}

/// An isentrope: de = p dmu/(1 + mu)^2, by the classic method of Runge and Kutta.
double energy_of_isentrope(const EquationOfState<double>& eos, double to) {
  const int steps = 20000;
  const double h = to / steps;
  const auto slope = [&eos](double mu, double e) {
    const PressureParts<double> at = pressure_parts(eos, mu);
    return (at.cold + at.thermal * e) / ((1 + mu) * (1 + mu));
  };
  double e = 0;
  for (int i = 0; i < steps; ++i) {
    const double mu = i * h, k1 = slope(mu, e), k2 = slope(mu + h / 2, e + h / 2 * k1),
                 k3 = slope(mu + h / 2, e + h / 2 * k2), k4 = slope(mu + h, e + h * k3);
    e += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return e;
}

/// The same in steps of the kernel.
PressureState<double> compressed(const EquationOfState<double>& eos, double to, int steps) {
  PressureState<double> now{0, 0, 0, 0};
  double volume = 1;
  for (int i = 1; i <= steps; ++i) {
    const double mu = to * i / steps, next = 1 / (1 + mu);
    now = pressure_after(eos, PressureStep<double>{mu, next - volume, 0, now.value}, now.energy);
    volume = next;
  }
  return now;
}

/// A = K ln(1 + mu) and B = 0: e = K (1 - (1 + x) exp(-x)) at x = ln(1 + mu).
TEST(TabulatedPressure, HasTheEnergyOfItsIsentrope) {
  EquationOfState<double> eos = table();
  eos.pieces = 1;
  eos.strain[0] = -0.5, eos.cold[0] = -50e3, eos.cold_rise[0] = 100e3, eos.thermal[0] = eos.thermal_rise[0] = 0;
  for (const double x : {0.3, -0.2}) {
    const double exact = 100e3 * (1 - (1 + x) * std::exp(-x));
    EXPECT_NEAR(energy_of_isentrope(eos, std::expm1(x)), exact, 1e-9 * exact);
    EXPECT_NEAR(compressed(eos, std::expm1(x), 2000).energy, exact, 2e-6 * exact);
  }
}

TEST(EquationsOfState, FollowIsentropesToTheSecondOrderOfTheStep) {
  for (const auto& eos : {copper(), polynomial()}) {
    for (const double to : {0.3, -0.1}) {
      const double exact = energy_of_isentrope(eos, to);
      const double coarse = std::abs(compressed(eos, to, 50).energy - exact),
                   fine = std::abs(compressed(eos, to, 200).energy - exact);
      EXPECT_LT(coarse, 2e-3 * std::abs(exact)) << to;
      EXPECT_NEAR(coarse / fine, 16, 1.5) << to;
    }
  }
}

TEST(EquationsOfState, HaveTheStiffnessOfTheirIsentropes) {
  for (const auto& eos : {copper(), with_all_slopes(), polynomial(), table()}) {
    const double mu = 0.2, h = 1e-4;
    const auto at = [&eos](double to) {
      const PressureParts<double> parts = pressure_parts(eos, to);
      return parts.cold + parts.thermal * energy_of_isentrope(eos, to);
    };
    const double slope = (at(mu + h) - at(mu - h)) / (2 * h);  // rho dp/drho = (1 + mu) dp/dmu
    EXPECT_NEAR(compressed(eos, mu, 2000).bulk_modulus, (1 + mu) * slope, 1e-5 * slope);
  }
}

TEST(EquationsOfState, TakeUpWorkAndLetTensionGo) {
  EquationOfState<double> eos = copper();
  const PressureState<double> heated = pressure_after(eos, PressureStep<double>{0, 0, 500, 0}, 100.0);
  EXPECT_DOUBLE_EQ(heated.energy, 600);
  EXPECT_DOUBLE_EQ(heated.value, 2.02 * 600);
  eos.tension_limit = 300;
  const PressureState<double> torn = pressure_after(eos, PressureStep<double>{-0.1, 0.1, 0, -200.0}, 0.0);
  EXPECT_EQ(torn.value, -300);
  EXPECT_DOUBLE_EQ(torn.energy, 0.5 * (200 + 300) * 0.1);
}

}  // namespace
}  // namespace pinball::equation_of_state_test
