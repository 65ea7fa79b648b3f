#pragma once

#include <Eigen/Geometry>
#include <array>

#include <kernels/tensor.hpp>
#include <solver/base/point.hpp>

/// Points and tensors of the house as those of Eigen, and back.
namespace pinball {

inline Eigen::Vector3d eigen(const Point& p) { return {p[0], p[1], p[2]}; }
inline Point point(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

inline Eigen::Matrix3d eigen(const std::array<Point, 3>& rows) {
  Eigen::Matrix3d m;
  for (int i = 0; i < 3; ++i) m.row(i) = eigen(rows[i]);
  return m;
}
/// w, x, y, z
inline Eigen::Quaterniond eigen(const std::array<double, 4>& q) { return {q[0], q[1], q[2], q[3]}; }

/// [w] r = w x r
inline Eigen::Matrix3d skew(const Eigen::Vector3d& w) {
  Eigen::Matrix3d m;
  m << 0, -w.z(), w.y(), w.z(), 0, -w.x(), -w.y(), w.x(), 0;
  return m;
}

inline Eigen::Matrix3d eigen(const Symmetric<double>& s) {
  Eigen::Matrix3d m;
  m << s.xx, s.xy, s.zx, s.xy, s.yy, s.yz, s.zx, s.yz, s.zz;
  return m;
}

}  // namespace pinball
