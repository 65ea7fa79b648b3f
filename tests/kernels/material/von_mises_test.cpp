#include <kernels/material/von_mises.hpp>
#include <tests/support/support.hpp>

namespace pinball::von_mises_test {
namespace {

using namespace test;

constexpr double infinity = std::numeric_limits<double>::infinity();

MaterialConstants<double> material(double yield = 2.0, double hardening = 10.0, double ultimate = infinity) {
  MaterialConstants<double> m{};
  m.lambda = 150, m.mu = 80, m.yield_stress = yield, m.plastic_modulus = hardening, m.ultimate_stress = ultimate;
  m.density = 1, m.sound_speed = std::sqrt(310.0);
  return m;
}
template <class S>
MaterialConstants<S> cast(const MaterialConstants<double>& m) {
  return {S(m.lambda),          S(m.mu),      S(m.yield_stress), S(m.plastic_modulus),
          S(m.ultimate_stress), S(m.density), S(m.sound_speed)};
}

struct State {
  Symmetric<double> stress{0, 0, 0, 0, 0, 0};
  double plastic_strain = 0;
  void strain_by(const MaterialConstants<double>& m, const Symmetric<double>& strain) {
    stress = stress + elastic_increment(m.lambda, m.mu, strain);
    radial_return(m, stress, plastic_strain);
  }
};

double effective(const Symmetric<double>& s) {
  const double p = trace(s) / 3;
  const Symmetric<double> d{s.xx - p, s.yy - p, s.zz - p, s.xy, s.yz, s.zx};
  return std::sqrt(1.5 * contract(d, d));
}

/// At plastic strain e.
double yield_stress_at(const MaterialConstants<double>& m, double e) {
  return std::min(m.yield_stress + m.plastic_modulus * e, m.ultimate_stress);
}

/// Independent scalar implementation: bisection of the consistency condition 3 mu dl = q - Y(e + dl), q >= Y.
State bisected(const MaterialConstants<double>& m, State trial) {
  const double q = effective(trial.stress), e = trial.plastic_strain;
  if (q <= yield_stress_at(m, e)) return trial;
  double low = 0, high = q / (3 * m.mu);
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (3 * m.mu * middle < q - yield_stress_at(m, e + middle) ? low : high) = middle;
  }
  const double p = trace(trial.stress) / 3, scale = 1 - 3 * m.mu * low / q;
  Symmetric<double> s = trial.stress;
  s = {p + scale * (s.xx - p), p + scale * (s.yy - p), p + scale * (s.zz - p),
       scale * s.xy,           scale * s.yz,           scale * s.zx};
  return {s, e + low};
}

TEST(ElasticIncrement, IsHookesLaw) {
  Random random(31);
  const Symmetric<double> strain = random_symmetric(random), s = elastic_increment(3.0, 2.0, strain);
  const double volumetric = 3 * (strain.xx + strain.yy + strain.zz);
  EXPECT_SYMMETRIC_NEAR(s,
                        (Symmetric<double>{volumetric + 4 * strain.xx, volumetric + 4 * strain.yy,
                                           volumetric + 4 * strain.zz, 4 * strain.xy, 4 * strain.yz, 4 * strain.zx}),
                        1e-15);
}

TEST(RadialReturn, FollowsUniaxialStrain) {  // q = 2 mu e, stress K e + 2/3 q
  const MaterialConstants<double> m = material();
  const double bulk = m.lambda + 2 * m.mu / 3;
  State state;
  for (int i = 1; i <= 100; ++i) {
    state.strain_by(m, {1e-3, 0, 0, 0, 0, 0});
    const double e = 1e-3 * i, yield = 2 * m.mu * e;
    const double dl = std::max(0.0, (yield - m.yield_stress) / (3 * m.mu + m.plastic_modulus));
    const double q = yield - 3 * m.mu * dl;
    EXPECT_NEAR(state.plastic_strain, dl, 1e-15);
    EXPECT_SYMMETRIC_NEAR(
        state.stress, (Symmetric<double>{bulk * e + 2 * q / 3, bulk * e - q / 3, bulk * e - q / 3, 0, 0, 0}), 2e-13);
  }
}

TEST(RadialReturn, FollowsPureShear) {
  const MaterialConstants<double> m = material();
  State state;
  for (int i = 1; i <= 100; ++i) {
    state.strain_by(m, {0, 0, 0, 0, 5e-4, 0});
    const double q = std::sqrt(3.0) * 2 * m.mu * 5e-4 * i;
    const double dl = std::max(0.0, (q - m.yield_stress) / (3 * m.mu + m.plastic_modulus));
    EXPECT_NEAR(state.plastic_strain, dl, 1e-15);
    EXPECT_SYMMETRIC_NEAR(state.stress, (Symmetric<double>{0, 0, 0, 0, (q - 3 * m.mu * dl) / std::sqrt(3.0), 0}),
                          2e-14);
  }
}

TEST(RadialReturn, OneStepEqualsManyAlongARadialPathAcrossTheUltimateStress) {
  Random random(32);
  const MaterialConstants<double> m = material(2, 10, 2.3);
  for (int trial = 0; trial < 50; ++trial) {
    const Symmetric<double> direction = random_symmetric(random, 0.1);
    State once, often;
    once.strain_by(m, direction);
    constexpr int steps = 64;
    for (int i = 0; i < steps; ++i) often.strain_by(m, (1.0 / steps) * direction);
    EXPECT_GT(once.plastic_strain, 0.03);  // ends on the ultimate stress
    EXPECT_NEAR(effective(once.stress), 2.3, 1e-13);
    EXPECT_NEAR(often.plastic_strain, once.plastic_strain, 1e-14);
    EXPECT_SYMMETRIC_NEAR(often.stress, once.stress, 1e-12);
  }
}

TEST(RadialReturn, SwitchesExactlyAtTheUltimateStress) {
  const MaterialConstants<double> m = material(2, 10, 2.5);  // reached at plastic strain 0.05
  const double q_switch = 2.5 + 3 * m.mu * 0.05;
  for (const double offset : {-1.0, -1e-6, 0.0, 1e-6, 1.0}) {
    const double q = q_switch + offset;
    State state;
    state.stress.xy = q / std::sqrt(3.0);
    radial_return(m, state.stress, state.plastic_strain);
    const double expected = offset < 0 ? (q - 2) / (3 * m.mu + 10) : (q - 2.5) / (3 * m.mu);
    EXPECT_NEAR(state.plastic_strain, expected, 1e-16);
    EXPECT_NEAR(effective(state.stress), std::min(2 + 10 * expected, 2.5), 2e-15);
  }
}

TEST(RadialReturn, EqualsBisectionForRandomSteps) {
  Random random(33);
  const MaterialConstants<double> kinds[] = {material(),         material(2, 10, 2.2), material(2, 0, 2),
                                             material(2, 0),     material(0, 10, 1),   material(0, 0, 0),
                                             material(2, 500, 3)};
  for (const MaterialConstants<double>& m : kinds) {
    for (int trial = 0; trial < 300; ++trial) {
      State state;
      state.stress = random_symmetric(random, 3);
      state.plastic_strain = trial % 3 == 0 ? 0 : uniform(random, 0, 0.1);
      const State expected = bisected(m, state);
      const double before = trace(state.stress);
      radial_return(m, state.stress, state.plastic_strain);
      EXPECT_NEAR(state.plastic_strain, expected.plastic_strain, 1e-15);
      EXPECT_SYMMETRIC_NEAR(state.stress, expected.stress, 5e-14);
      EXPECT_NEAR(trace(state.stress), before, 5e-15);  // the pressure stays
      EXPECT_LE(effective(state.stress), yield_stress_at(m, state.plastic_strain) + 1e-13);
    }
  }
}

TEST(RadialReturn, LeavesStressBelowYieldUntouchedToTheBit) {
  Random random(34);
  const MaterialConstants<double> m = material(1e4, 10);
  for (int trial = 0; trial < 1000; ++trial) {
    Symmetric<double> stress = random_symmetric(random, 2);
    const double pressure = trial % 2 == 0 ? 0 : 1e3;
    stress.xx += pressure, stress.yy += pressure, stress.zz += pressure;
    stress.yy *= 1e-5;  // much smaller than the mean stress
    const Symmetric<double> before = stress;
    double plastic_strain = 0.1234567;
    radial_return(m, stress, plastic_strain);
    ASSERT_SYMMETRIC_EQ(stress, before);
    ASSERT_EQ(plastic_strain, 0.1234567);
  }
}

TEST(RadialReturn, OfNoStressIsNoStress) {
  for (const double yield : {0.0, 2.0}) {
    State state;
    radial_return(material(yield, 0, yield), state.stress, state.plastic_strain);
    EXPECT_SYMMETRIC_NEAR(state.stress, (Symmetric<double>{0, 0, 0, 0, 0, 0}), 0);
    EXPECT_EQ(state.plastic_strain, 0);
  }
}

TEST(RadialReturn, WithoutStrengthLeavesThePressureAlone) {
  State state;
  state.stress = {-5, -3, -1, 2, 1, -4};
  radial_return(material(0, 0, 0), state.stress, state.plastic_strain);
  EXPECT_SYMMETRIC_NEAR(state.stress, (Symmetric<double>{-3, -3, -3, 0, 0, 0}), 4e-15);
}

TEST(RadialReturn, DissipatesTheWorkOfTheYieldStress) {  // stress : plastic strain increment = q dl
  Random random(35);
  const MaterialConstants<double> m = material(2, 10, 2.2);
  for (int trial = 0; trial < 50; ++trial) {
    State state;
    state.stress = random_symmetric(random, 5);
    const Symmetric<double> before = state.stress;
    radial_return(m, state.stress, state.plastic_strain);
    // Plastic strain increment (trial - final) / (2 mu), deviatoric.
    const Symmetric<double> plastic = (0.5 / m.mu) * (before + (-1.0) * state.stress);
    EXPECT_NEAR(contract(state.stress, plastic), effective(state.stress) * state.plastic_strain, 1e-14);
  }
}

template <class T>
class MaterialPack : public ::testing::Test {};
TYPED_TEST_SUITE(MaterialPack, NumberTypes);

TYPED_TEST(MaterialPack, EqualsTheScalarKernelLaneByLane) {
  using T = TypeParam;
  using S = ScalarOf<T>;
  Random random(36);
  for (const MaterialConstants<double>& m64 : {material(2, 10, 2.2), material(2, 10), material(0, 0, 0)}) {
    const MaterialConstants<S> m = cast<S>(m64);
    std::vector<Symmetric<double>> stress;  // lanes that yield beside lanes that do not
    for (int i = 0; i < width_of<T>; ++i) stress.push_back(random_symmetric(random, i % 2 == 0 ? 3 : 0.3));
    const Symmetric<T> start = symmetric_from_lanes<T>([&](int i) { return stress[std::size_t(i)]; });
    Symmetric<T> s = start;
    T e = from_lanes<T>([](int i) { return 0.01 * i; });
    radial_return(m, s, e);
    for (int i = 0; i < width_of<T>; ++i) {
      Symmetric<S> s1 = lane_of(start, i);
      S e1 = S(0.01 * i);
      radial_return(m, s1, e1);
      EXPECT_SYMMETRIC_NEAR(lane_of(s, i), s1, 16 * epsilon<S>);
      EXPECT_NEAR(lane(e, i), e1, epsilon<S>);
    }
  }
}

}  // namespace
}  // namespace pinball::von_mises_test
