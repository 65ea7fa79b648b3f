#include <kernels/material/general_yield.hpp>
#include <tests/kernels/material/hardening_case.hpp>

/// Back stress, curves and rates at one point of a material, against closed forms and independent integrations.
namespace pinball::general_yield_test {
namespace {

using namespace test;

/// Over shear strain increments, by one number each: the effective strain E = 2/sqrt3 e_xy, the signed effective stress
/// sqrt3 s_xy.
Symmetric<double> shear(double effective) { return {0, 0, 0, std::sqrt(0.75) * effective, 0, 0}; }
double signed_stress(const MaterialPoint& point) { return std::sqrt(3.0) * point.stress.xy; }
double signed_back(const MaterialPoint& point) { return std::sqrt(3.0) * point.back.xy; }

/// What a shear to E and every turn of it come to, in closed form.
struct ShearAnswer {
  double stress = 0, back = 0, plastic_strain = 0, strain = 0;

  void move_to(double target, double yield, double isotropic, double kinematic) {
    const double three_mu = 3 * case_mu, direction = target > strain ? 1 : -1;
    const double trial = stress + three_mu * (target - strain);
    const double over = direction * (trial - back) - (yield + isotropic * plastic_strain);
    const double dl = std::max(0.0, over / (three_mu + isotropic + kinematic));
    stress = trial - direction * three_mu * dl;
    back += direction * kinematic * dl;
    plastic_strain += dl;
    strain = target;
  }
};

TEST(MixedHardening, FollowsShearToAndFro) {
  for (const double share : {0.0, 0.5, 1.0}) {
    const HardeningCase hardening = linear_case(2, share * 10, (1 - share) * 10);
    for (const int steps : {1, 37}) {  // the way to each turn is straight: in how many steps does not matter
      MaterialPoint point;
      ShearAnswer exact;
      for (const double target : {0.05, -0.03, -0.031, 0.08, 0.07, -0.2}) {
        const double from = exact.strain;
        for (int i = 0; i < steps; ++i) point.strain_by(hardening, shear((target - from) / steps));
        exact.move_to(target, 2, share * 10, (1 - share) * 10);
        EXPECT_NEAR(signed_stress(point), exact.stress, 1e-12) << share << " " << target;
        EXPECT_NEAR(signed_back(point), exact.back, 1e-12);
        EXPECT_NEAR(point.plastic_strain, exact.plastic_strain, 1e-14);
      }
    }
  }
}

TEST(MixedHardening, YieldsEarlierOnTheWayBack) {         // Bauschinger
  const double stress = 2 + 10 * (240 * 0.05 - 2) / 250;  // at E = 0.05: 3 mu = 240, H = 10
  for (const double share : {0.0, 0.5, 1.0}) {
    const HardeningCase hardening = linear_case(2, share * 10, (1 - share) * 10);
    MaterialPoint point;
    point.strain_by(hardening, shear(0.05));
    ASSERT_NEAR(signed_stress(point), stress, 1e-13);
    const double radius = 2 + share * (stress - 2), elastic = 2 * radius / 240;
    const double before = point.plastic_strain;
    point.strain_by(hardening, shear(-0.999 * elastic));
    EXPECT_EQ(point.plastic_strain, before);
    point.strain_by(hardening, shear(-0.002 * elastic));
    EXPECT_GT(point.plastic_strain, before);
    EXPECT_NEAR(signed_stress(point), stress - 2 * radius, 1e-3);
  }
}

TEST(MixedHardening, IsotropicIsThatOfMaterialConstants) {
  Random random(41);
  const HardeningCase hardening = linear_case(2, 10, 0, 2.3);
  MaterialConstants<double> linear = hardening.material;
  linear.yield_stress = 2, linear.plastic_modulus = 10, linear.ultimate_stress = 2.3;
  MaterialPoint point;
  Symmetric<double> stress{0, 0, 0, 0, 0, 0};
  double plastic_strain = 0;
  for (int i = 0; i < 200; ++i) {
    const Symmetric<double> strain = random_symmetric(random, 0.01);
    point.strain_by(hardening, strain);
    stress = stress + elastic_increment(linear.lambda, linear.mu, strain);
    radial_return(linear, stress, plastic_strain);
    EXPECT_SYMMETRIC_NEAR(point.stress, stress, 1e-12);
    EXPECT_NEAR(point.plastic_strain, plastic_strain, 1e-13);
  }
  EXPECT_GT(plastic_strain, 0.1);
}

/// Rates of stress, back stress and plastic strain on a path that turns: ds = 2 mu (de - de_p), de_p along x = s - a.
TEST(MixedHardening, ConvergesToItsRateEquationsOnAPathThatTurns) {
  constexpr double isotropic = 4, kinematic = 6, yield = 2;
  const auto direction = [](double t) {
    return Symmetric<double>{0.06 * std::cos(6 * t), -0.06 * std::cos(6 * t), 0, 0.06 * std::sin(6 * t), 0.02, 0};
  };
  Symmetric<double> stress{0, 0, 0, 0, 0, 0}, back = stress;
  double e = 0;
  constexpr int fine = 400000;
  for (int i = 0; i < fine; ++i) {
    const Symmetric<double> strain = (1.0 / fine) * direction((i + 0.5) / fine);
    const Symmetric<double> x = stress - back;
    const double q = std::sqrt(1.5 * contract(x, x)), along = 3 * case_mu * contract(x, strain) / q;
    const bool yields = q > 0 && q >= yield + isotropic * e && along > 0;
    const double dl = yields ? along / (3 * case_mu + isotropic + kinematic) : 0;
    stress = stress + 2 * case_mu * strain;
    if (!yields) continue;
    stress = stress - (3 * case_mu * dl / q) * x;
    back = back + (kinematic * dl / q) * x;
    e += dl;
  }
  const HardeningCase hardening = linear_case(yield, isotropic, kinematic);
  double error[2];
  for (const int refined : {0, 1}) {
    const int steps = refined == 0 ? 500 : 1000;
    MaterialPoint point;
    for (int i = 0; i < steps; ++i) point.strain_by(hardening, (1.0 / steps) * direction((i + 0.5) / steps));
    error[refined] = norm(point.stress - stress) + norm(point.back - back);
    EXPECT_NEAR(point.plastic_strain, e, 2e-4);
  }
  EXPECT_GT(norm(back), 0.1);
  EXPECT_LT(error[1], 0.01);
  EXPECT_LT(error[1], 0.7 * error[0]);  // of first order in the step
}

TEST(MixedHardening, GivesBackLessThanItTakes) {  // closed cycles of strain, none of which may gain energy
  const HardeningCase hardening = linear_case(2, 2, 8);
  MaterialPoint point;
  double work = 0, least = 0;
  for (int cycle = 0; cycle < 3; ++cycle) {
    const double before = work;
    for (const double part : {0.05, -0.1, 0.05}) {
      for (int i = 0; i < 50; ++i) work += point.strain_by(hardening, shear(part / 50));
    }
    EXPECT_GT(work - before, 0);
    least = std::min(least, work);
  }
  EXPECT_EQ(least, 0);
  // Work = elastic energy + that of the back stress, a^2/(2 H_k), + what became heat, Y per plastic strain.
  const double e = point.plastic_strain, heat = 2 * e + 2 * e * e / 2;
  const double s = signed_stress(point), a = signed_back(point);
  EXPECT_NEAR(work, s * s / (2 * 240) + a * a / (2 * 8) + heat, 0.02 * work);
}

TEST(YieldCurve, IsMetExactlyAcrossAnyOfItsPoints) {
  Random random(42);
  const HardeningCase hardening = curve_case({0, 0.01, 0.02, 0.1}, {2, 3, 2.5, 4});
  const auto yield = [](double e) {  // the last slope goes on
    return e < 0.01 ? 2 + 100 * e : e < 0.02 ? 3 - 50 * (e - 0.01) : 2.5 + 18.75 * (e - 0.02);
  };
  for (int trial = 0; trial < 500; ++trial) {
    const double e = uniform(random, 0, 0.12), q = uniform(random, 0, 40);
    double low = 0, high = q / (3 * case_mu);  // bisection of 3 mu dl = q - Y(e + dl)
    for (int i = 0; i < 200; ++i) {
      const double middle = 0.5 * (low + high);
      (3 * case_mu * middle < q - yield(e + middle) ? low : high) = middle;
    }
    const GeneralYield<double> law(hardening.material, hardening.constants, {0, 0, 0, 0, 0, 0}, 1);
    EXPECT_NEAR(law.increment(q, e), low, 1e-15);
    EXPECT_NEAR(law.yield_stress(e), yield(e), 1e-14);
  }
}

TEST(YieldCurve, CrossesAPointWithinAStepAsInMany) {
  const HardeningCase hardening = curve_case({0, 0.01, 0.03}, {2, 3, 3.2});
  MaterialPoint once, often;
  once.strain_by(hardening, shear(0.06));
  for (int i = 0; i < 100; ++i) often.strain_by(hardening, shear(0.0006));
  EXPECT_NEAR(signed_stress(once), signed_stress(often), 1e-13);
  EXPECT_NEAR(once.plastic_strain, often.plastic_strain, 1e-15);
  const double e = (240 * 0.06 - 3.2 + 0.03 * 10) / (240 + 10);  // on the piece of slope 10 that goes on
  EXPECT_NEAR(once.plastic_strain, e, 1e-15);
  EXPECT_NEAR(signed_stress(once), 3.2 + 10 * (e - 0.03), 1e-13);
}

/// K = 3, e_0 = (2/3)^(1/n), so that it yields at 2.
HardeningCase power_case(double exponent) {
  HardeningCase c = plastic_case({0}, {2}, {0});
  c.constants.power_coefficient = 3, c.constants.power_exponent = exponent;
  c.constants.power_strain = std::pow(2.0 / 3, 1 / exponent);
  return c;
}

TEST(PowerHardening, IsMetWhereBisectionFindsIt) {
  Random random(43);
  for (const double n : {0.05, 0.2, 0.7, 1.0}) {
    const HardeningCase hardening = power_case(n);
    const auto yield = [&](double e) { return 3 * std::pow(hardening.constants.power_strain + e, n); };
    for (int trial = 0; trial < 200; ++trial) {
      const double e = trial % 2 == 0 ? 0.0 : uniform(random, 0, 2), q = uniform(random, 0, 40);
      double low = 0, high = q / (3 * case_mu);
      for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (low + high);
        (3 * case_mu * middle < q - yield(e + middle) ? low : high) = middle;
      }
      const GeneralYield<double> law(hardening.material, hardening.constants, {0, 0, 0, 0, 0, 0}, 1);
      EXPECT_NEAR(law.increment(q, e), low, 2e-15) << n << " " << e << " " << q;
      EXPECT_NEAR(law.yield_stress(e), yield(e), 1e-13);
    }
  }
}

/// In a shear to E the stress is that of q = Y(E - q/(3 mu)), however many steps it takes.
TEST(PowerHardening, FollowsItsCurveInAShear) {
  for (const int steps : {1, 100}) {
    const HardeningCase hardening = power_case(0.2);
    MaterialPoint point;
    for (int i = 0; i < steps; ++i) point.strain_by(hardening, shear(0.5 / steps));
    const double q = signed_stress(point), e = 0.5 - q / (3 * case_mu);
    EXPECT_NEAR(q, 3 * std::pow(hardening.constants.power_strain + e, 0.2), 1e-13);
    EXPECT_NEAR(point.plastic_strain, e, 1e-14);
  }
}

TEST(PowerHardening, IsScaledByTheRate) {
  for (const StrainRateMeasure measure : {StrainRateMeasure::deviatoric, StrainRateMeasure::plastic}) {
    HardeningCase hardening = power_case(0.2);
    hardening.constants.measure = measure;
    hardening.constants.rate_constant = 40, hardening.constants.rate_exponent = 5;
    const double q = 20, e = 0.1, dt = 1e-3, rate = 7;
    GeneralYield<double> law(hardening.material, hardening.constants, shear(rate), dt);
    law.apply_rate();
    const double dl = law.increment(q, e);
    const double seen = measure == StrainRateMeasure::plastic ? dl / dt : rate;
    const double yield =
        3 * std::pow(hardening.constants.power_strain + e + dl, 0.2) * (1 + std::pow(seen / 40, 1.0 / 5));
    EXPECT_GT(dl, 0);
    EXPECT_NEAR(yield + 3 * case_mu * dl, q, 1e-12);
  }
}

}  // namespace
}  // namespace pinball::general_yield_test
