#include <gtest/gtest.h>

#include <cmath>

#include <kernels/material/equation_of_state.hpp>

/// Pressure of what crushes: along its curve where it is compressed as never before, else along lines.
namespace pinball::crushing_test {
namespace {

/// Points at 0, 0.01, 0.2 and 0.3 of ln(rho/rho_0), with pressures of 0, 3, 5 and 30 and K of 400, 420, 600 and 700.
EquationOfState<double> foam() {
  EquationOfState<double> eos;
  eos.law = PressureLaw::tabulated;
  eos.pieces = 3;
  const double strain[3] = {0, 0.01, 0.2}, cold[3] = {0, 3, 5}, rise[3] = {300, 2 / 0.19, 250};
  const double unloading[3] = {400, 420, 600}, unloading_rise[3] = {2000, 180 / 0.19, 1000};
  std::copy(strain, strain + 3, eos.strain);
  std::copy(cold, cold + 3, eos.cold);
  std::copy(rise, rise + 3, eos.cold_rise);
  std::copy(unloading, unloading + 3, eos.unloading);
  std::copy(unloading_rise, unloading_rise + 3, eos.unloading_rise);
  eos.crushes = true;
  eos.last = 0.3;
  eos.tension_limit = 2;
  return eos;
}

/// p = 30 mu + 200 mu^2 + 100 mu^3 with K = 500.
EquationOfState<double> polynomial() {
  EquationOfState<double> eos;
  eos.law = PressureLaw::polynomial;
  eos.logarithmic = false;
  eos.polynomial[1] = 30, eos.polynomial[2] = 200, eos.polynomial[3] = 100;
  eos.crushes = true;
  eos.unloading[0] = 500;
  eos.tension_limit = INFINITY;
  return eos;
}

/// Pressure, rho c^2 and m of one body.
class Crushed {
 public:
  explicit Crushed(const EquationOfState<double>& eos) : eos_(eos) {}

  /// To x = ln(rho/rho_0), or mu.
  double to(double x) {
    const double mu = eos_.logarithmic ? std::expm1(x) : x, volume = 1 / (1 + mu);
    const PressureStep<double> step{mu, volume - volume_, 0, state_.value, most_, state_.torn};
    state_ = pressure_after(eos_, step, state_.energy);
    most_ = most_after(eos_, table_strain(eos_, mu).value, most_);
    volume_ = volume;
    return state_.value;
  }
  double most() const { return most_; }
  double stiffness() const { return state_.bulk_modulus; }
  double energy() const { return state_.energy; }

 private:
  EquationOfState<double> eos_;
  PressureState<double> state_{0, 0, 0, 0};
  double volume_ = 1, most_ = 0;
};

TEST(Crushing, LoadsUnloadsAndReloads) {
  Crushed body(foam());
  EXPECT_NEAR(body.to(0.005), 1.5, 1e-12);
  EXPECT_NEAR(body.to(0.1), 3 + 2 * 0.09 / 0.19, 1e-12);
  EXPECT_NEAR(body.most(), 0.1, 1e-15);
  const double modulus = 420 + 180 * 0.09 / 0.19, top = 3 + 2 * 0.09 / 0.19;
  EXPECT_NEAR(body.stiffness(), modulus, 1e-9) << "of the way back, on the way up, too";
  for (const double x : {0.099, 0.0985, 0.095, 0.0985}) {
    EXPECT_NEAR(body.to(x), std::max(-2.0, top - modulus * (0.1 - x)), 1e-11) << x;
    EXPECT_NEAR(body.most(), 0.1, 1e-15);
  }
  EXPECT_NEAR(body.to(0.05), -2, 1e-12) << "torn: no more than that";
  EXPECT_NEAR(body.to(-0.3), -2, 1e-12);
  EXPECT_NEAR(body.to(0.099), top - modulus * 0.001, 1e-11) << "where it closes again";
  EXPECT_NEAR(body.to(0.25), 5 + 12.5, 1e-12);
  EXPECT_NEAR(body.to(0.249), 17.5 - 650 * 0.001, 1e-11);
  EXPECT_NEAR(body.to(0.4), 55, 1e-11) << "the last piece goes on";
  EXPECT_NEAR(body.to(0.39), 55 - 700 * 0.01, 1e-11) << "with the last K";
}

TEST(Crushing, HasItsUnloadingModulusInTension) {
  EquationOfState<double> eos = foam();
  EXPECT_NEAR(Crushed(eos).to(-0.002), -0.8, 1e-12);
  eos.tension_limit = 0;
  Crushed dry(eos);
  EXPECT_EQ(dry.to(-0.002), 0);
  EXPECT_NEAR(dry.to(0.005), 1.5, 1e-12);
}

TEST(Crushing, BearsNoTensionOnceItIsTorn) {
  EquationOfState<double> eos = foam();
  eos.tears = true;
  Crushed body(eos);
  EXPECT_NEAR(body.to(-0.002), -0.8, 1e-12);
  EXPECT_NEAR(body.to(0.005), 1.5, 1e-12);
  EXPECT_EQ(body.to(-0.01), -2) << "in this step it has come to its limit";
  EXPECT_EQ(body.to(-0.002), 0);
  EXPECT_NEAR(body.to(0.1), 3 + 2 * 0.09 / 0.19, 1e-12) << "it is pressed as before";
  EXPECT_EQ(body.to(0.01), 0);
  EXPECT_EQ(pressure_of_energy(eos, -0.3, 0.0, 1.0, 0.0), 0);
  EXPECT_EQ(pressure_of_energy(eos, -0.3, 0.0, 0.0, 0.0), -2);
}

TEST(Crushing, MayBeElasticAtFirst) {
  EquationOfState<double> eos = polynomial();
  eos.elastic = 0.05, eos.full = 0.2;
  eos.unloading[0] = 100, eos.unloading_rise[0] = 2000;  // 500 at 0.2
  Crushed body(eos);
  const auto curve = [](double mu) { return mu * (30 + mu * (200 + mu * 100)); };
  EXPECT_NEAR(body.to(-0.01), -0.3 - 1e-4, 1e-13) << "tension goes along the curve, without its square";
  EXPECT_NEAR(body.to(0.05), curve(0.05), 1e-13);
  EXPECT_NEAR(body.to(0.02), curve(0.02), 1e-13);
  EXPECT_NEAR(body.to(0.1), curve(0.1), 1e-13);
  EXPECT_NEAR(body.to(0.09), curve(0.1) - 300 * 0.01, 1e-12);
  EXPECT_NEAR(body.to(0.3), curve(0.3), 1e-12);
  EXPECT_NEAR(body.to(0.25), curve(0.25), 1e-12);
  EXPECT_NEAR(body.to(0.19), curve(0.2) - 500 * 0.01, 1e-12);
}

TEST(Crushing, EndsWhereAllIsCompacted) {
  EquationOfState<double> eos = foam();
  eos.full = 0.2;
  Crushed body(eos);
  EXPECT_NEAR(body.to(0.3), 30, 1e-11);
  EXPECT_EQ(body.most(), 0.2);
  EXPECT_NEAR(body.to(0.25), 17.5, 1e-12) << "back as it came";
  EXPECT_NEAR(body.to(0.199), 5 - 0.6, 1e-11);
}

/// Where the way back would lie above the curve it is the curve: a body gives back no more than it ever took.
TEST(Crushing, GivesBackNoMoreThanItTook) {
  EquationOfState<double> eos = foam();
  std::fill(eos.unloading, eos.unloading + 3, 100.0);
  std::fill(eos.unloading_rise, eos.unloading_rise + 3, 0.0);
  Crushed body(eos);
  body.to(0.005);
  EXPECT_NEAR(body.to(0.002), 0.6, 1e-12);
  for (EquationOfState<double> one : {foam(), eos}) {
    one.tension_limit = 0;
    Crushed cycled(one);
    for (const double end : {0.03, 0.15, 0.32, 0.2}) {
      const double before = cycled.energy();
      for (int i = 1; i <= 4000; ++i) cycled.to(end * std::sin(M_PI * i / 4000));
      const double least = one.unloading[0] > 300 ? before - 1e-6 : -1e-5;  // a closed way takes energy
      EXPECT_GT(cycled.energy(), least) << end;
    }
  }
}

TEST(Crushing, MayLoadAlongAPolynomial) {
  Crushed body(polynomial());
  const auto curve = [](double mu) { return mu * (30 + mu * (200 + mu * 100)); };
  EXPECT_NEAR(body.to(0.1), curve(0.1), 1e-13);
  EXPECT_NEAR(body.to(0.098), curve(0.1) - 1, 1e-12);
  EXPECT_NEAR(body.to(0.098), curve(0.1) - 1, 1e-12);
  EXPECT_NEAR(body.to(0.2), curve(0.2), 1e-12);
  EXPECT_NEAR(body.stiffness(), 1.2 * 500, 1e-9);
  EXPECT_NEAR(body.to(-0.01), curve(0.2) - 105, 1e-11);
  EXPECT_NEAR(Crushed(polynomial()).to(-0.01), -5, 1e-12);
}

TEST(Crushing, MayHaveItsTableOverTheDensity) {
  EquationOfState<double> eos = foam();
  eos.logarithmic = false;
  Crushed body(eos);
  EXPECT_NEAR(body.to(0.1), 3 + 2 * 0.09 / 0.19, 1e-12);
  EXPECT_NEAR(body.stiffness(), 1.1 * (420 + 180 * 0.09 / 0.19), 1e-9);
  EXPECT_NEAR(body.most(), 0.1, 1e-15);
}

TEST(Crushing, KnowsThePressureBeforeTheWork) {
  const EquationOfState<double> eos = foam();
  EXPECT_NEAR(pressure_of_energy(eos, std::expm1(0.249), 0.25, 0.0, 7.0), 17.5 - 0.65, 1e-11);
  EXPECT_EQ(pressure_of_energy(eos, -0.3, 0.25, 0.0, 7.0), -2);
  EquationOfState<double> hot = eos;
  hot.thermal[0] = 2, hot.thermal_rise[0] = 0;
  EXPECT_NEAR(pressure_of_energy(hot, std::expm1(0.005), 0.0, 0.0, 7.0), 1.5 + 14, 1e-11);
}

}  // namespace
}  // namespace pinball::crushing_test
