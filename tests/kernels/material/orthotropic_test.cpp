#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include <kernels/material/orthotropic.hpp>
#include <tests/support/support.hpp>

/// Elasticity that differs with the direction, against closed forms and its energy.
namespace pinball::test::orthotropic_test {
namespace {

using Moduli = std::array<std::array<double, 6>, 6>;

OrthotropicConstants<double> constants(const Moduli& c, double lambda, double mu) {
  OrthotropicConstants<double> law;
  law.used = true;
  law.lambda = lambda;
  law.mu = mu;
  int k = 0;
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = i; j < 6; ++j) law.moduli[k++] = c[i][j];
  }
  return law;
}

Moduli isotropic(double lambda, double mu) {
  Moduli c{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) c[i][j] = lambda;
    c[i][i] += 2 * mu;
    c[i + 3][i + 3] = mu;
  }
  return c;
}

/// Along x, y and z, with nothing in common between two of them.
Moduli of_three_axes() {
  Moduli c = isotropic(0, 1);
  const double values[9] = {9, 5, 2, 1.5, 0.7, 0.4, 1.2, 0.8, 0.3};  // xx yy zz, xxyy xxzz yyzz, xy yz zx
  for (std::size_t i = 0; i < 3; ++i) c[i][i] = values[i], c[i + 3][i + 3] = values[i + 6];
  c[0][1] = c[1][0] = values[3];
  c[0][2] = c[2][0] = values[4];
  c[1][2] = c[2][1] = values[5];
  return c;
}

Tensor<double> product(const Tensor<double>& a, const Tensor<double>& b) {
  const auto row = [&](const Vec3<double>& r) { return r.x * b.row_x + r.y * b.row_y + r.z * b.row_z; };
  return {row(a.row_x), row(a.row_y), row(a.row_z)};
}
Tensor<double> plus_one(Tensor<double> h, double by = 1) {
  h.row_x.x += by, h.row_y.y += by, h.row_z.z += by;
  return h;
}
double determinant(const Tensor<double>& f) { return dot(f.row_x, cross(f.row_y, f.row_z)); }
Tensor<double> random_tensor(Random& random, double size) {
  const auto row = [&] {
    const double x = uniform(random, -size, size), y = uniform(random, -size, size);
    return Vec3<double>{x, y, uniform(random, -size, size)};
  };
  const Vec3<double> a = row(), b = row();
  return {a, b, row()};
}
/// By the angle about z.
Tensor<double> turn(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {{c, -s, 0}, {s, c, 0}, {0, 0, 1}};
}
/// Per initial volume.
double energy(const OrthotropicConstants<double>& law, const Tensor<double>& f) {
  const Symmetric<double> e = green_strain(plus_one(f, -1));
  return 0.5 * contract(e, product_of_moduli<double>(law.moduli, e));
}

TEST(Orthotropic, IsHookesLawWithItsModuli) {
  Random random(71);
  const Tensor<double> h = random_tensor(random, 1e-8);
  const Symmetric<double> e = symmetric_part(h);
  const auto same = orthotropic_state(constants(isotropic(3, 2), 3, 2), h);
  EXPECT_SYMMETRIC_NEAR(same.stress, elastic_increment(3.0, 2.0, e), 1e-14);
  EXPECT_NEAR(same.lambda, 3, 1e-6);
  EXPECT_NEAR(same.mu, 2, 1e-6);
  const Symmetric<double> s = orthotropic_state(constants(of_three_axes(), 1, 5), h).stress;
  const Symmetric<double> exact{9 * e.xx + 1.5 * e.yy + 0.7 * e.zz,
                                1.5 * e.xx + 5 * e.yy + 0.4 * e.zz,
                                0.7 * e.xx + 0.4 * e.yy + 2 * e.zz,
                                2.4 * e.xy,
                                1.6 * e.yz,
                                0.6 * e.zx};
  EXPECT_SYMMETRIC_NEAR(s, exact, 1e-14);
}

/// What is stretched along the first axis by l has the stress l C_1111 (l^2 - 1)/2 there, and its axes turn with it: at
/// a right angle it is that along y, all of it to round-off.
TEST(Orthotropic, KeepsItsAxesInTheMaterial) {
  const auto law = constants(of_three_axes(), 1, 5);
  const double l = 1.1, strain = 0.5 * (l * l - 1);
  const Tensor<double> stretch{{l, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const Symmetric<double> s = orthotropic_state(law, plus_one(stretch, -1)).stress;
  EXPECT_SYMMETRIC_NEAR(s, (Symmetric<double>{l * 9 * strain, 1.5 * strain / l, 0.7 * strain / l, 0, 0, 0}), 1e-14);
  const Symmetric<double> turned = orthotropic_state(law, plus_one(product(turn(std::acos(0.0)), stretch), -1)).stress;
  EXPECT_SYMMETRIC_NEAR(turned, (Symmetric<double>{s.yy, s.xx, s.zz, 0, 0, 0}), 1e-14);
  EXPECT_SYMMETRIC_NEAR(orthotropic_state(law, plus_one(turn(2.2), -1)).stress, (Symmetric<double>{0, 0, 0, 0, 0, 0}),
                        1e-14);
}

/// First and second differences of W over motions I + t H of any strained state. Of the second material C less 0.8 1
/// (x) 1 has no eigenvalue beyond 9: the sums of the rows of what is left are no larger.
TEST(Orthotropic, DoesTheWorkOfItsEnergyAndIsNoStifferThanItsModuli) {
  Random random(72);
  double tightest = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const bool same = trial % 2 == 0;
    const auto law = same ? constants(isotropic(3, 2), 3, 2) : constants(of_three_axes(), 0.8, 4.5);
    const Tensor<double> f = plus_one(uniform(random, 0, 0.5) * random_tensor(random, 1));
    const double j = determinant(f);
    if (j < 0.3) continue;
    const auto now = orthotropic_state(law, plus_one(f, -1));
    const Tensor<double> h = random_tensor(random, 1);
    constexpr double step = 1e-4;
    const double here = energy(law, f), ahead = energy(law, product(plus_one(step * h), f)),
                 behind = energy(law, product(plus_one(-step * h), f));
    const double size = now.lambda + now.mu;
    EXPECT_NEAR((ahead - behind) / (2 * step), j * contract(now.stress, symmetric_part(h)), 1e-5 * j * size);
    const double square = dot(h.row_x, h.row_x) + dot(h.row_y, h.row_y) + dot(h.row_z, h.row_z);
    const double change = h.row_x.x + h.row_y.y + h.row_z.z;
    const double stiffness = (ahead - 2 * here + behind) / (step * step) / j;
    const double bound = 2 * now.mu * square + now.lambda * change * change;
    EXPECT_LE(stiffness, bound + 1e-5 * size * square) << trial;
    tightest = std::max(tightest, stiffness / bound);
  }
  EXPECT_GT(tightest, 0.6);
}

TEST(Orthotropic, ItsGradientIsThatOfTheWholeDeformation) {
  Random random(73);
  Tensor<double> f = plus_one({}), gradient{};
  for (int i = 0; i < 200; ++i) {
    const Tensor<double> h = random_tensor(random, 0.05);
    const Tensor<double> before = f;
    f = plus_one(displacement_gradient_after(h, plus_one(before, -1)));
    gradient = displacement_gradient_after(h, gradient);
    // (I - h) f_after = (I + h) f_before
    const Tensor<double> left = product(plus_one(-1.0 * h), f), right = product(plus_one(h), before);
    EXPECT_NEAR(dot(left.row_x, left.row_y), dot(right.row_x, right.row_y), 1e-12 * (1 + determinant(f)));
    EXPECT_NEAR(determinant(left), determinant(right), 1e-12 * (1 + determinant(f)));
  }
  EXPECT_NEAR(determinant(plus_one(gradient)), determinant(f), 1e-12 * (1 + determinant(f)));
  Tensor<double> turned{};
  const double half = 0.5 * std::acos(0.0) / 100;  // h of a rotation by 2 atan of it
  for (int i = 0; i < 100; ++i) turned = displacement_gradient_after({{0, -half, 0}, {half, 0, 0}, {0, 0, 0}}, turned);
  EXPECT_SYMMETRIC_NEAR(green_strain(turned), (Symmetric<double>{0, 0, 0, 0, 0, 0}), 1e-14);
  EXPECT_NEAR(turned.row_y.x, std::sin(200 * std::atan(half)), 1e-13);
}

}  // namespace
}  // namespace pinball::test::orthotropic_test
