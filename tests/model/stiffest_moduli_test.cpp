#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <solver/model/material/material_laws.hpp>
#include <solver/scene/material/orthotropic_moduli.hpp>
#include <tests/support/law_materials.hpp>

/// The isotropic moduli with which elements of an orthotropic material bound their step.
namespace pinball::test::stiffest_moduli_test {
namespace {

using Strain = std::array<double, 6>;

/// Largest eigenvalue of all moduli less lambda between the axes, which the Rayleigh quotient of a strain comes to that
/// is multiplied by them again and again. They are shifted, so that none is negative.
double largest_eigenvalue(const ElasticMatrix& c, double lambda) {
  const auto factor = [](std::size_t i) { return i < 3 ? 1 : std::sqrt(2.0); };
  ElasticMatrix left = c;
  double shift = 0;
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j < 6; ++j) {
      left[i][j] = factor(i) * factor(j) * c[i][j] - (i < 3 && j < 3 ? lambda : 0);
      shift += std::abs(left[i][j]);
    }
  }
  Strain strain{1, 0.9, 0.8, 0.7, 0.6, 0.5};
  double quotient = 0;
  for (int round = 0; round < 10000; ++round) {
    Strain next{};
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t j = 0; j < 6; ++j) next[i] += (left[i][j] + (i == j ? shift : 0)) * strain[j];
    }
    quotient = std::inner_product(strain.begin(), strain.end(), next.begin(), 0.0);
    const double length = std::sqrt(std::inner_product(next.begin(), next.end(), next.begin(), 0.0));
    for (std::size_t i = 0; i < 6; ++i) strain[i] = next[i] / length;
  }
  return quotient - shift;
}

TEST(StiffestModuli, AreTheLargestEigenvalueOfWhatIsAtLeastAsStiff) {
  struct Case {
    std::array<double, 3> young, ratios, shears;
  };
  const Case cases[] = {
      {{10e9, 1e9, 0.5e9}, {0.3, 0.25, 0.4}, {0.7e9, 0.2e9, 0.6e9}},
      {{2e11, 2e11, 1e10}, {0.3, 0.1, 0.1}, {7e10, 5e9, 5e9}},
      {{1e9, 1e9, 1e9}, {0.25, 0.25, 0.25}, {0.4e9, 0.4e9, 0.4e9}},  // isotropic
      {{1e9, 2e9, 3e9}, {0, 0, 0}, {5e9, 1e8, 2e8}},                 // the stiffest is a shear
      {{1e9, 2e9, 3e9}, {0, 0, 0}, {1e8, 5e9, 2e8}},
      {{1e9, 2e9, 3e9}, {0, 0, 0}, {1e8, 2e8, 5e9}},
  };
  for (const auto& [young, ratios, shears] : cases) {
    Material material = orthotropic();
    OrthotropicSettings& law = *material.orthotropic;
    std::copy(young.begin(), young.end(), law.young_moduli.begin());
    std::copy(ratios.begin(), ratios.end(), law.poisson_ratios.begin());
    std::copy(shears.begin(), shears.end(), law.shear_moduli.begin());
    const ElasticMatrix c = moduli_along_axes(law);
    const OrthotropicConstants<double> constants = orthotropic_constants<double>(material);
    EXPECT_NEAR(constants.lambda, std::max(0.0, (c[0][1] + c[0][2] + c[1][2]) / 3), 1e-14 * young[0]);
    const double exact = largest_eigenvalue(c, constants.lambda);
    EXPECT_NEAR(2 * constants.mu, exact, 1e-7 * exact) << young[1] << ' ' << shears[0];
  }
}

}  // namespace
}  // namespace pinball::test::stiffest_moduli_test
