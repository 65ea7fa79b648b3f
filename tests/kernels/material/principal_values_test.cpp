#include <kernels/material/principal_values.hpp>
#include <tests/support/support.hpp>

namespace pinball::principal_values_test {
namespace {

using namespace test;

Symmetric<double> turned(const Vec3<double>& values, const Tensor<double>& rotation) {
  return rotated(rotation, {values.x, values.y, values.z, 0, 0, 0});
}

Tensor<double> random_rotation(Random& random) {
  return rotation_matrix(random_direction(random), uniform(random, 0, 3));
}

TEST(PrincipalValues, AreThoseOfATurnedDiagonal) {
  Random random(31);
  for (int i = 0; i < 200; ++i) {
    const Vec3<double> v = random_vector(random, 100);
    const PrincipalValues<double> found = principal_values(turned(v, random_rotation(random)));
    EXPECT_NEAR(found.largest, std::max({v.x, v.y, v.z}), 1e-11);
    EXPECT_NEAR(found.smallest, std::min({v.x, v.y, v.z}), 1e-11);
  }
}

TEST(PrincipalValues, OfWhichTwoAreEqualAreFoundToTheRootOfTheLastDigit) {
  Random random(32);
  for (const Vec3<double>& v : {Vec3<double>{3, -1, -1}, Vec3<double>{2, 2, -5}, Vec3<double>{7, 0, 0}}) {
    const PrincipalValues<double> found = principal_values(turned(v, random_rotation(random)));
    EXPECT_NEAR(found.largest, std::max(v.x, v.y), 2e-7);
    EXPECT_NEAR(found.smallest, v.z, 2e-7);
  }
}

TEST(PrincipalValues, OfAPressureAndOfNothingAreThemselves) {
  for (const double p : {0.0, -4.0, 1e30}) {
    const PrincipalValues<double> found = principal_values(Symmetric<double>{p, p, p, 0, 0, 0});
    EXPECT_DOUBLE_EQ(found.largest, p);
    EXPECT_DOUBLE_EQ(found.smallest, p);
  }
}

TEST(PrincipalValues, OfPacksAreThoseOfTheirLanes) {
  using T = Pack<double, 8>;
  Random random(33);
  Symmetric<double> one[8];
  for (Symmetric<double>& s : one) s = random_symmetric(random, 10);
  const auto lanes = [&](double Symmetric<double>::*c) { return T([&](auto i) { return one[i].*c; }); };
  using S = Symmetric<double>;
  const PrincipalValues<T> found = principal_values(
      Symmetric<T>{lanes(&S::xx), lanes(&S::yy), lanes(&S::zz), lanes(&S::xy), lanes(&S::yz), lanes(&S::zx)});
  for (int i = 0; i < 8; ++i) {
    const PrincipalValues<double> expected = principal_values(one[i]);
    EXPECT_NEAR(lane(found.largest, i), expected.largest, 1e-13);
    EXPECT_NEAR(lane(found.smallest, i), expected.smallest, 1e-13);
  }
}

/// Largest difference of two tensors.
double difference(const Symmetric<double>& a, const Symmetric<double>& b) {
  const Symmetric<double> d = a - b;
  return std::max({std::abs(d.xx), std::abs(d.yy), std::abs(d.zz), std::abs(d.xy), std::abs(d.yz), std::abs(d.zx)});
}

/// Also of two or three values that are equal, or nearly so.
TEST(PrincipalValues, MayBeLimitedWithoutTurning) {
  Random random(34);
  for (const double apart : {1.0, 1e-4, 1e-9, 0.0}) {
    for (int i = 0; i < 200; ++i) {
      Vec3<double> v = random_vector(random, 1);
      v.y = v.x + apart * uniform(random, -1, 1);
      if (i % 2 == 0) v.z = v.x + apart * uniform(random, -1, 1);
      const Tensor<double> rotation =
          i % 5 == 0 ? rotation_matrix(Vec3<double>{0, 0, 1}, 0.0) : random_rotation(random);
      const auto limited = [](double value) { return std::clamp(value, -0.3, 0.2); };
      Symmetric<double> s = turned(v, rotation);
      const Symmetric<double> before = s, taken = limit_principal_values(-0.3, 0.2, s);
      EXPECT_LT(difference(s, turned({limited(v.x), limited(v.y), limited(v.z)}, rotation)), 4e-15);
      EXPECT_LT(difference(s + taken, before), 1e-15);
    }
  }
}

TEST(PrincipalValues, WithinTheirLimitsAreLeftAlone) {
  Symmetric<double> s{0.1, -0.2, 0.05, 0.01, -0.03, 0.02};
  const Symmetric<double> before = s, taken = limit_principal_values(-0.5, 0.5, s);
  EXPECT_EQ(difference(s, before), 0);
  EXPECT_EQ(trace(taken), 0);
}

TEST(PrincipalValues, OfPacksAreLimitedAsThoseOfTheirLanes) {
  using T = Pack<double, 8>;
  using S = Symmetric<double>;
  Random random(35);
  S one[8];
  for (S& s : one) s = random_symmetric(random, 1);
  one[3] = {0.1, 0.1, 0.1, 0, 0, 0};
  one[5] = {-3, -3, -3, 0, 0, 0};
  const auto lanes = [&](double S::*c) { return T([&](auto i) { return one[i].*c; }); };
  Symmetric<T> s{lanes(&S::xx), lanes(&S::yy), lanes(&S::zz), lanes(&S::xy), lanes(&S::yz), lanes(&S::zx)};
  limit_principal_values(T(-0.3), T(0.2), s);
  for (int i = 0; i < 8; ++i) {
    S expected = one[i];
    limit_principal_values(-0.3, 0.2, expected);
    const S found{lane(s.xx, i), lane(s.yy, i), lane(s.zz, i), lane(s.xy, i), lane(s.yz, i), lane(s.zx, i)};
    EXPECT_LT(difference(found, expected), i == 3 ? 1e-300 : 4e-15) << i;
  }
}

}  // namespace
}  // namespace pinball::principal_values_test
