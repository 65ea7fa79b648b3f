#include <kernels/material/bulk_viscosity.hpp>
#include <tests/support/support.hpp>

namespace pinball::bulk_viscosity_test {
namespace {

using namespace test;

constexpr double b1 = 0.06, b2 = 1.2, rho = 8900, c = 4700, length = 0.01;

TEST(BulkViscosity, IsLinearInExpansion) {
  for (const double rate : {0.0, 1.0, 1e5}) {
    EXPECT_DOUBLE_EQ(bulk_viscosity(b1, b2, rho, c, length, rate), b1 * rho * c * length);
  }
}

TEST(BulkViscosity, AddsAQuadraticPartInCompression) {
  for (const double rate : {-1.0, -1e3, -1e5}) {
    // stress q = b1 rho c L rate - rho (b2 L rate)^2
    const double stress = b1 * rho * c * length * rate - rho * (b2 * length * rate) * (b2 * length * rate);
    EXPECT_NEAR(bulk_viscosity(b1, b2, rho, c, length, rate) * rate, stress, 1e-14 * std::abs(stress));
  }
}

TEST(BulkViscosity, VanishesWithItsCoefficients) {
  EXPECT_EQ(bulk_viscosity(0.0, 0.0, rho, c, length, -1e5), 0);
  EXPECT_EQ(bulk_viscosity(0.0, b2, rho, c, length, 1e5), 0);
}

template <class T>
class BulkViscosityPack : public ::testing::Test {};
TYPED_TEST_SUITE(BulkViscosityPack, NumberTypes);

TYPED_TEST(BulkViscosityPack, EqualsTheScalarKernelLaneByLane) {
  using T = TypeParam;
  using S = ScalarOf<T>;
  const T rate = from_lanes<T>([](int i) { return i % 2 == 0 ? -1.5 * i - 1 : 2.5 * i; });
  const T density = from_lanes<T>([](int i) { return 1 + 0.1 * i; });
  const T size = from_lanes<T>([](int i) { return 2 - 0.1 * i; });
  const T found = bulk_viscosity(T(S(b1)), T(S(b2)), density, T(S(3)), size, rate);
  for (int i = 0; i < width_of<T>; ++i) {
    const S expected = bulk_viscosity(S(b1), S(b2), lane(density, i), S(3), lane(size, i), lane(rate, i));
    EXPECT_NEAR(lane(found, i), expected, 4 * epsilon<S> * expected);
  }
}

}  // namespace
}  // namespace pinball::bulk_viscosity_test
