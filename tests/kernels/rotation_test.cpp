#include <kernels/rotation.hpp>
#include <tests/support/support.hpp>

namespace pinball::rotation_test {
namespace {

using namespace test;

double determinant(const Tensor<double>& a) { return dot(a.row_x, cross(a.row_y, a.row_z)); }

void expect_orthogonal(const Tensor<double>& q, double tolerance) {
  EXPECT_NEAR(dot(q.row_x, q.row_x), 1, tolerance);
  EXPECT_NEAR(dot(q.row_y, q.row_y), 1, tolerance);
  EXPECT_NEAR(dot(q.row_z, q.row_z), 1, tolerance);
  EXPECT_NEAR(dot(q.row_x, q.row_y), 0, tolerance);
  EXPECT_NEAR(dot(q.row_y, q.row_z), 0, tolerance);
  EXPECT_NEAR(dot(q.row_z, q.row_x), 0, tolerance);
  EXPECT_NEAR(determinant(q), 1, tolerance);
}
void expect_near(const Tensor<double>& a, const Tensor<double>& b, double tolerance) {
  EXPECT_VECTOR_NEAR(a.row_x, b.row_x, tolerance);
  EXPECT_VECTOR_NEAR(a.row_y, b.row_y, tolerance);
  EXPECT_VECTOR_NEAR(a.row_z, b.row_z, tolerance);
}

TEST(HughesWinget, IsOrthogonalForAnySpin) {
  Random random(21);
  for (const double size : {1e-12, 1e-6, 1e-3, 0.1, 1.0, 10.0, 1e3, 1e6}) {
    for (int trial = 0; trial < 50; ++trial) {
      expect_orthogonal(hughes_winget_rotation(random_vector(random, size)).q, 2e-15);
    }
  }
}

TEST(HughesWinget, WithoutSpinIsTheIdentityToTheBit) {
  const Rotation<double> r = hughes_winget_rotation(Vec3<double>{0, 0, 0});
  expect_near(r.q, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, 0);
  const Symmetric<double> s{1.1, 2.2, 3.3, 4.4, 5.5, 6.6};
  EXPECT_SYMMETRIC_NEAR(rotate(r, s), s, 0);
}

TEST(HughesWinget, TurnsByTwiceTheArcTangentOfHalfTheSpin) {
  Random random(22);
  for (int trial = 0; trial < 100; ++trial) {
    const Vec3<double> axis = random_direction(random);
    const double spin = uniform(random, 0, 20);
    expect_near(hughes_winget_rotation(spin * axis).q, rotation_matrix(axis, 2 * std::atan(0.5 * spin)), 2e-15);
  }
}

TEST(HughesWinget, OfTheMidStepGeometryIsTheExactRigidRotation) {
  Random random(23);
  for (int trial = 0; trial < 100; ++trial) {
    const Corners x0 = random_hexahedron(random);
    const Tensor<double> exact = rotation_matrix(random_direction(random), uniform(random, -3, 3));
    const Vec3<double> shift = random_vector(random, 10);
    Corners displacement, middle;
    for (std::size_t i = 0; i < 8; ++i) {
      const Vec3<double> x1 = shift + exact * x0[i];
      displacement[i] = x1 - x0[i];
      middle[i] = 0.5 * (x0[i] + x1);
    }
    const HexahedronModes<double> m = modes<double>(middle);
    const UniformGradient<double> b = uniform_gradient(m);
    const Tensor<double> gradient = velocity_gradient(b, modes<double>(displacement), 1 / hexahedron_volume(b, m));
    const double tolerance = 1e-13 / (1 + exact.row_x.x + exact.row_y.y + exact.row_z.z);  // singular at half a turn
    EXPECT_SYMMETRIC_NEAR(symmetric_part(gradient), (Symmetric<double>{0, 0, 0, 0, 0, 0}), tolerance * 10);
    expect_near(hughes_winget_rotation(axial_vector(gradient)).q, exact, tolerance * 10);
  }
}

TEST(Rotate, StressIsRSigmaRTransposed) {
  Random random(24);
  for (int trial = 0; trial < 100; ++trial) {
    const Rotation<double> r = hughes_winget_rotation(random_vector(random, 3));
    const Symmetric<double> s = random_symmetric(random), turned = rotate(r, s);
    EXPECT_SYMMETRIC_NEAR(turned, rotated(r.q, s), 2e-15);
    // Principal values are kept: the three invariants are.
    EXPECT_NEAR(trace(turned), trace(s), 4e-15);
    EXPECT_NEAR(contract(turned, turned), contract(s, s), 1e-14);
    const auto det = [](const Symmetric<double>& a) {
      return determinant({{a.xx, a.xy, a.zx}, {a.xy, a.yy, a.yz}, {a.zx, a.yz, a.zz}});
    };
    EXPECT_NEAR(det(turned), det(s), 1e-14);
  }
}

TEST(Tensor, Parts) {  // L v = D v + w x v
  Random random(25);
  for (int trial = 0; trial < 20; ++trial) {
    const Tensor<double> a = random_tensor(random);
    const Vec3<double> v = random_vector(random);
    EXPECT_VECTOR_NEAR(a * v, symmetric_part(a) * v + cross(axial_vector(a), v), 2e-15);
    EXPECT_VECTOR_NEAR(hughes_winget_rotation(axial_vector(a)).q * v,
                       rotate(hughes_winget_rotation(axial_vector(a)), v), 0);
  }
}

template <class T>
class RotationPack : public ::testing::Test {};
TYPED_TEST_SUITE(RotationPack, NumberTypes);

TYPED_TEST(RotationPack, EqualsTheScalarKernelLaneByLane) {
  using T = TypeParam;
  using S = ScalarOf<T>;
  Random random(26);
  std::vector<Vec3<double>> spin;
  std::vector<Symmetric<double>> stress;
  for (int i = 0; i < width_of<T>; ++i) {
    spin.push_back(random_vector(random, 2));
    stress.push_back(random_symmetric(random));
  }
  const Rotation<T> r = hughes_winget_rotation(vector_from_lanes<T>([&](int i) { return spin[std::size_t(i)]; }));
  const Symmetric<T> s = symmetric_from_lanes<T>([&](int i) { return stress[std::size_t(i)]; });
  for (int i = 0; i < width_of<T>; ++i) {
    const Vec3<double> w = spin[std::size_t(i)];
    const Rotation<S> r1 = hughes_winget_rotation(Vec3<S>{S(w.x), S(w.y), S(w.z)});
    const Tensor<S> q = lane_of(r.q, i);
    EXPECT_VECTOR_NEAR(q.row_x, r1.q.row_x, 4 * epsilon<S>);
    EXPECT_VECTOR_NEAR(q.row_y, r1.q.row_y, 4 * epsilon<S>);
    EXPECT_VECTOR_NEAR(q.row_z, r1.q.row_z, 4 * epsilon<S>);
    EXPECT_SYMMETRIC_NEAR(lane_of(rotate(r, s), i), rotate(r1, lane_of(s, i)), 16 * epsilon<S>);
  }
}

}  // namespace
}  // namespace pinball::rotation_test
