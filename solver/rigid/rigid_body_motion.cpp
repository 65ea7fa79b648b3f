#include "rigid_body_motion.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "eigen_points.hpp"
#include "rigid_rotation.hpp"

namespace pinball {

namespace {

using Matrix = Eigen::Matrix3d;
using Vector = Eigen::Vector3d;
using Quaternion = Eigen::Quaterniond;

std::array<Point, 3> rows_of(const Matrix& m) { return {point(m.row(0)), point(m.row(1)), point(m.row(2))}; }

GivenAxes axes(const std::vector<Point>& directions) {
  std::array<Vector, 3> all;
  for (std::size_t k = 0; k < directions.size(); ++k) all[k] = eigen(directions[k]);
  return axes_of({all.data(), directions.size()});
}
Vector rates(const std::vector<double>& speeds) {
  Vector all = Vector::Zero();
  for (std::size_t k = 0; k < speeds.size(); ++k) all[static_cast<int>(k)] = speeds[k];
  return all;
}
Symmetric<double> symmetric(const Matrix& m) { return {m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(1, 2), m(2, 0)}; }

double largest_principal_value_of(const Matrix& m) {
  return Eigen::SelfAdjointEigenSolver<Matrix>(m, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff();
}

/// What changes the velocities along given directions to the given ones in a step.
Vector accelerations(const GivenAxes& along, const Vector& speeds, const Vector& velocity, double step) {
  return step > 0 ? Vector((speeds - along.basis.transpose() * velocity) / step) : Vector::Zero();
}

/// The part of a vector along given directions.
Vector part_along(const GivenAxes& along, const Vector& v) {
  Vector part = Vector::Zero();
  for (int k = 0; k < along.count; ++k) part += along.basis.col(k).dot(v) * along.basis.col(k);
  return part;
}

/// What turns a body as given about some axes while others turn it by `moment`, by Euler's equations
///
///     I a + w x I w = moment + reaction ,   reaction along the given axes, a along them as given ,
///
/// with the w of the time between both velocities. In the step w x I w acts as the body turns, not here.
/// before: angular velocity, rates: changes of the given ones [1/time^2]
Vector moment_about(const GivenAxes& about, const Vector& rates, const Matrix& inertia, const Vector& before,
                    double velocity_step, const Vector& moment) {
  if (about.count == 0) return Vector::Zero();
  const Vector w = before + 0.5 * velocity_step * motion_with(about, rates, inertia, moment);
  const Vector turning = w.cross(inertia * w);
  const Vector a = motion_with(about, rates, inertia, moment - turning);
  return part_along(about, inertia * a + turning - moment);
}

}  // namespace

RigidBodyMotion::RigidBodyMotion(double mass, const std::array<Point, 3>& inertia, const Point& centre)
    : mass_(mass), inertia_(inertia) {
  state_.centre = centre;
}

void RigidBodyMotion::set_velocities(const Point& velocity, const Point& angular_velocity) {
  state_.velocity = velocity;
  state_.angular_momentum = point(eigen(turned(inertia_)) * eigen(angular_velocity));
}

void RigidBodyMotion::obey(const GivenMotion& given) {
  for (std::size_t i = 0; i < given.along.size(); ++i) {
    const double excess = dot(state_.velocity, given.along[i]) - given.speeds[i];
    for (std::size_t k = 0; k < 3; ++k) state_.velocity[k] -= excess * given.along[i][k];
  }
  const Matrix inertia = eigen(turned(inertia_));
  const Vector momentum = eigen(state_.angular_momentum), spin = inertia.inverse() * momentum;
  double most = 0;
  for (std::size_t i = 0; i < given.about.size(); ++i)
    most = std::max(most, std::abs(spin.dot(eigen(given.about[i])) - given.angular_speeds[i]));
  if (!(most > 1e-12 * spin.norm())) return;  // but for rounding it obeys
  const Vector obeying = motion_with(axes(given.about), rates(given.angular_speeds), inertia, momentum);
  state_.angular_momentum = point(inertia * obeying);
}

std::array<Point, 3> RigidBodyMotion::rotation() const { return rows_of(eigen(state_.orientation).toRotationMatrix()); }

std::array<Point, 3> RigidBodyMotion::turned(const std::array<Point, 3>& tensor) const {
  const Matrix r = eigen(state_.orientation).toRotationMatrix();
  return rows_of(r * eigen(tensor) * r.transpose());
}

/// With the quaternion (s, v) between both orientations their rotation is 1 + 2 s [v] + 2 [v]^2, [v] r = v x r. Written
/// so, nothing of a small angle is lost beside the one.
RowTensor RigidBodyMotion::way_beside(const RigidState& other, double dt, const Point& w) const {
  RowTensor rows{};
  if (dt == 0) return rows;
  Quaternion turn = Quaternion::Identity();
  if (other.orientation != state_.orientation) turn = eigen(other.orientation) * eigen(state_.orientation).conjugate();
  const Matrix v = skew(turn.vec());
  const Matrix beside = 2 / dt * (turn.w() * v + v * v) - skew(eigen(w));
  for (int i = 0; i < 3; ++i) rows[i] = {beside(i, 0), beside(i, 1), beside(i, 2)};
  return rows;
}

void RigidBodyMotion::begin(const GivenMotion& given) {
  now_ = turned(inertia_);
  const Matrix inverse = eigen(now_).inverse();
  inverse_now_ = rows_of(inverse);
  angular_velocity_ = point(inverse * eigen(state_.angular_momentum));
  const Matrix translation = mobility_across(axes(given.along), mass_ * Matrix::Identity());
  const Matrix rotation = mobility_across(axes(given.about), eigen(now_));
  side_ = {{state_.centre[0], state_.centre[1], state_.centre[2]}, symmetric(translation), symmetric(rotation), 0, 0};
  side_.most_translation = given.along.size() < 3 ? 1 / mass_ : 0.0;
  side_.most_rotation = given.about.size() < 3 ? largest_principal_value_of(rotation) : 0.0;
}

void RigidBodyMotion::load(const Wrench& wrench, const GivenMotion& given, double velocity_step) {
  wrench_ = wrench;
  const GivenAxes along = axes(given.along), about = axes(given.about);
  const Vector faster = accelerations(along, rates(given.speeds), eigen(state_.velocity), velocity_step);
  const Vector turning = accelerations(about, rates(given.angular_speeds), eigen(angular_velocity_), velocity_step);
  const Vector force = eigen(wrench.force), moment = eigen(wrench.moment);
  const Vector a = motion_with(along, faster, mass_ * Matrix::Identity(), force);
  const Vector b = motion_with(about, turning, eigen(now_), moment);
  acceleration_ = point(a);
  angular_acceleration_ = point(b);
  reaction_ = {point(part_along(along, mass_ * a - force)), point(part_along(about, eigen(now_) * b - moment))};
  state_.reaction = {reaction_.force,
                     point(moment_about(about, turning, eigen(now_), eigen(angular_velocity_), velocity_step, moment))};
}

/// Where speeds about axes are given the inertia about them may change as the body turns, and with it the energy: the
/// work of the reaction within the step. (Where they are held, that is of the order of what the midpoint rule leaves.)
ExternalWork RigidBodyMotion::move(const GivenMotion& given, const StepLengths& step) {
  const double h = step.velocity();
  ExternalWork work;
  const Point before = angular_velocity_;
  for (std::size_t k = 0; k < 3; ++k) {
    const double faster = state_.velocity[k] + h * acceleration_[k];
    work.join(work_of(reaction_.force[k], state_.velocity[k], faster, step));
    work.join(work_of(reaction_.moment[k], before[k], before[k] + h * angular_acceleration_[k], step));
    state_.velocity[k] = faster;
    state_.angular_momentum[k] += h * (wrench_.moment[k] + reaction_.moment[k]);
    state_.centre[k] += step.after * faster;
  }
  const Quaternion orientation = eigen(state_.orientation);
  const Matrix inertia = eigen(inertia_);
  const Vector momentum = eigen(state_.angular_momentum);
  Quaternion turned_to = orientation;
  if (given.about.empty()) {
    turned_to = turned_freely(orientation, inertia, momentum, step.after);
  } else if (step.after > 0) {
    turned_to =
        turned_about(axes(given.about), rates(given.angular_speeds), orientation, inertia, momentum, step.after);
  }
  state_.orientation = {turned_to.w(), turned_to.x(), turned_to.y(), turned_to.z()};
  if (given.about.empty() || !(step.after > 0)) return work;
  const double twice_before = momentum.dot(eigen(inverse_now_) * momentum);
  const Matrix now = eigen(turned(inertia_));
  const Vector rate = motion_with(axes(given.about), rates(given.angular_speeds), now, momentum);
  state_.angular_momentum = point(now * rate);
  const bool driven =
      std::any_of(given.angular_speeds.begin(), given.angular_speeds.end(), [](double speed) { return speed != 0; });
  if (driven) work.later += 0.5 * (rate.dot(now * rate) - twice_before);
  return work;
}

}  // namespace pinball
