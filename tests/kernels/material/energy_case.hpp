#pragma once

#include <gtest/gtest.h>

#include <kernels/material/neo_hookean.hpp>

#include "matrix_case.hpp"

namespace pinball::test {

/// Expects of the state that a law with this energy has after F, by first and second differences over motions
/// (I + t H) F, the stress that does the work of the energy, and moduli that are at least as stiff. Returns how much of
/// the stiffness that these allow is there.
template <class Energy>
double expect_differences_of(const Energy& energy, const NeoHookeanState<double>& now, const Matrix& f,
                             const Matrix& h) {
  constexpr double step = 1e-4;
  const double j = determinant(f);
  const double here = energy(f), ahead = energy(product(near_identity(h, step), f)),
               behind = energy(product(near_identity(h, -step), f));
  const double size = now.lambda + now.mu;
  EXPECT_NEAR((ahead - behind) / (2 * step), j * contract(now.stress, symmetric_part(tensor(h))), 1e-5 * j * size);
  double square = 0;
  for (const auto& row : h) {
    for (const double one : row) square += one * one;
  }
  const double change = h[0][0] + h[1][1] + h[2][2];
  const double stiffness = (ahead - 2 * here + behind) / (step * step) / j;
  const double bound = 2 * now.mu * square + now.lambda * change * change;
  EXPECT_LE(stiffness, bound + 1e-5 * size * square);
  return stiffness / bound;
}

}  // namespace pinball::test
