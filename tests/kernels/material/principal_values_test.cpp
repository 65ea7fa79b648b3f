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

}  // namespace
}  // namespace pinball::principal_values_test
