#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <new>
#include <random>
#include <vector>

#include <kernels/hexahedron.hpp>
#include <kernels/simd.hpp>
#include <kernels/tensor.hpp>

/// What the kernel tests share: number types, lanes, random data, and hexahedra integrated by quadrature.
namespace pinball::test {

// ---- Number types -------------------------------------------------------------------------------------------------

/// Scalars and packs of every width that some instruction set holds in one register.
using NumberTypes = ::testing::Types<double, float, Pack<double, 2>, Pack<double, 4>, Pack<double, 8>, Pack<float, 4>,
                                     Pack<float, 8>, Pack<float, 16>>;

template <class S>
inline constexpr double epsilon = static_cast<double>(std::numeric_limits<S>::epsilon());

template <class T>
void set_lane(T& pack, int i, ScalarOf<T> value) {
  if constexpr (width_of<T> == 1) {
    pack = value;
  } else {
    pack[i] = value;
  }
}

/// Pack whose lane i is f(i).
template <class T, class F>
T from_lanes(const F& f) {
  T pack(0);
  for (int i = 0; i < width_of<T>; ++i) set_lane(pack, i, static_cast<ScalarOf<T>>(f(i)));
  return pack;
}
template <class T, class F>
Vec3<T> vector_from_lanes(const F& f) {
  return {from_lanes<T>([&](int i) { return f(i).x; }), from_lanes<T>([&](int i) { return f(i).y; }),
          from_lanes<T>([&](int i) { return f(i).z; })};
}
template <class T, class F>
Symmetric<T> symmetric_from_lanes(const F& f) {
  return {from_lanes<T>([&](int i) { return f(i).xx; }), from_lanes<T>([&](int i) { return f(i).yy; }),
          from_lanes<T>([&](int i) { return f(i).zz; }), from_lanes<T>([&](int i) { return f(i).xy; }),
          from_lanes<T>([&](int i) { return f(i).yz; }), from_lanes<T>([&](int i) { return f(i).zx; })};
}

template <class T>
Vec3<ScalarOf<T>> lane_of(const Vec3<T>& v, int i) {
  return {lane(v.x, i), lane(v.y, i), lane(v.z, i)};
}
template <class T>
Symmetric<ScalarOf<T>> lane_of(const Symmetric<T>& s, int i) {
  return {lane(s.xx, i), lane(s.yy, i), lane(s.zz, i), lane(s.xy, i), lane(s.yz, i), lane(s.zx, i)};
}
template <class T>
Tensor<ScalarOf<T>> lane_of(const Tensor<T>& a, int i) {
  return {lane_of(a.row_x, i), lane_of(a.row_y, i), lane_of(a.row_z, i)};
}
template <class T>
HexahedronModes<ScalarOf<T>> lane_of(const HexahedronModes<T>& m, int i) {
  HexahedronModes<ScalarOf<T>> r;
  r.constant = lane_of(m.constant, i);
  for (int k = 0; k < 3; ++k) r.linear[k] = lane_of(m.linear[k], i);
  for (int k = 0; k < 4; ++k) r.hourglass[k] = lane_of(m.hourglass[k], i);
  return r;
}
template <class T>
UniformGradient<ScalarOf<T>> lane_of(const UniformGradient<T>& b, int i) {
  UniformGradient<ScalarOf<T>> r;
  for (int k = 0; k < 3; ++k) r.linear[k] = lane_of(b.linear[k], i), r.hourglass[k] = lane_of(b.hourglass[k], i);
  return r;
}

// ---- Comparison ---------------------------------------------------------------------------------------------------

inline double norm(double a) { return std::abs(a); }
template <class S>
double norm(const Vec3<S>& v) {
  return std::sqrt(double(v.x) * double(v.x) + double(v.y) * double(v.y) + double(v.z) * double(v.z));
}
template <class S>
double norm(const Symmetric<S>& s) {
  return std::sqrt(static_cast<double>(contract(s, s)));
}

#define EXPECT_VECTOR_NEAR(a, b, tolerance) \
  do {                                      \
    EXPECT_NEAR((a).x, (b).x, (tolerance)); \
    EXPECT_NEAR((a).y, (b).y, (tolerance)); \
    EXPECT_NEAR((a).z, (b).z, (tolerance)); \
  } while (false)
#define EXPECT_SYMMETRIC_NEAR(a, b, tolerance) \
  do {                                         \
    EXPECT_NEAR((a).xx, (b).xx, (tolerance));  \
    EXPECT_NEAR((a).yy, (b).yy, (tolerance));  \
    EXPECT_NEAR((a).zz, (b).zz, (tolerance));  \
    EXPECT_NEAR((a).xy, (b).xy, (tolerance));  \
    EXPECT_NEAR((a).yz, (b).yz, (tolerance));  \
    EXPECT_NEAR((a).zx, (b).zx, (tolerance));  \
  } while (false)

#define ASSERT_SYMMETRIC_EQ(a, b)                                                                                 \
  ASSERT_TRUE((a).xx == (b).xx && (a).yy == (b).yy && (a).zz == (b).zz && (a).xy == (b).xy && (a).yz == (b).yz && \
              (a).zx == (b).zx)

// ---- Memory -------------------------------------------------------------------------------------------------------

template <class T>
struct AlignedAllocator {
  using value_type = T;
  AlignedAllocator() = default;
  template <class U>
  AlignedAllocator(const AlignedAllocator<U>&) {}
  T* allocate(std::size_t n) { return static_cast<T*>(::operator new(n * sizeof(T), std::align_val_t(64))); }
  void deallocate(T* p, std::size_t) { ::operator delete(p, std::align_val_t(64)); }
  bool operator==(const AlignedAllocator&) const { return true; }
};
template <class T>
using AlignedVector = std::vector<T, AlignedAllocator<T>>;

// ---- Random data --------------------------------------------------------------------------------------------------

using Random = std::mt19937_64;
inline double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}
inline Vec3<double> random_vector(Random& random, double size = 1.0) {
  const double x = uniform(random, -size, size), y = uniform(random, -size, size), z = uniform(random, -size, size);
  return {x, y, z};
}
inline Vec3<double> random_direction(Random& random) {
  for (;;) {
    const Vec3<double> v = random_vector(random);
    const double length = norm(v);
    if (length > 0.1 && length < 1.0) return (1 / length) * v;
  }
}
inline Symmetric<double> random_symmetric(Random& random, double size = 1.0) {
  const Vec3<double> a = random_vector(random, size), b = random_vector(random, size);
  return {a.x, a.y, a.z, b.x, b.y, b.z};
}
inline Tensor<double> random_tensor(Random& random, double size = 1.0) {
  const Vec3<double> a = random_vector(random, size), b = random_vector(random, size), c = random_vector(random, size);
  return {a, b, c};
}
/// Rodrigues' formula: rotation by `angle` about a unit axis.
inline Tensor<double> rotation_matrix(const Vec3<double>& n, double angle) {
  const double c = std::cos(angle), s = std::sin(angle), t = 1 - c;
  return {{c + t * n.x * n.x, t * n.x * n.y - s * n.z, t * n.x * n.z + s * n.y},
          {t * n.x * n.y + s * n.z, c + t * n.y * n.y, t * n.y * n.z - s * n.x},
          {t * n.x * n.z - s * n.y, t * n.y * n.z + s * n.x, c + t * n.z * n.z}};
}
/// R sigma R^T, component by component.
inline Symmetric<double> rotated(const Tensor<double>& r, const Symmetric<double>& s) {
  const double q[3][3] = {
      {r.row_x.x, r.row_x.y, r.row_x.z}, {r.row_y.x, r.row_y.y, r.row_y.z}, {r.row_z.x, r.row_z.y, r.row_z.z}};
  const double a[3][3] = {{s.xx, s.xy, s.zx}, {s.xy, s.yy, s.yz}, {s.zx, s.yz, s.zz}};
  double result[3][3] = {};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l) result[i][j] += q[i][k] * a[k][l] * q[j][l];
  return {result[0][0], result[1][1], result[2][2], result[0][1], result[1][2], result[2][0]};
}

// ---- Hexahedra ----------------------------------------------------------------------------------------------------

using Corners = std::array<Vec3<double>, 8>;

/// Parent coordinates of the corners.
inline constexpr double parent[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                        {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
/// Corner values of hourglass mode a: eta zeta, zeta xi, xi eta, xi eta zeta.
inline double hourglass_value(int a, int corner) {
  const double* p = parent[corner];
  return a == 0 ? p[1] * p[2] : a == 1 ? p[2] * p[0] : a == 2 ? p[0] * p[1] : p[0] * p[1] * p[2];
}

/// The 24 values B_iI of the mean gradient operator, which the kernels never need one by one.
template <class T>
void expand(const UniformGradient<T>& b, Vec3<T> (&corner)[8]) {
  const Vec3<T> hourglass[4] = {b.hourglass[0], b.hourglass[1], b.hourglass[2], {T(0), T(0), T(0)}};
  from_modes(b.linear, hourglass, corner);
}

inline Corners box(double a, double b, double c) {
  Corners x;
  for (std::size_t i = 0; i < 8; ++i) {
    x[i] = {0.5 * a * (parent[i][0] + 1), 0.5 * b * (parent[i][1] + 1), 0.5 * c * (parent[i][2] + 1)};
  }
  return x;
}
inline Corners mapped(const Tensor<double>& a, const Corners& x) {
  Corners y;
  for (std::size_t i = 0; i < 8; ++i) y[i] = a * x[i];
  return y;
}
/// Sheared, stretched and distorted cube of edge about 1, Jacobian positive everywhere.
inline Corners random_hexahedron(Random& random, double distortion = 0.18) {
  const Tensor<double> noise = random_tensor(random, 0.3);
  const Tensor<double> a{{1 + noise.row_x.x, noise.row_x.y, noise.row_x.z},
                         {noise.row_y.x, 1 + noise.row_y.y, noise.row_y.z},
                         {noise.row_z.x, noise.row_z.y, 1 + noise.row_z.z}};
  Corners x = box(1, 1, 1);
  for (Vec3<double>& corner : x) corner = corner + random_vector(random, distortion);
  return mapped(a, x);
}
/// Values of a linear field a + A x at the corners.
inline Corners linear_field(const Vec3<double>& a, const Tensor<double>& gradient, const Corners& x) {
  Corners v;
  for (std::size_t i = 0; i < 8; ++i) v[i] = a + gradient * x[i];
  return v;
}

/// Independent scalar implementation of the mean gradient: 2 x 2 x 2 Gauss quadrature of dN_I/dx, exact for a trilinear
/// hexahedron.
struct QuadratureGradient {
  Corners b{};
  double volume = 0;
};
inline QuadratureGradient quadrature_gradient(const Corners& x) {
  QuadratureGradient result;
  const double g = 1 / std::sqrt(3.0);
  for (const auto& point : parent) {
    double shape[8][3];
    Vec3<double> jacobian[3] = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};  // dx/dxi, dx/deta, dx/dzeta
    for (std::size_t i = 0; i < 8; ++i) {
      for (int d = 0; d < 3; ++d) {
        shape[i][d] = 0.125 * parent[i][d];
        for (int e = 0; e < 3; ++e) {
          if (e != d) shape[i][d] *= 1 + parent[i][e] * g * point[e];
        }
        jacobian[d] = jacobian[d] + shape[i][d] * x[i];
      }
    }
    const Vec3<double> cofactor[3] = {cross(jacobian[1], jacobian[2]), cross(jacobian[2], jacobian[0]),
                                      cross(jacobian[0], jacobian[1])};
    result.volume += dot(jacobian[0], cofactor[0]);
    for (std::size_t i = 0; i < 8; ++i) {
      for (int d = 0; d < 3; ++d) result.b[i] = result.b[i] + shape[i][d] * cofactor[d];
    }
  }
  return result;
}

template <class S>
HexahedronModes<S> modes(const Corners& x) {
  Vec3<S> value[8];
  for (std::size_t i = 0; i < 8; ++i) value[i] = {S(x[i].x), S(x[i].y), S(x[i].z)};
  return to_modes(value);
}
/// Modes of W hexahedra, lane i from x[i].
template <class T>
HexahedronModes<T> modes_from_lanes(const std::vector<Corners>& x) {
  Vec3<T> value[8];
  for (std::size_t k = 0; k < 8; ++k) {
    value[k] = vector_from_lanes<T>([&](int i) { return x[i][k]; });
  }
  return to_modes(value);
}

}  // namespace pinball::test
