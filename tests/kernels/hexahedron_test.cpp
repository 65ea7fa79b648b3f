#include <kernels/hexahedron.hpp>
#include <tests/support/support.hpp>

namespace pinball::hexahedron_test {
namespace {

using namespace test;

Corners expanded(const UniformGradient<double>& b) {
  Vec3<double> corner[8];
  expand(b, corner);
  Corners result;
  for (std::size_t i = 0; i < 8; ++i) result[i] = corner[i];
  return result;
}

/// Independent scalar implementation: the closed form of Flanagan and Belytschko (1981), one corner and component at a
/// time through its table of permutations.
Corners closed_form_gradient(const Corners& x) {
  static constexpr int table[8][6] = {{2, 3, 4, 5, 6, 8}, {3, 4, 1, 6, 7, 5}, {4, 1, 2, 7, 8, 6}, {1, 2, 3, 8, 5, 7},
                                      {8, 7, 6, 1, 4, 2}, {5, 8, 7, 2, 1, 3}, {6, 5, 8, 3, 2, 4}, {7, 6, 5, 4, 3, 1}};
  Corners b;
  for (std::size_t i = 0; i < 8; ++i) {
    double value[3];
    for (int c = 0; c < 3; ++c) {
      double y[6], z[6];  // of the corners called 2 3 4 5 6 8 in the formula
      for (int k = 0; k < 6; ++k) {
        const Vec3<double>& p = x[static_cast<std::size_t>(table[i][k] - 1)];
        const double xyz[3] = {p.x, p.y, p.z};
        y[k] = xyz[(c + 1) % 3];
        z[k] = xyz[(c + 2) % 3];
      }
      value[c] =
          (y[0] * ((z[4] - z[1]) - (z[2] - z[3])) + y[1] * (z[0] - z[2]) + y[2] * ((z[1] - z[5]) - (z[3] - z[0])) +
           y[3] * ((z[5] - z[4]) - (z[0] - z[2])) + y[4] * (z[3] - z[0]) + y[5] * (z[2] - z[3])) /
          12;
    }
    b[i] = {value[0], value[1], value[2]};
  }
  return b;
}

TEST(Modes, AreTheProductsOfParentCoordinates) {
  for (std::size_t corner = 0; corner < 8; ++corner) {
    Corners unit{};
    unit[corner] = {1, 2, 3};
    const HexahedronModes<double> m = modes<double>(unit);
    EXPECT_VECTOR_NEAR(8.0 * m.constant, (Vec3<double>{1, 2, 3}), 0);
    for (int k = 0; k < 3; ++k) {
      EXPECT_VECTOR_NEAR(8.0 * m.linear[k], parent[corner][k] * (Vec3<double>{1, 2, 3}), 0);
    }
    for (int a = 0; a < 4; ++a) {
      EXPECT_VECTOR_NEAR(8 * std::sqrt(3.0) * m.hourglass[a],
                         hourglass_value(a, static_cast<int>(corner)) * (Vec3<double>{1, 2, 3}), 1e-15);
    }
  }
}

TEST(Modes, AddUpToTheField) {  // a_I = A_0 + sum L_mI A_m + sqrt3 sum G_aI H_a; from_modes has 1/sqrt3 instead
  Random random(1);
  Corners x;
  for (Vec3<double>& v : x) v = random_vector(random);
  const HexahedronModes<double> m = modes<double>(x);
  Vec3<double> back[8];
  Vec3<double> hourglass[4];
  for (int a = 0; a < 4; ++a) hourglass[a] = 3.0 * m.hourglass[a];
  from_modes(m.linear, hourglass, back);
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_VECTOR_NEAR(back[i] + m.constant, x[i], 1e-15);
  }
}

TEST(Modes, ForcesDoTheWorkOfTheModes) {  // sum_I f_I.v_I = 8 sum_m F_m.V_m
  Random random(51);
  Corners v;
  for (Vec3<double>& value : v) value = random_vector(random);
  const HexahedronModes<double> m = modes<double>(v);
  Vec3<double> linear[3], hourglass[4], force[8];
  double modal = 0, nodal = 0;
  for (int k = 0; k < 3; ++k) linear[k] = random_vector(random), modal += 8 * dot(linear[k], m.linear[k]);
  for (int a = 0; a < 4; ++a) hourglass[a] = random_vector(random), modal += 8 * dot(hourglass[a], m.hourglass[a]);
  from_modes(linear, hourglass, force);
  for (std::size_t i = 0; i < 8; ++i) nodal += dot(force[i], v[i]);
  EXPECT_NEAR(nodal, modal, 1e-14);
}

TEST(UniformGradient, EqualsClosedFormAndQuadrature) {
  Random random(2);
  for (int trial = 0; trial < 200; ++trial) {
    const Corners x = random_hexahedron(random);
    const HexahedronModes<double> m = modes<double>(x);
    const UniformGradient<double> gradient = uniform_gradient(m);
    const Corners b = expanded(gradient), closed = closed_form_gradient(x);
    const QuadratureGradient exact = quadrature_gradient(x);
    Symmetric<double> square{0, 0, 0, 0, 0, 0};
    for (std::size_t i = 0; i < 8; ++i) {
      EXPECT_VECTOR_NEAR(b[i], closed[i], 1e-15);
      EXPECT_VECTOR_NEAR(b[i], exact.b[i], 1e-15);
      const Vec3<double>& e = exact.b[i];
      square = square + Symmetric<double>{e.x * e.x, e.y * e.y, e.z * e.z, e.x * e.y, e.y * e.z, e.z * e.x};
    }
    ASSERT_GT(exact.volume, 0.1);
    EXPECT_NEAR(hexahedron_volume(gradient, m), exact.volume, 5e-15);
    const Symmetric<double> found = gradient_square(gradient);
    const Symmetric<double> rest = found + (-1.0) * square;
    EXPECT_NEAR(contract(rest, rest), 0, 1e-28);
  }
}

TEST(UniformGradient, DifferentiatesCoordinatesExactly) {  // sum_I B_iI x_jI = V delta_ij, sum_I B_iI = 0
  Random random(3);
  for (int trial = 0; trial < 100; ++trial) {
    const Corners x = random_hexahedron(random);
    const HexahedronModes<double> m = modes<double>(x);
    const UniformGradient<double> gradient = uniform_gradient(m);
    const Corners b = expanded(gradient);
    const double volume = hexahedron_volume(gradient, m);
    Vec3<double> sum{0, 0, 0};
    Tensor<double> product{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    for (std::size_t i = 0; i < 8; ++i) {
      sum = sum + b[i];
      product.row_x = product.row_x + b[i].x * x[i];
      product.row_y = product.row_y + b[i].y * x[i];
      product.row_z = product.row_z + b[i].z * x[i];
    }
    EXPECT_VECTOR_NEAR(sum, (Vec3<double>{0, 0, 0}), 2e-15);
    EXPECT_VECTOR_NEAR(product.row_x, (Vec3<double>{volume, 0, 0}), 5e-15);
    EXPECT_VECTOR_NEAR(product.row_y, (Vec3<double>{0, volume, 0}), 5e-15);
    EXPECT_VECTOR_NEAR(product.row_z, (Vec3<double>{0, 0, volume}), 5e-15);
  }
}

TEST(VelocityGradient, OfALinearFieldIsExact) {
  Random random(4);
  for (int trial = 0; trial < 100; ++trial) {
    const Corners x = random_hexahedron(random);
    const Tensor<double> gradient = random_tensor(random);
    const HexahedronModes<double> m = modes<double>(x);
    const HexahedronModes<double> v = modes<double>(linear_field(random_vector(random), gradient, x));
    const UniformGradient<double> b = uniform_gradient(m);
    const Tensor<double> found = velocity_gradient(b, v, 1 / hexahedron_volume(b, m));
    EXPECT_VECTOR_NEAR(found.row_x, gradient.row_x, 1e-13);
    EXPECT_VECTOR_NEAR(found.row_y, gradient.row_y, 1e-13);
    EXPECT_VECTOR_NEAR(found.row_z, gradient.row_z, 1e-13);
  }
}

TEST(VelocityGradient, OfAnyFieldIsTheMeanOfTheExactGradient) {
  Random random(5);
  const Corners x = random_hexahedron(random);
  Corners v;
  for (Vec3<double>& value : v) value = random_vector(random);
  const QuadratureGradient exact = quadrature_gradient(x);
  Tensor<double> mean{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  for (std::size_t i = 0; i < 8; ++i) {
    mean.row_x = mean.row_x + (v[i].x / exact.volume) * exact.b[i];
    mean.row_y = mean.row_y + (v[i].y / exact.volume) * exact.b[i];
    mean.row_z = mean.row_z + (v[i].z / exact.volume) * exact.b[i];
  }
  const HexahedronModes<double> m = modes<double>(x);
  const UniformGradient<double> b = uniform_gradient(m);
  const Tensor<double> found = velocity_gradient(b, modes<double>(v), 1 / hexahedron_volume(b, m));
  EXPECT_VECTOR_NEAR(found.row_x, mean.row_x, 1e-14);
  EXPECT_VECTOR_NEAR(found.row_y, mean.row_y, 1e-14);
  EXPECT_VECTOR_NEAR(found.row_z, mean.row_z, 1e-14);
}

/// Nodal forces sigma B_I through the modes, as the element kernel forms them.
Corners stress_forces(const UniformGradient<double>& b, const Symmetric<double>& stress) {
  Vec3<double> linear[3], hourglass[4], force[8];
  for (int m = 0; m < 3; ++m) linear[m] = stress * b.linear[m], hourglass[m] = stress * b.hourglass[m];
  hourglass[3] = {0, 0, 0};
  from_modes(linear, hourglass, force);
  Corners result;
  for (std::size_t i = 0; i < 8; ++i) result[i] = force[i];
  return result;
}

TEST(StressForces, KeepLinearAndAngularMomentum) {
  Random random(6);
  for (int trial = 0; trial < 100; ++trial) {
    const Corners x = random_hexahedron(random);
    const Corners f = stress_forces(uniform_gradient(modes<double>(x)), random_symmetric(random));
    Vec3<double> force{0, 0, 0}, torque{0, 0, 0};
    for (std::size_t i = 0; i < 8; ++i) force = force + f[i], torque = torque + cross(x[i], f[i]);
    EXPECT_VECTOR_NEAR(force, (Vec3<double>{0, 0, 0}), 5e-15);
    EXPECT_VECTOR_NEAR(torque, (Vec3<double>{0, 0, 0}), 5e-15);
  }
}

/// The patch of MacNeal and Harder (1985): seven distorted hexahedra fill the unit cube, eight nodes lie inside.
struct Patch {
  std::array<Vec3<double>, 16> node;  // 0..7 corners of the cube, 8..15 inside
  std::array<std::array<std::size_t, 8>, 7> element;

  Patch() {
    const Corners cube = box(1, 1, 1);
    const Corners inner = {{{.249, .342, .192},
                            {.826, .288, .288},
                            {.850, .649, .263},
                            {.273, .750, .230},
                            {.320, .186, .643},
                            {.677, .305, .683},
                            {.788, .693, .644},
                            {.165, .745, .702}}};
    for (std::size_t i = 0; i < 8; ++i) node[i] = cube[i], node[8 + i] = inner[i], element[0][i] = 8 + i;
    std::size_t e = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const double side : {-1.0, 1.0}) {
        for (std::size_t i = 0; i < 8; ++i) {  // corner i with its coordinate on `axis` moved to `side`
          double p[3] = {parent[i][0], parent[i][1], parent[i][2]};
          const bool outside = p[axis] == side;
          p[axis] = side;
          std::size_t base = 0;
          while (parent[base][0] != p[0] || parent[base][1] != p[1] || parent[base][2] != p[2]) ++base;
          element[e][i] = outside ? base : 8 + base;
        }
        ++e;
      }
    }
  }
  Corners corners(std::size_t e) const {
    Corners x;
    for (std::size_t i = 0; i < 8; ++i) x[i] = node[element[e][i]];
    return x;
  }
};

TEST(PatchTest, ElementsHaveTheirKnownVolumes) {
  const Patch patch;
  std::vector<double> volume, expected = {.09856, .13697, .18950, .15277, .11015, .17018, .14187};
  double sum = 0;
  for (std::size_t e = 0; e < 7; ++e) {
    const HexahedronModes<double> m = modes<double>(patch.corners(e));
    volume.push_back(hexahedron_volume(uniform_gradient(m), m));
    sum += volume.back();
  }
  EXPECT_NEAR(sum, 1.0, 1e-14);
  std::sort(volume.begin(), volume.end());
  std::sort(expected.begin(), expected.end());
  for (std::size_t e = 0; e < 7; ++e) EXPECT_NEAR(volume[e], expected[e], 6e-6);
}

TEST(PatchTest, ConstantStressIsInEquilibrium) {
  const Patch patch;
  const Symmetric<double> stress{2000, 2000, 2000, 400, 400, 400};
  std::array<Vec3<double>, 16> force{};
  for (std::size_t e = 0; e < 7; ++e) {
    const Corners f = stress_forces(uniform_gradient(modes<double>(patch.corners(e))), stress);
    for (std::size_t i = 0; i < 8; ++i) force[patch.element[e][i]] = force[patch.element[e][i]] + f[i];
  }
  double largest = 0;
  for (std::size_t n = 0; n < 8; ++n) largest = std::max({largest, norm(force[n])});
  EXPECT_NEAR(largest, 700 * std::sqrt(3.0), 1e-9);  // (2000 + 400 + 400) / 4 on each axis
  for (std::size_t n = 8; n < 16; ++n) EXPECT_LT(norm(force[n]), 1e-15 * largest);
}

TEST(PatchTest, LinearDisplacementGivesTheConstantStrain) {
  const Patch patch;
  const Tensor<double> gradient{{1e-3, .5e-3, .5e-3}, {.5e-3, 1e-3, .5e-3}, {.5e-3, .5e-3, 1e-3}};
  for (std::size_t e = 0; e < 7; ++e) {
    const HexahedronModes<double> m = modes<double>(patch.corners(e));
    const HexahedronModes<double> u = modes<double>(linear_field({0, 0, 0}, gradient, patch.corners(e)));
    const UniformGradient<double> b = uniform_gradient(m);
    const Symmetric<double> strain = symmetric_part(velocity_gradient(b, u, 1 / hexahedron_volume(b, m)));
    EXPECT_SYMMETRIC_NEAR(strain, (Symmetric<double>{1e-3, 1e-3, 1e-3, .5e-3, .5e-3, .5e-3}), 2e-17);
  }
}

TEST(FaceAreas, AreHalfTheCrossProductsOfTheDiagonals) {
  static constexpr std::size_t face[6][4] = {{0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4},
                                             {3, 7, 6, 2}, {0, 3, 2, 1}, {4, 5, 6, 7}};  // seen from outside
  Random random(7);
  for (int trial = 0; trial < 50; ++trial) {
    const Corners x = random_hexahedron(random);
    Vec3<double> sum{0, 0, 0};
    for (int axis = 0; axis < 3; ++axis) {
      Vec3<double> area[2];
      face_areas(modes<double>(x), axis, area[0], area[1]);
      for (int side = 0; side < 2; ++side) {
        const std::size_t* f = face[2 * axis + side];
        EXPECT_VECTOR_NEAR(area[side], 0.5 * cross(x[f[2]] - x[f[0]], x[f[3]] - x[f[1]]), 2e-15);
        sum = sum + area[side];
      }
    }
    EXPECT_VECTOR_NEAR(sum, (Vec3<double>{0, 0, 0}), 2e-15);  // a closed surface
  }
}

/// A hexahedron with corners that coincide: 0 = prism (two edges collapsed), 1 = pyramid, 2 = tetrahedron.
class Collapsed : public ::testing::TestWithParam<int> {};
TEST_P(Collapsed, HasTheRightVolumeAndDifferentiatesLinearFields) {
  Corners x = box(1, 1, 1);
  double expected = 0.5;
  if (GetParam() == 0) x[2] = x[3], x[6] = x[7];
  if (GetParam() == 1) x[4] = x[5] = x[6] = x[7] = {0.5, 0.5, 1}, expected = 1.0 / 3.0;
  if (GetParam() == 2) x[2] = x[3], x[4] = x[5] = x[6] = x[7] = {0, 0, 1}, expected = 1.0 / 6.0;
  const HexahedronModes<double> m = modes<double>(x);
  const UniformGradient<double> b = uniform_gradient(m);
  const double volume = hexahedron_volume(b, m);
  EXPECT_NEAR(volume, expected, 1e-15);
  Random random(8);
  const Tensor<double> gradient = random_tensor(random);
  const Tensor<double> found =
      velocity_gradient(b, modes<double>(linear_field(random_vector(random), gradient, x)), 1 / volume);
  EXPECT_VECTOR_NEAR(found.row_x, gradient.row_x, 1e-14);
  EXPECT_VECTOR_NEAR(found.row_y, gradient.row_y, 1e-14);
  EXPECT_VECTOR_NEAR(found.row_z, gradient.row_z, 1e-14);
}
INSTANTIATE_TEST_SUITE_P(Shapes, Collapsed, ::testing::Values(0, 1, 2));

template <class T>
class HexahedronPack : public ::testing::Test {};
TYPED_TEST_SUITE(HexahedronPack, NumberTypes);

TYPED_TEST(HexahedronPack, EqualsTheScalarKernelLaneByLane) {
  using T = TypeParam;
  using S = ScalarOf<T>;
  Random random(9);
  std::vector<Corners> x, v;
  for (int i = 0; i < width_of<T>; ++i) {
    x.push_back(random_hexahedron(random));
    v.push_back(random_hexahedron(random));
  }
  const HexahedronModes<T> m = modes_from_lanes<T>(x), velocity = modes_from_lanes<T>(v);
  const UniformGradient<T> b = uniform_gradient(m);
  const T volume = hexahedron_volume(b, m);
  const Tensor<T> gradient = velocity_gradient(b, velocity, T(1) / volume);
  Vec3<T> corner[8], minus, plus;
  expand(b, corner);
  face_areas(m, 1, minus, plus);
  const double tolerance = 8 * epsilon<S>;
  for (int i = 0; i < width_of<T>; ++i) {
    const HexahedronModes<S> m1 = modes<S>(x[std::size_t(i)]);
    for (int a = 0; a < 4; ++a) EXPECT_VECTOR_NEAR(lane_of(m.hourglass[a], i), m1.hourglass[a], epsilon<S>);
    const UniformGradient<S> b1 = uniform_gradient(m1);
    const S volume1 = hexahedron_volume(b1, m1);
    EXPECT_NEAR(lane(volume, i), volume1, tolerance);
    const Tensor<S> gradient1 = velocity_gradient(b1, modes<S>(v[std::size_t(i)]), S(1) / volume1);
    const Tensor<S> found = lane_of(gradient, i);
    EXPECT_VECTOR_NEAR(found.row_x, gradient1.row_x, 4 * tolerance);
    EXPECT_VECTOR_NEAR(found.row_y, gradient1.row_y, 4 * tolerance);
    EXPECT_VECTOR_NEAR(found.row_z, gradient1.row_z, 4 * tolerance);
    Vec3<S> corner1[8], minus1, plus1;
    expand(b1, corner1);
    for (int k = 0; k < 8; ++k) EXPECT_VECTOR_NEAR(lane_of(corner[k], i), corner1[k], tolerance);
    face_areas(m1, 1, minus1, plus1);
    EXPECT_VECTOR_NEAR(lane_of(minus, i), minus1, tolerance);
    EXPECT_VECTOR_NEAR(lane_of(plus, i), plus1, tolerance);
    EXPECT_NEAR(volume1, quadrature_gradient(x[std::size_t(i)]).volume, 4 * tolerance);
  }
}

}  // namespace
}  // namespace pinball::hexahedron_test
