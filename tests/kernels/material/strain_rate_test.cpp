#include <tests/kernels/material/hardening_case.hpp>

/// Yield stresses that depend on the rate of strain.
namespace pinball::strain_rate_test {
namespace {

using namespace test;

constexpr Symmetric<double> nothing{0, 0, 0, 0, 0, 0};
Symmetric<double> shear(double effective) { return {0, 0, 0, std::sqrt(0.75) * effective, 0, 0}; }
double effective(const Symmetric<double>& s) { return std::sqrt(effective_square(deviator_of(s))); }

HardeningCase with_rate(HardeningCase c, StrainRateMeasure measure, double constant, double exponent) {
  c.constants.measure = measure;
  c.constants.rate_constant = constant;
  c.constants.rate_exponent = exponent;
  return c;
}

TEST(StrainRate, OfTheWholeStrainScalesTheYieldStress) {
  const HardeningCase total = with_rate(linear_case(2, 10, 0), StrainRateMeasure::total, 40, 5);
  const HardeningCase deviatoric = with_rate(linear_case(2, 10, 0), StrainRateMeasure::deviatoric, 40, 5);
  const Symmetric<double> strain{0.02, -0.005, 0.001, 0.004, -0.003, 0.002};
  constexpr double dt = 1e-3;
  const Symmetric<double> d = deviator_of(strain);
  const double rate = std::sqrt(contract(strain, strain)) / dt;
  const double rate_of_deviator = std::sqrt(2.0 / 3 * contract(d, d)) / dt;
  for (const auto& [c, r] : {std::pair(&total, rate), std::pair(&deviatoric, rate_of_deviator)}) {
    MaterialPoint point;
    for (int i = 0; i < 5; ++i) point.strain_by(*c, strain, dt);
    EXPECT_GT(point.plastic_strain, 0.05);
    EXPECT_NEAR(effective(point.stress), (2 + 10 * point.plastic_strain) * (1 + std::pow(r / 40, 0.2)), 1e-12);
  }
}

TEST(StrainRate, AddsWhereAStressIsGiven) {
  HardeningCase c = with_rate(linear_case(2, 10, 0), StrainRateMeasure::total, 40, 5);
  c.constants.rate_share = 0, c.constants.rate_stress = 1.5;
  MaterialPoint point;
  for (int i = 0; i < 5; ++i) point.strain_by(c, shear(0.02), 1e-3);
  const double rate = std::sqrt(2.0) * std::sqrt(0.75) * 0.02 / 1e-3;
  EXPECT_NEAR(effective(point.stress), 2 + 10 * point.plastic_strain + 1.5 * std::pow(rate / 40, 0.2), 1e-12);
}

TEST(StrainRate, OfPlasticStrainEndsInItsSteadyState) {  // all strain is plastic then: q = Y (1 + (E'/C)^(1/p))
  for (const double exponent : {1.0, 2.0, 5.0}) {
    const HardeningCase c = with_rate(linear_case(2, 0, 0), StrainRateMeasure::plastic, 40, exponent);
    MaterialPoint point;
    constexpr double rate = 100, dt = 1e-4;
    for (int i = 0; i < 3000; ++i) point.strain_by(c, shear(rate * dt), dt);
    EXPECT_NEAR(effective(point.stress), 2 * (1 + std::pow(rate / 40, 1 / exponent)), 1e-10) << exponent;
  }
}

TEST(StrainRate, OfPlasticStrainFollowsItsEquationInTime) {  // q' = 3 mu (E' - C (q/Y - 1)^p), by many explicit steps
  constexpr double rate = 100, end = 4e-4, constant = 4, exponent = 2;
  double q = 0, e = 0;
  constexpr int fine = 2000000;
  for (int i = 0; i < fine; ++i) {
    const double over = std::max(0.0, q / (2 + 10 * e) - 1), flow = constant * std::pow(over, exponent);
    q += 3 * case_mu * (rate - flow) * end / fine;
    e += flow * end / fine;
  }
  const HardeningCase c = with_rate(linear_case(2, 10, 0), StrainRateMeasure::plastic, constant, exponent);
  double error[2];
  for (const int refined : {0, 1}) {
    const int steps = refined == 0 ? 1000 : 2000;
    MaterialPoint point;
    for (int i = 0; i < steps; ++i) point.strain_by(c, shear(rate * end / steps), end / steps);
    error[refined] = std::abs(effective(point.stress) - q);
  }
  EXPECT_LT(error[1], 1e-3 * q);
  EXPECT_NEAR(error[1] / error[0], 0.5, 0.1);  // of first order
}

/// Curves of 1, 10 and 1000: {2, 3}, {3, 4}, {5, 5}, from plastic strain 0 to 0.1.
HardeningCase three_curves(StrainRateMeasure measure, bool logarithmic) {
  std::vector<double> rates{1, 10, 1000};
  if (logarithmic) std::transform(rates.begin(), rates.end(), rates.begin(), [](double r) { return std::log(r); });
  HardeningCase c = plastic_case({0, 0.1}, {2, 3, 3, 4, 5, 5}, {10, 0, 10, 0, 0, 0}, rates);
  c.constants.measure = measure;
  c.constants.logarithmic = logarithmic;
  return c;
}
double of_three_curves(double strain, double rate, bool logarithmic) {
  const auto at = [strain](double first, double last) { return first + (last - first) * std::min(1.0, strain / 0.1); };
  const auto place = [logarithmic](double r) { return logarithmic ? std::log(r) : r; };
  const double values[3] = {at(2, 3), at(3, 4), at(5, 5)}, rates[3] = {1, 10, 1000};
  if (rate <= 1) return values[0];
  if (rate >= 1000) return values[2];
  const int i = rate < 10 ? 0 : 1;
  const double w = (place(rate) - place(rates[i])) / (place(rates[i + 1]) - place(rates[i]));
  return values[i] + w * (values[i + 1] - values[i]);
}

/// Newton's method went from one bound to the other and back, across the rate of a curve behind which the next is
/// farther away, and left what it had.
TEST(StrainRate, OfPlasticStrainSolvesItsEquationAcrossTheRateOfACurve) {
  for (const bool logarithmic : {false, true}) {
    const auto place = [&](double r) { return logarithmic ? std::log(r) : r; };
    HardeningCase c =
        plastic_case({0, 0.1}, {3, 4, 3.1, 4.1, 6, 7}, {10, 0, 10, 0, 10, 0}, {place(0.5), place(1), place(2)});
    c.constants.measure = StrainRateMeasure::plastic;
    c.constants.logarithmic = logarithmic;
    const auto yield = [&](double strain, double rate) {
      const double at_curve[3] = {3, 3.1, 6}, first = std::clamp(rate, 0.5, 2.0);
      const int i = first < 1 ? 0 : 1;
      const double w = (place(first) - c.rate[i]) / (c.rate[i + 1] - c.rate[i]);
      return at_curve[i] + w * (at_curve[i + 1] - at_curve[i]) + 10 * std::min(strain, 0.1);
    };
    for (const double dt : {1e-4, 1e-3, 1e-2}) {
      const GeneralYield<double> law(c.material, c.constants, nothing, dt);
      for (double q = 3; q < 12; q += 0.01) {
        for (const double e : {0.0, 0.02, 0.2}) {
          const double dl = law.increment(q, e);
          if (!(dl > 0)) continue;
          EXPECT_NEAR(yield(e + dl, dl / dt) + 240 * dl, q, 1e-11 * q) << q << " " << e << " " << dt;
        }
      }
    }
  }
}

TEST(StrainRate, LiesBetweenCurves) {
  for (const bool logarithmic : {false, true}) {
    const HardeningCase c = three_curves(StrainRateMeasure::deviatoric, logarithmic);
    for (const double rate : {0.0, 0.5, 1.0, 4.0, 10.0, 100.0, 700.0, 1000.0, 5000.0}) {
      const GeneralYield<double> law(c.material, c.constants, shear(rate), 1);
      for (const double e : {0.0, 0.03, 0.1, 0.5}) {
        EXPECT_NEAR(law.yield_stress(e), of_three_curves(e, rate, logarithmic), 1e-12) << rate << " " << e;
      }
    }
  }
}

/// The equation for dl, of numbers of all sizes.
TEST(StrainRate, OfPlasticStrainSolvesItsEquation) {
  Random random(43);
  HardeningCase scaled = with_rate(curve_case({0, 0.01, 0.1}, {2, 3, 4}), StrainRateMeasure::plastic, 1, 1);
  const HardeningCase curves[2] = {three_curves(StrainRateMeasure::plastic, false),
                                   three_curves(StrainRateMeasure::plastic, true)};
  const GeneralYield<double> rest(scaled.material, scaled.constants, nothing, 1);
  for (int trial = 0; trial < 2000; ++trial) {
    const double q = std::pow(10, uniform(random, -1, 3)), e = uniform(random, 0, 0.2);
    const double dt = std::pow(10, uniform(random, -9, 1));
    const auto logarithmic = static_cast<std::size_t>(trial % 2);
    {
      const HardeningCase& c = curves[logarithmic];
      const double dl = GeneralYield<double>(c.material, c.constants, nothing, dt).increment(q, e);
      EXPECT_EQ(dl > 0, q > of_three_curves(e, 0, logarithmic == 1));
      if (dl > 0) {
        EXPECT_NEAR(of_three_curves(e + dl, dl / dt, logarithmic == 1) + 240 * dl, q, 1e-11 * q);
      }
    }
    scaled.constants.rate_constant = std::pow(10, uniform(random, -3, 6));
    scaled.constants.rate_exponent = uniform(random, 0.5, 10);
    scaled.constants.rate_share = logarithmic == 0 ? 0 : 1;
    scaled.constants.rate_stress = logarithmic == 0 ? 1.5 : 0;
    const double dl = GeneralYield<double>(scaled.material, scaled.constants, nothing, dt).increment(q, e);
    EXPECT_EQ(dl > 0, q > rest.yield_stress(e)) << q << " " << rest.yield_stress(e);
    if (!(dl > 0)) continue;
    const double r = std::pow(dl / (dt * scaled.constants.rate_constant), 1 / scaled.constants.rate_exponent);
    const double yield = rest.yield_stress(e + dl);
    EXPECT_NEAR(yield + r * (scaled.constants.rate_share * yield + scaled.constants.rate_stress) + 240 * dl, q,
                1e-10 * q);
  }
}

TEST(StrainRate, PacksGiveWhatTheirLanesGive) {
  using T = Pack<double, 8>;
  Random random(44);
  const HardeningCase cases[] = {with_rate(curve_case({0, 0.01, 0.1}, {2, 3, 4}), StrainRateMeasure::plastic, 40, 5),
                                 with_rate(curve_case({0, 0.01, 0.1}, {2, 3, 4}), StrainRateMeasure::total, 40, 5),
                                 three_curves(StrainRateMeasure::total, true),
                                 three_curves(StrainRateMeasure::plastic, false)};
  for (const HardeningCase& c : cases) {
    for (int trial = 0; trial < 50; ++trial) {
      alignas(64) double q[8], e[8], rate[8], found[8], yield[8];
      for (int i = 0; i < 8; ++i) {
        q[i] = uniform(random, 0, 20), e[i] = uniform(random, 0, 0.2), rate[i] = uniform(random, 0, 2000);
      }
      const T zero(0);
      GeneralYield<T> law(c.material, c.constants, {load<T>(rate), zero, zero, zero, zero, zero}, 1e-3);
      law.apply_rate();
      store(law.increment(load<T>(q), load<T>(e)), found);
      store(law.yield_stress(load<T>(e)), yield);
      for (int i = 0; i < 8; ++i) {
        GeneralYield<double> lane(c.material, c.constants, {rate[i], 0, 0, 0, 0, 0}, 1e-3);
        lane.apply_rate();
        EXPECT_NEAR(found[i], lane.increment(q[i], e[i]), 1e-15);
        EXPECT_NEAR(yield[i], lane.yield_stress(e[i]), 1e-14);
      }
    }
  }
}

}  // namespace
}  // namespace pinball::strain_rate_test
