#pragma once

#include "simd.hpp"

/// Vectors and tensors of the kernels, over any number type (scalar or pack).
namespace pinball {

template <class T>
struct Vec3 {
  T x, y, z;
};

template <class T>
PINBALL_FUNCTION Vec3<T> operator+(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
PINBALL_FUNCTION Vec3<T> operator-(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
PINBALL_FUNCTION Vec3<T> operator*(const T& s, const Vec3<T>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class T>
PINBALL_FUNCTION T dot(const Vec3<T>& a, const Vec3<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
PINBALL_FUNCTION Vec3<T> cross(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Symmetric tensor; shear components are tensor components (not engineering shears).
template <class T>
struct Symmetric {
  T xx, yy, zz, xy, yz, zx;
};

template <class T>
PINBALL_FUNCTION Symmetric<T> operator+(const Symmetric<T>& a, const Symmetric<T>& b) {
  return {a.xx + b.xx, a.yy + b.yy, a.zz + b.zz, a.xy + b.xy, a.yz + b.yz, a.zx + b.zx};
}
template <class T>
PINBALL_FUNCTION Symmetric<T> operator-(const Symmetric<T>& a, const Symmetric<T>& b) {
  return {a.xx - b.xx, a.yy - b.yy, a.zz - b.zz, a.xy - b.xy, a.yz - b.yz, a.zx - b.zx};
}
template <class T>
PINBALL_FUNCTION Symmetric<T> operator*(const T& s, const Symmetric<T>& a) {
  return {s * a.xx, s * a.yy, s * a.zz, s * a.xy, s * a.yz, s * a.zx};
}
template <class T>
PINBALL_FUNCTION T trace(const Symmetric<T>& a) {
  return a.xx + a.yy + a.zz;
}
/// a : b, the double contraction.
template <class T>
PINBALL_FUNCTION T contract(const Symmetric<T>& a, const Symmetric<T>& b) {
  return a.xx * b.xx + a.yy * b.yy + a.zz * b.zz + T(2) * (a.xy * b.xy + a.yz * b.yz + a.zx * b.zx);
}
template <class T>
PINBALL_FUNCTION Vec3<T> operator*(const Symmetric<T>& a, const Vec3<T>& v) {
  return {a.xx * v.x + a.xy * v.y + a.zx * v.z, a.xy * v.x + a.yy * v.y + a.yz * v.z,
          a.zx * v.x + a.yz * v.y + a.zz * v.z};
}

/// if (mask) a; else b, lane by lane.
template <class T>
PINBALL_FUNCTION Vec3<T> select(const MaskOf<T>& mask, const Vec3<T>& a, const Vec3<T>& b) {
  return {select(mask, a.x, b.x), select(mask, a.y, b.y), select(mask, a.z, b.z)};
}
template <class T>
PINBALL_FUNCTION Symmetric<T> select(const MaskOf<T>& mask, const Symmetric<T>& a, const Symmetric<T>& b) {
  return {select(mask, a.xx, b.xx), select(mask, a.yy, b.yy), select(mask, a.zz, b.zz),
          select(mask, a.xy, b.xy), select(mask, a.yz, b.yz), select(mask, a.zx, b.zx)};
}

/// General tensor by rows: L_ij = row i, component j.
template <class T>
struct Tensor {
  Vec3<T> row_x, row_y, row_z;
};

template <class T>
PINBALL_FUNCTION Vec3<T> operator*(const Tensor<T>& a, const Vec3<T>& v) {
  return {dot(a.row_x, v), dot(a.row_y, v), dot(a.row_z, v)};
}
/// Tensor plus symmetric tensor.
template <class T>
PINBALL_FUNCTION Tensor<T> operator+(const Tensor<T>& a, const Symmetric<T>& s) {
  return {{a.row_x.x + s.xx, a.row_x.y + s.xy, a.row_x.z + s.zx},
          {a.row_y.x + s.xy, a.row_y.y + s.yy, a.row_y.z + s.yz},
          {a.row_z.x + s.zx, a.row_z.y + s.yz, a.row_z.z + s.zz}};
}
template <class T>
PINBALL_FUNCTION Tensor<T> to_tensor(const Symmetric<T>& s) {
  return {{s.xx, s.xy, s.zx}, {s.xy, s.yy, s.yz}, {s.zx, s.yz, s.zz}};
}
template <class T>
PINBALL_FUNCTION Tensor<T> operator*(const T& s, const Tensor<T>& a) {
  return {s * a.row_x, s * a.row_y, s * a.row_z};
}
/// sym(L) = (L + L^T) / 2
template <class T>
PINBALL_FUNCTION Symmetric<T> symmetric_part(const Tensor<T>& a) {
  const T half = number<T>(0.5);
  return {a.row_x.x,
          a.row_y.y,
          a.row_z.z,
          half * (a.row_x.y + a.row_y.x),
          half * (a.row_y.z + a.row_z.y),
          half * (a.row_z.x + a.row_x.z)};
}
/// L + L^T
template <class T>
PINBALL_FUNCTION Symmetric<T> twice_symmetric_part(const Tensor<T>& a) {
  return {a.row_x.x + a.row_x.x, a.row_y.y + a.row_y.y, a.row_z.z + a.row_z.z,
          a.row_x.y + a.row_y.x, a.row_y.z + a.row_z.y, a.row_z.x + a.row_x.z};
}
/// Axial vector w of the skew part W = (L - L^T) / 2, so that W v = w x v.
template <class T>
PINBALL_FUNCTION Vec3<T> axial_vector(const Tensor<T>& a) {
  const T half = number<T>(0.5);
  return {half * (a.row_z.y - a.row_y.z), half * (a.row_x.z - a.row_z.x), half * (a.row_y.x - a.row_x.y)};
}

}  // namespace pinball
