#include <gtest/gtest.h>

#include <cmath>

#include <kernels/material/mooney_rivlin.hpp>

#include "energy_case.hpp"
#include "matrix_case.hpp"

/// Rubber after Mooney and Rivlin, against closed forms and its energy.
namespace pinball::test::mooney_rivlin_test {
namespace {

MooneyRivlinConstants<double> rubber(double a, double b, double nu) {
  return {true, a, b, a / 2 + b, (a * (5 * nu - 2) + b * (11 * nu - 5)) / (2 * (1 - 2 * nu))};
}

/// W of the manual, of the invariants of F^T F.
double energy(const MooneyRivlinConstants<double>& law, const Matrix& f) {
  const Matrix c = product(transposed(f), f), c2 = product(c, c);
  const double first = c[0][0] + c[1][1] + c[2][2], third = determinant(c);
  const double second = 0.5 * (first * first - (c2[0][0] + c2[1][1] + c2[2][2]));
  return law.a * (first - 3) + law.b * (second - 3) + law.c * (1 / (third * third) - 1) +
         law.d * (third - 1) * (third - 1);
}
TEST(MooneyRivlin, FollowsHookeForSmallStrains) {
  Random random(61);
  for (const double nu : {0.3, 0.45, 0.495}) {
    const auto law = rubber(3, 1.2, nu);
    const double mu = 2 * (3 + 1.2), lambda = 2 * mu * nu / (1 - 2 * nu);
    const Matrix h = random_matrix(random, 1e-7);
    const Matrix f = near_identity(h, 1);
    const auto now = mooney_rivlin_state(law, strain_of(f), determinant(f));
    EXPECT_SYMMETRIC_NEAR(now.stress, elastic_increment(lambda, mu, symmetric_part(tensor(h))), 1e-12 * lambda);
    EXPECT_NEAR(now.mu, mu, 1e-5 * mu);
    EXPECT_NEAR(now.lambda, lambda, 1e-5 * lambda);
  }
}

/// In simple shear by k: s_xy = 2 (A + B) k, s_xx - s_zz = 2 A k^2, s_yy - s_zz = -2 B k^2 (Rivlin 1948).
TEST(MooneyRivlin, HasTheNormalStressesOfSimpleShear) {
  const auto law = rubber(3, 1.2, 0.49);
  for (const double k : {0.1, 1.0, 3.0}) {
    const auto s = mooney_rivlin_state(law, strain_of({{{1, k, 0}, {0, 1, 0}, {0, 0, 1}}}), 1.0).stress;
    EXPECT_NEAR(s.xy, 2 * (3 + 1.2) * k, 1e-12);
    EXPECT_NEAR(s.xx - s.zz, 2 * 3 * k * k, 1e-12);
    EXPECT_NEAR(s.yy - s.zz, -2 * 1.2 * k * k, 1e-12);
    EXPECT_NEAR(s.yz, 0, 1e-14);
  }
}

/// Drawn to the stretch l along x, and thinned until nothing acts across: of rubber that hardly changes its volume,
/// 2 (l^2 - 1/l) (A + B/l).
TEST(MooneyRivlin, IsDrawnAsRubberIs) {
  const auto law = rubber(0.3, 0.1, 0.499995);
  for (const double l : {0.5, 1.5, 3.0}) {
    double low = 0.9 / std::sqrt(l), high = 1.1 / std::sqrt(l);  // the stretch across
    Symmetric<double> s{};
    for (int i = 0; i < 200; ++i) {
      const double across = 0.5 * (low + high);
      s = mooney_rivlin_state(law, strain_of({{{l, 0, 0}, {0, across, 0}, {0, 0, across}}}), l * across * across)
              .stress;
      (s.yy < 0 ? low : high) = across;
    }
    EXPECT_NEAR(s.yy, 0, 1e-6);
    const double exact = 2 * (l * l - 1 / l) * (0.3 + 0.1 / l);
    EXPECT_NEAR(s.xx, exact, 2e-4 * std::abs(exact));
  }
}

/// First and second differences of W over motions I + t H of any strained state.
TEST(MooneyRivlin, DoesTheWorkOfItsEnergyAndIsNoStifferThanItsModuli) {
  Random random(62);
  double tightest = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const double a = uniform(random, 0.01, 3), b = uniform(random, 0, 3);
    const auto law = rubber(a, b, uniform(random, 0.2, 0.49));
    const Matrix f = near_identity(random_matrix(random, 1), uniform(random, 0, 0.7));
    const double j = determinant(f);
    if (j < 0.3) continue;
    const auto now = mooney_rivlin_state(law, strain_of(f), j);
    const Matrix h = random_matrix(random, 1);
    const double share = expect_differences_of([&](const Matrix& g) { return energy(law, g); }, now, f, h);
    tightest = std::max(tightest, share);
  }
  EXPECT_GT(tightest, 0.6);
}

TEST(MooneyRivlin, ItsStrainIsThatOfTheWholeDeformation) {
  Random random(63);
  Matrix f = near_identity({}, 0);
  Symmetric<double> strain{0, 0, 0, 0, 0, 0};
  for (int i = 0; i < 200; ++i) {
    const Matrix h = random_matrix(random, 0.05);
    const Matrix minus = near_identity(h, -1), plus = near_identity(h, 1);
    Matrix step{};  // (I - h)^-1 (I + h), by Cramer's rule
    for (std::size_t column = 0; column < 3; ++column) {
      for (std::size_t row = 0; row < 3; ++row) {
        Matrix replaced = minus;
        for (std::size_t k = 0; k < 3; ++k) replaced[k][row] = plus[k][column];
        step[row][column] = determinant(replaced) / determinant(minus);
      }
    }
    f = product(step, f);
    strain = strain_after(tensor(h), strain);
  }
  EXPECT_SYMMETRIC_NEAR(strain, strain_of(f), 1e-11 * (1 + norm(strain)));
}

}  // namespace
}  // namespace pinball::test::mooney_rivlin_test
