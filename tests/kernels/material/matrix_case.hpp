#pragma once

#include <array>

#include <tests/support/support.hpp>

/// Deformation gradients as matrices, for energies of elasticity.
namespace pinball::test {

using Matrix = std::array<std::array<double, 3>, 3>;

inline Matrix product(const Matrix& a, const Matrix& b) {
  Matrix c{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) c[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
  }
  return c;
}
inline Matrix transposed(const Matrix& m) {
  return {{{m[0][0], m[1][0], m[2][0]}, {m[0][1], m[1][1], m[2][1]}, {m[0][2], m[1][2], m[2][2]}}};
}
inline double determinant(const Matrix& m) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}
/// I + t H.
inline Matrix near_identity(const Matrix& h, double t) {
  Matrix m{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) m[i][j] = (i == j ? 1.0 : 0.0) + t * h[i][j];
  }
  return m;
}
inline Matrix random_matrix(Random& random, double size) {
  Matrix m{};
  for (auto& row : m) {
    for (double& one : row) one = uniform(random, -size, size);
  }
  return m;
}
/// F F^T - I.
inline Symmetric<double> strain_of(const Matrix& f) {
  const Matrix b = product(f, transposed(f));
  return {b[0][0] - 1, b[1][1] - 1, b[2][2] - 1, b[0][1], b[1][2], b[2][0]};
}
inline Tensor<double> tensor(const Matrix& m) {
  return {{m[0][0], m[0][1], m[0][2]}, {m[1][0], m[1][1], m[1][2]}, {m[2][0], m[2][1], m[2][2]}};
}

}  // namespace pinball::test
