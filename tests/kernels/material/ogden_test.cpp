#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <kernels/material/ogden.hpp>

#include "energy_case.hpp"
#include "matrix_case.hpp"

/// Powers of stretches, against closed forms and their energy.
namespace pinball::test::ogden_test {
namespace {

struct Term {
  double modulus, exponent;
};

OgdenConstants<double> law_of(const std::vector<Term>& terms, double nu, bool whole = false) {
  OgdenConstants<double> law;
  law.used = true, law.whole = whole;
  double mu = 0;
  for (const Term& term : terms) {
    law.modulus[law.terms] = term.modulus, law.exponent[law.terms] = term.exponent;
    ++law.terms;
    mu += 0.5 * term.modulus * term.exponent;
  }
  if (whole) law.coupling = nu / (1 - 2 * nu);
  if (!whole) law.bulk = 2 * mu * (1 + nu) / (3 * (1 - 2 * nu));
  return law;
}

/// Ogden's own constants for the rubber of Treloar (1972), in MPa.
const std::vector<Term> treloar{{0.63, 1.3}, {0.0012, 5}, {-0.01, -2}};

/// Squares of the principal stretches: eigenvalues of F^T F by Jacobi's rotations.
std::array<double, 3> squares_of_stretches(const Matrix& f) {
  Matrix c = product(transposed(f), f);
  for (int sweep = 0; sweep < 12; ++sweep) {
    for (std::size_t p = 0; p < 3; ++p) {
      const std::size_t q = (p + 1) % 3;
      const double difference = c[q][q] - c[p][p], side = difference < 0 ? -1 : 1;  // by an eighth of a turn at most
      const double angle = 0.5 * std::atan2(side * 2 * c[p][q], side * difference);
      Matrix turn = near_identity({}, 0);
      turn[p][p] = turn[q][q] = std::cos(angle);
      turn[p][q] = std::sin(angle), turn[q][p] = -std::sin(angle);
      c = product(transposed(turn), product(c, turn));
    }
  }
  return {c[0][0], c[1][1], c[2][2]};
}

double energy(const OgdenConstants<double>& law, const Matrix& f) {
  const std::array<double, 3> squares = squares_of_stretches(f);
  const double j = determinant(f);
  double sum = law.whole ? 0 : 0.5 * law.bulk * (j - 1) * (j - 1);
  for (int p = 0; p < law.terms; ++p) {
    const double a = law.exponent[p], m = law.modulus[p], scale = law.whole ? 1 : std::pow(j, -a / 3);
    double powers = -3;
    for (const double square : squares) powers += scale * std::pow(square, a / 2);
    sum += m / a * powers;
    if (law.whole && law.coupling > 0) sum += m / (a * law.coupling) * (std::pow(j, -a * law.coupling) - 1);
  }
  return sum;
}

TEST(Ogden, FollowsHookeForSmallStrains) {
  Random random(71);
  for (const bool whole : {false, true}) {
    for (const double nu : {0.0, 0.3, 0.495}) {
      const auto law = law_of({{3, 1.4}, {-1.2, -2.5}, {0.1, 6}}, nu, whole);
      const double mu = 0.5 * (3 * 1.4 + 1.2 * 2.5 + 0.1 * 6), lambda = 2 * mu * nu / (1 - 2 * nu);
      const Matrix h = random_matrix(random, 1e-9);
      const double change = h[0][0] + h[1][1] + h[2][2];
      Symmetric<double> small = symmetric_part(tensor(h));
      const auto now = ogden_state(law, 2.0 * small, 1 + change);
      // 1 + change has lost the digits of the change; the stretches have not
      EXPECT_SYMMETRIC_NEAR(now.stress, elastic_increment(lambda, mu, small), 3e-16 * (lambda + mu) + 1e-7 * mu * 1e-9);
      EXPECT_NEAR(now.mu, mu, 1e-6 * mu);
      EXPECT_NEAR(now.lambda, lambda, 1e-6 * (lambda + mu));
    }
  }
}

/// Drawn along one axis, sum of m (l^a - l^(-a/2)), and along two, sum of m (l^a - l^(-2a)).
TEST(Ogden, IsDrawnAsRubberIs) {
  const auto law = law_of(treloar, 0.49);
  for (const double l : {0.5, 0.9, 1.0001, 2.0, 2.5}) {
    double along_one = 0, along_two = 0;
    for (const auto& [m, a] : treloar) {
      along_one += m * (std::pow(l, a) - std::pow(l, -a / 2));
      along_two += m * (std::pow(l, a) - std::pow(l, -2 * a));
    }
    const auto one = ogden_state(law, Symmetric<double>{l * l - 1, 1 / l - 1, 1 / l - 1, 0, 0, 0}, 1.0).stress;
    EXPECT_NEAR(one.xx - one.yy, along_one, 1e-13 * (std::abs(along_one) + 1)) << l;
    EXPECT_NEAR(one.yy, one.zz, 1e-14);
    const double thin = std::pow(l, -4) - 1;
    const auto two = ogden_state(law, Symmetric<double>{l * l - 1, l * l - 1, thin, 0, 0, 0}, 1.0).stress;
    EXPECT_NEAR(two.xx - two.zz, along_two, 1e-13 * (std::abs(along_two) + 1)) << l;
    EXPECT_NEAR(two.xx, two.yy, 1e-13);
  }
}

/// In simple shear by k the stretches are l, 1 and 1/l, l - 1/l = k: s_xy = sum of m (l^a - l^-a)/(l + 1/l), and
/// s_xx - s_yy = k s_xy of any law (Rivlin 1948).
TEST(Ogden, HasTheStressesOfSimpleShear) {
  const auto law = law_of(treloar, 0.49);
  for (const double k : {0.01, 1.0, 3.0}) {
    const double l = 0.5 * k + std::sqrt(1 + 0.25 * k * k);
    double exact = 0;
    for (const auto& [m, a] : treloar) exact += m * (std::pow(l, a) - std::pow(l, -a)) / (l + 1 / l);
    const auto s = ogden_state(law, strain_of({{{1, k, 0}, {0, 1, 0}, {0, 0, 1}}}), 1.0).stress;
    EXPECT_NEAR(s.xy, exact, 1e-13 * (1 + exact));
    EXPECT_NEAR(s.xx - s.yy, k * exact, 1e-13 * (1 + k * exact));
    EXPECT_NEAR(s.yz, 0, 1e-14);
  }
}

/// The exponents 2 and -2 are Mooney's, A = m_1/2 and B = -m_2/2, but for the energy of volumes.
TEST(Ogden, HasMooneysStressesOfShape) {
  Random random(72);
  const auto law = law_of({{6, 2}, {-2.4, -2}}, 0.49);
  const MooneyRivlinConstants<double> mooney{true, 3, 1.2, 2.7, 100};
  for (int trial = 0; trial < 200; ++trial) {
    Matrix f = near_identity(random_matrix(random, 1), 0.5);
    const double j = determinant(f);
    if (j < 0.2) continue;
    for (auto& row : f) {
      for (double& one : row) one /= std::cbrt(j);
    }
    const auto ours = deviator_of(ogden_state(law, strain_of(f), 1.0).stress),
               theirs = deviator_of(mooney_rivlin_state(mooney, strain_of(f), 1.0).stress);
    EXPECT_SYMMETRIC_NEAR(ours, theirs, 1e-12 * (1 + norm(theirs)));
  }
}

/// A foam of nu = 0 that is pressed along one axis does not press across.
TEST(Ogden, OfWholeStretchesNeedNotContract) {
  const auto law = law_of({{2, 4}, {-1, -3}}, 0, true);
  for (const double l : {0.3, 1.7}) {
    const auto s = ogden_state(law, Symmetric<double>{l * l - 1, 0, 0, 0, 0, 0}, l).stress;
    EXPECT_NEAR(s.xx, (2 * (std::pow(l, 4) - 1) - (std::pow(l, -3) - 1)) / l, 1e-12);
    EXPECT_NEAR(s.yy, 0, 1e-14);
    EXPECT_NEAR(s.zz, 0, 1e-14);
  }
}

/// First and second differences of W over motions I + t H of any strained state.
TEST(Ogden, DoesTheWorkOfItsEnergyAndIsNoStifferThanItsModuli) {
  Random random(73);
  double tightest = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    std::vector<Term> terms;
    for (int p = 0; p <= trial % 3; ++p) {
      const double a = uniform(random, 0.5, 5) * (trial % 2 == 0 ? 1 : -1);
      terms.push_back({uniform(random, 0.1, 2) * (a > 0 ? 1 : -1), a});
    }
    const auto law = law_of(terms, uniform(random, 0.05, 0.49), trial % 5 < 2);
    const Matrix f = near_identity(random_matrix(random, 1), uniform(random, 0, 0.6));
    const double j = determinant(f);
    if (j < 0.3) continue;
    const auto now = ogden_state(law, strain_of(f), j);
    const Matrix h = random_matrix(random, 1);
    const double share = expect_differences_of([&](const Matrix& g) { return energy(law, g); }, now, f, h);
    tightest = std::max(tightest, share);
  }
  EXPECT_GT(tightest, 0.6);
}

/// Each lane is what it is alone, but for what a compiler fuses.
TEST(Ogden, IsTheSameInPacks) {
  using Pack = stdx::native_simd<double>;
  Random random(74);
  const auto law = law_of(treloar, 0.49);
  std::vector<Symmetric<double>> strains;
  std::vector<double> ratios;
  for (std::size_t i = 0; i < Pack::size(); ++i) {
    const Matrix f = near_identity(random_matrix(random, 1), i == 0 ? 0 : 0.3);
    strains.push_back(strain_of(f));
    ratios.push_back(determinant(f));
  }
  const auto pack = [&](double Symmetric<double>::*member) { return Pack([&](auto i) { return strains[i].*member; }); };
  using One = Symmetric<double>;
  const auto together = ogden_state(
      law,
      Symmetric<Pack>{pack(&One::xx), pack(&One::yy), pack(&One::zz), pack(&One::xy), pack(&One::yz), pack(&One::zx)},
      Pack([&](auto i) { return ratios[i]; }));
  for (std::size_t i = 0; i < Pack::size(); ++i) {
    const auto alone = ogden_state(law, strains[i], ratios[i]);
    EXPECT_NEAR(together.stress.xy[i], alone.stress.xy, 1e-14 * (1 + norm(alone.stress)));
    EXPECT_NEAR(together.stress.zz[i], alone.stress.zz, 1e-14 * (1 + norm(alone.stress)));
    EXPECT_NEAR(together.mu[i], alone.mu, 1e-14 * alone.mu);
  }
}

}  // namespace
}  // namespace pinball::test::ogden_test
