#include "rigid_rotation.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "eigen_points.hpp"

namespace pinball {

namespace {

using Matrix = Eigen::Matrix3d;
using Vector = Eigen::Vector3d;
using Quaternion = Eigen::Quaterniond;

constexpr int most_iterations = 50;

Quaternion rotation_by(const Vector& angle) {
  const double size = angle.norm(), half = 0.5 * size;
  const double factor = size > 1e-8 ? std::sin(half) / size : 0.5;
  return {std::cos(half), factor * angle.x(), factor * angle.y(), factor * angle.z()};
}

/// One substep. The mean momentum P solves P = Pi_0 + h/2 P x J^-1 P, by Newton's method.
Quaternion substep(const Quaternion& orientation, const Matrix& inverse_inertia, const Vector& momentum, double h) {
  const Vector begin = orientation.conjugate() * momentum;
  Vector mean = begin;
  for (int i = 0; i < most_iterations; ++i) {
    const Vector rate = inverse_inertia * mean;
    const Vector wrong = mean - begin - 0.5 * h * mean.cross(rate);
    const Matrix slope = Matrix::Identity() - 0.5 * h * (skew(mean) * inverse_inertia - skew(rate));
    const Vector change = slope.partialPivLu().solve(wrong);
    mean -= change;
    if (change.norm() <= 1e-15 * begin.norm()) break;
  }
  const Vector half = 0.5 * h * (inverse_inertia * mean);
  return (orientation * Quaternion(1, half.x(), half.y(), half.z())).normalized();
}

/// Rows of the system of motion_with().
Matrix rows_of(const GivenAxes& axes, const Matrix& m) {
  Matrix rows;
  for (int k = 0; k < 3; ++k) {
    const Vector along = axes.basis.col(k);
    rows.row(k) = k < axes.count ? Vector(along) : Vector(m * along);
  }
  return rows;
}

Matrix in_space(const Quaternion& orientation, const Matrix& inertia) {
  const Matrix r = orientation.toRotationMatrix();
  return r * inertia * r.transpose();
}

}  // namespace

Quaternion turned_freely(const Quaternion& orientation, const Matrix& inertia, const Vector& momentum, double dt) {
  if (momentum.isZero(0) || dt == 0) return orientation;
  const Matrix inverse = inertia.inverse();
  const double outer = 1 / (2 - std::cbrt(2.0)), inner = 1 - 2 * outer;
  Quaternion turned = orientation;
  for (const double part : {outer, inner, outer}) turned = substep(turned, inverse, momentum, part * dt);
  return turned;
}

GivenAxes axes_of(std::span<const Vector> orthonormal) {
  GivenAxes axes;
  for (const Vector& axis : orthonormal) axes.basis.col(axes.count++) = axis;
  int found = axes.count;
  for (int k = 0; k < 3 && found < 3; ++k) {
    Vector rest = Vector::Unit(k);
    for (int turn = 0; turn < 2; ++turn) {
      for (int i = 0; i < found; ++i) rest -= axes.basis.col(i).dot(rest) * axes.basis.col(i);
    }
    if (rest.norm() > 0.3) axes.basis.col(found++) = rest.normalized();
  }
  return axes;
}

Vector motion_with(const GivenAxes& axes, const Vector& rates, const Matrix& m, const Vector& load) {
  Vector right = axes.basis.transpose() * load;
  for (int k = 0; k < axes.count; ++k) right[k] = rates[k];
  return rows_of(axes, m).partialPivLu().solve(right);
}

Matrix mobility_across(const GivenAxes& axes, const Matrix& m) {
  Matrix right = axes.basis.transpose();
  for (int k = 0; k < axes.count; ++k) right.row(k).setZero();
  const Matrix mobility = rows_of(axes, m).partialPivLu().solve(right);
  return 0.5 * (mobility + mobility.transpose());
}

Quaternion turned_about(const GivenAxes& axes, const Vector& rates, const Quaternion& orientation,
                        const Matrix& inertia, const Vector& momentum, double dt) {
  Vector rate = motion_with(axes, rates, in_space(orientation, inertia), momentum);
  for (int i = 0; i < most_iterations && axes.count < 3; ++i) {
    const Quaternion middle = rotation_by(0.5 * dt * rate) * orientation;
    const Vector better = motion_with(axes, rates, in_space(middle, inertia), momentum);
    const double change = (better - rate).norm();
    rate = better;
    if (change <= 1e-15 * rate.norm()) break;
  }
  return (rotation_by(dt * rate) * orientation).normalized();
}

}  // namespace pinball
