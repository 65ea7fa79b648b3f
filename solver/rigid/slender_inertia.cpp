#include "slender_inertia.hpp"

#include <Eigen/Eigenvalues>

#include "eigen_points.hpp"

namespace pinball {

namespace {

/// Of the distances from a line to those along it, squared: nearer nodes are on it. Files give places to six digits.
constexpr double on_line = 1e-10;
/// Of the distances from the origin: places that are nearer to each other are one.
constexpr double in_point = 1e-14;

std::array<Point, 3> about_all_axes(double moment) { return {{{moment, 0, 0}, {0, moment, 0}, {0, 0, moment}}}; }

}  // namespace

Point SlenderInertia::moving(Point spin) const {
  if (idle.size() == 3) return {};
  for (const Point& axis : idle) {
    const double about = dot(axis, spin);
    for (std::size_t k = 0; k < 3; ++k) spin[k] -= about * axis[k];
  }
  return spin;
}

SlenderInertia slender_inertia(const std::array<Point, 3>& inertia, double mass, double far) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(eigen(inertia));
  const Eigen::Vector3d moments = principal.eigenvalues();  // ascending
  if (!(moments[2] > mass * in_point * in_point * far * far))
    return {about_all_axes(mass), {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  // whatever it is: no moment acts
  if (moments[0] > on_line * moments[2]) return {inertia, {}};
  return {about_all_axes(moments[2]), {point(principal.eigenvectors().col(0))}};
}

}  // namespace pinball
