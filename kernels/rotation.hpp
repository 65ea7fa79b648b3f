#pragma once

#include "simd.hpp"
#include "tensor.hpp"

/// Incremental rotation of Hughes and Winget (1980): with the spin W dt of the mid-step configuration,
///
///     Q = (I - W dt/2)^-1 (I + W dt/2),
///
/// orthogonal to round-off for any step, and exact in direction; a rigid turn by theta seen through the mid-step
/// geometry has W dt = 2 tan(theta/2), so that Q is the exact rotation. Closed form with the axial vector h of W dt/2:
/// Q = I + 2/(1 + h.h) (H + H^2), H v = h x v.
namespace pinball {

template <class T>
struct Rotation {
  Tensor<T> q;
};

/// h: axial vector of W dt/2 [rad].
template <class T>
PINBALL_FUNCTION Rotation<T> rotation_of_half_spin(const Vec3<T>& h) {
  const T s = T(2) / (T(1) + dot(h, h));
  const Vec3<T> sh = s * h;
  const T sxx = sh.x * h.x, syy = sh.y * h.y, szz = sh.z * h.z;
  const T sxy = sh.x * h.y, syz = sh.y * h.z, szx = sh.z * h.x;
  return {{{T(1) - syy - szz, sxy - sh.z, szx + sh.y},
           {sxy + sh.z, T(1) - szz - sxx, syz - sh.x},
           {szx - sh.y, syz + sh.x, T(1) - sxx - syy}}};
}

/// spin: axial vector of W dt (rotation vector of the step to first order) [rad].
template <class T>
PINBALL_FUNCTION Rotation<T> hughes_winget_rotation(const Vec3<T>& spin) {
  return rotation_of_half_spin(number<T>(0.5) * spin);
}

template <class T>
PINBALL_FUNCTION Vec3<T> rotate(const Rotation<T>& r, const Vec3<T>& v) {
  return r.q * v;
}

/// Q sigma Q^T
template <class T>
PINBALL_FUNCTION Symmetric<T> rotate(const Rotation<T>& r, const Symmetric<T>& s) {
  const Vec3<T> a = s * r.q.row_x, b = s * r.q.row_y, c = s * r.q.row_z;  // columns of sigma Q^T
  return {dot(r.q.row_x, a), dot(r.q.row_y, b), dot(r.q.row_z, c),
          dot(r.q.row_x, b), dot(r.q.row_y, c), dot(r.q.row_z, a)};
}

}  // namespace pinball
