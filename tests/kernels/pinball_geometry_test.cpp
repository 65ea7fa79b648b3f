#include <numbers>

#include <kernels/pinball_geometry.hpp>
#include <tests/support/support.hpp>

namespace pinball::pinball_geometry_test {
namespace {

using namespace test;

template <class T>
class PinballGeometry : public ::testing::Test {};
TYPED_TEST_SUITE(PinballGeometry, NumberTypes);

TYPED_TEST(PinballGeometry, RecordsFollowFromTheCorners) {
  using T = TypeParam;
  using S = ScalarOf<T>;
  constexpr std::size_t W = width_of<T>;
  constexpr std::size_t packs = 2, count = packs * W;
  Random random(111);
  std::vector<Corners> x, v;
  AlignedVector<S> position, velocity, exposed(6 * count), bulk(count);
  AlignedVector<std::int32_t> corner(8 * count);
  for (std::size_t e = 0; e < count; ++e) {
    Corners shape = random_hexahedron(random), speed;
    if (e == 1)
      std::swap(shape[0], shape[4]), std::swap(shape[1], shape[5]), std::swap(shape[2], shape[6]),
          std::swap(shape[3], shape[7]);  // inverted: its volume counts by its size
    for (Vec3<double>& s : speed) s = random_vector(random);
    for (std::size_t k = 0; k < 8; ++k) {
      corner[((e / W) * 8 + k) * W + e % W] = std::int32_t(8 * e + k);
      for (const double c : {shape[k].x, shape[k].y, shape[k].z, 1e30}) position.push_back(S(c));
      for (const double c : {speed[k].x, speed[k].y, speed[k].z, 1e30}) velocity.push_back(S(c));
    }
    for (std::size_t f = 0; f < 6; ++f) exposed[((e / W) * 6 + f) * W + e % W] = f == e % 6 ? S(1) : S(0);
    bulk[e] = S(2 + double(e));
    x.push_back(shape);
    v.push_back(speed);
  }
  for (const bool update_radius : {true, false}) {
    const S mark(77), factor(1.25);
    AlignedVector<S> centre(4 * count, mark), speed(4 * count, mark), outward(4 * count, mark),
        two_sided(4 * count, mark);
    outward[3] = S(0);  // pinball 0 takes no part
    const PinballGeometryView<S> view{corner.data(),  exposed.data(),   bulk.data(), centre.data(), speed.data(),
                                      outward.data(), two_sided.data(), 1,           factor};
    for (std::size_t p = 0; p < packs; ++p) {
      if (update_radius) {
        update_pinball_pack<T, true>(view, position.data(), velocity.data(), std::int64_t(p));
      } else {
        update_pinball_pack<T, false>(view, position.data(), velocity.data(), std::int64_t(p));
      }
    }
    const double tolerance = 16 * epsilon<S>;
    for (std::size_t e = 0; e < count; ++e) {
      Vec3<double> mean_x{0, 0, 0}, mean_v{0, 0, 0};
      for (std::size_t k = 0; k < 8; ++k) mean_x = mean_x + 0.125 * x[e][k], mean_v = mean_v + 0.125 * v[e][k];
      const auto record = [e](const AlignedVector<S>& r) { return Vec3<S>{r[4 * e], r[4 * e + 1], r[4 * e + 2]}; };
      EXPECT_VECTOR_NEAR(record(centre), mean_x, tolerance);
      EXPECT_VECTOR_NEAR(record(speed), mean_v, tolerance);
      static constexpr std::size_t face[6][4] = {{0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4},
                                                 {3, 7, 6, 2}, {0, 3, 2, 1}, {4, 5, 6, 7}};
      const std::size_t* f = face[e % 6];
      EXPECT_VECTOR_NEAR(record(outward), 0.5 * cross(x[e][f[2]] - x[e][f[0]], x[e][f[3]] - x[e][f[1]]), tolerance);
      EXPECT_VECTOR_NEAR(record(two_sided), (Vec3<double>{0, 0, 0}), 0);
      EXPECT_EQ(speed[4 * e + 3], mark);  // the mass is kept
      EXPECT_EQ(two_sided[4 * e + 3], mark);
      if (update_radius) {
        const double volume = std::abs(quadrature_gradient(x[e]).volume);
        const double radius = 1.25 * std::cbrt(3 * volume / (4 * std::numbers::pi));
        EXPECT_NEAR(centre[4 * e + 3], radius, tolerance);
        EXPECT_NEAR(outward[4 * e + 3], e == 0 ? 0 : (2 + double(e)) * radius, 40 * tolerance);
      } else {
        EXPECT_EQ(centre[4 * e + 3], mark);
        EXPECT_EQ(outward[4 * e + 3], e == 0 ? S(0) : mark);
      }
    }
  }
}

}  // namespace
}  // namespace pinball::pinball_geometry_test
