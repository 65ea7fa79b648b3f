#include <kernels/material/bending_yield.hpp>
#include <tests/support/support.hpp>

namespace pinball::bending_yield_test {
namespace {

using namespace test;

constexpr double mu = 80, infinity = std::numeric_limits<double>::infinity();

/// Stresses of any size of a material without strength: what is left of them is a number, and no more than they were.
template <class S>
void expect_numbers_without_strength() {
  for (const S modulus : {S(1e-2), S(80), S(1e11)}) {
    const MaterialConstants<S> weak{2 * modulus, modulus, 0, 0, std::numeric_limits<S>::infinity(), 3 * modulus, 1};
    for (S q = modulus; q > 0; q /= 10) {
      S strain = 0;
      const YieldFactors<S> left = return_in_bending(weak, q * q, S(0.3) * q * q, S(0.5) * q * q, strain);
      EXPECT_TRUE(std::isfinite(strain));
      EXPECT_LE(std::abs(left.mean) + std::abs(left.difference), S(1.001)) << q << " of " << modulus;
    }
  }
}

MaterialConstants<double> material(double yield, double modulus) { return {150, mu, yield, modulus, infinity, 3, 1}; }

TEST(YieldInBending, WithoutVariationIsTheRadialReturn) {
  Random random(61);
  for (int trial = 0; trial < 100; ++trial) {
    const MaterialConstants<double> m = material(1, 10);
    Symmetric<double> stress = random_symmetric(random, 3);
    const Symmetric<double> deviator = deviator_of(stress);
    double strain = 0.02, expected_strain = 0.02;
    const YieldFactors<double> left = return_in_bending(m, effective_square(deviator), 0.0, 0.0, strain);
    Symmetric<double> expected = stress;
    radial_return(m, expected, expected_strain);
    EXPECT_SYMMETRIC_NEAR(stress + (left.mean - 1) * deviator, expected, 1e-14);
    EXPECT_NEAR(left.difference, 0, 1e-15);
    EXPECT_NEAR(strain, expected_strain, 1e-15);
  }
}

/// Uniaxial stress s of the centre and S of bending: what the two points hold, returned one by one.
TEST(YieldInBending, ReturnsEachOfTwoPoints) {
  Random random(62);
  const double k = 2 / std::sqrt(3.0), yield = 1;
  for (int trial = 0; trial < 1000; ++trial) {
    const double s = uniform(random, -3, 3), field = uniform(random, -3, 3);
    double strain = 0;
    const double r = std::abs(s * field), sign = s * field < 0 ? -1 : 1;
    const YieldFactors<double> left = return_in_bending(material(yield, 0), s * s, field * field, r, strain);
    const auto returned = [&](double stress) { return std::clamp(stress, -yield, yield); };
    const double plus = returned(s + k * field), minus = returned(s - k * field);
    EXPECT_NEAR(left.mean * s + k * left.difference * sign * field, 0.5 * (plus + minus), 1e-13);
    EXPECT_NEAR(left.mean * field + left.difference / k * sign * s, 0.5 * (plus - minus) / k, 1e-13);
    const double excess = std::abs(s + k * field - plus) + std::abs(s - k * field - minus);
    EXPECT_NEAR(strain, 0.5 * excess / (3 * mu), 1e-14);
  }
}

TEST(YieldInBending, LeavesElasticStressToTheBit) {
  Random random(63);
  for (int trial = 0; trial < 1000; ++trial) {
    const double mean = uniform(random, 0, 1), variation = uniform(random, 0, 1), r = std::sqrt(mean * variation);
    if (std::sqrt(mean) + 2 / std::sqrt(3.0) * std::sqrt(variation) > 1) continue;
    double strain = 0.5;
    const YieldFactors<double> left = return_in_bending(material(1, 0), mean, variation, r, strain);
    EXPECT_EQ(left.mean, 1);
    EXPECT_EQ(left.difference, 0);
    EXPECT_EQ(strain, 0.5);
  }
}

TEST(YieldInBending, IsAskedForWhereverAPointYields) {
  Random random(64);
  for (int trial = 0; trial < 1000; ++trial) {
    const double mean = uniform(random, 0, 1), variation = uniform(random, 0, 1);
    double strain = 0;
    return_in_bending(material(1, 0), mean, variation, uniform(random, 0, 2), strain);
    if (strain > 0) {
      EXPECT_GT(largest_effective_square(mean, variation), 1);
    }
  }
}

TEST(YieldInBending, LeavesNumbersWhereThereIsNoStrength) {
  expect_numbers_without_strength<double>();
  expect_numbers_without_strength<float>();
}

}  // namespace
}  // namespace pinball::bending_yield_test
