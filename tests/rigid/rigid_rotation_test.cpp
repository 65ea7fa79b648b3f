#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>

#include <solver/rigid/rigid_rotation.hpp>

/// Rotation of rigid bodies, against Euler's equations as they are integrated here.
namespace pinball::rigid_rotation_test {
namespace {

using Matrix = Eigen::Matrix3d;
using Vector = Eigen::Vector3d;
using Quaternion = Eigen::Quaterniond;

const Matrix asymmetric = Vector(2, 3, 4).asDiagonal();
const Vector start(0.05, 9, 0.05);  // about the axis that is not stable, nearly

/// w' = J^-1 (J w x w) and q' = q (0, w)/2 in the axes of the body, by Runge and Kutta's method of fourth order.
Quaternion by_euler(const Matrix& inertia, Vector momentum, double time, int steps) {
  Quaternion q = Quaternion::Identity();
  Vector w = inertia.inverse() * momentum;
  const auto rate = [&](const Vector& v) { return Vector(inertia.inverse() * (inertia * v).cross(v)); };
  const auto turning = [](const Quaternion& o, const Vector& v) {
    return Eigen::Vector4d(0.5 * (o * Quaternion(0, v.x(), v.y(), v.z())).coeffs());
  };
  const double h = time / steps;
  for (int i = 0; i < steps; ++i) {
    const Vector w1 = rate(w), w2 = rate(w + h / 2 * w1), w3 = rate(w + h / 2 * w2), w4 = rate(w + h * w3);
    const auto at = [&](double part, const Eigen::Vector4d& slope) { return Quaternion(q.coeffs() + part * slope); };
    const Eigen::Vector4d q1 = turning(q, w), q2 = turning(at(h / 2, q1), w + h / 2 * w1),
                          q3 = turning(at(h / 2, q2), w + h / 2 * w2), q4 = turning(at(h, q3), w + h * w3);
    w += h / 6 * (w1 + 2 * w2 + 2 * w3 + w4);
    q.coeffs() += h / 6 * (q1 + 2 * q2 + 2 * q3 + q4);
    q.normalize();
  }
  return q;
}

Quaternion turned(double time, int steps) {
  Quaternion q = Quaternion::Identity();
  for (int i = 0; i < steps; ++i) q = turned_freely(q, asymmetric, asymmetric * start, time / steps);
  return q;
}

double angle(const Quaternion& a, const Quaternion& b) { return a.angularDistance(b); }

double energy(const Quaternion& q, const Vector& momentum) {
  const Vector p = q.conjugate() * momentum;
  return 0.5 * p.dot(asymmetric.inverse() * p);
}

TEST(RigidRotation, OfAnAsymmetricTopIsThatOfEulersEquations) {
  const double time = 4;  // in which it turns over
  const Quaternion exact = by_euler(asymmetric, asymmetric * start, time, 40000);
  ASSERT_LT(angle(exact, by_euler(asymmetric, asymmetric * start, time, 20000)), 1e-7);
  EXPECT_LT(angle(turned(time, 4000), exact), 1e-6);
}

TEST(RigidRotation, HasAnErrorOfFourthOrder) {
  const Quaternion exact = by_euler(asymmetric, asymmetric * start, 1, 40000);
  const double coarse = angle(turned(1, 50), exact), fine = angle(turned(1, 100), exact);
  EXPECT_GT(coarse / fine, 12);
  EXPECT_LT(coarse / fine, 20);
}

TEST(RigidRotation, KeepsTheEnergyOverManyTurns) {
  const Vector momentum = asymmetric * start;
  const double before = energy(Quaternion::Identity(), momentum);
  Quaternion q = Quaternion::Identity();
  for (int i = 0; i < 200000; ++i) {
    q = turned_freely(q, asymmetric, momentum, 0.01);
    if (i % 1000 == 0) {
      ASSERT_NEAR(energy(q, momentum) / before, 1, 1e-12) << i;
    }
  }
}

TEST(RigidRotation, GivesRatesAndKeepsTheMomentumAcross) {
  Matrix inertia;
  inertia << 3, 0.4, 0.2, 0.4, 2, -0.3, 0.2, -0.3, 4;
  const Vector momentum(1, 2, 3);
  for (int count = 0; count <= 3; ++count) {
    const std::array axes{Vector(0.6, 0.8, 0), Vector(-0.8, 0.6, 0), Vector(0, 0, 1)};
    const GivenAxes given = axes_of({axes.data(), static_cast<std::size_t>(count)});
    const Vector rates(0.5, -0.25, 2), motion = motion_with(given, rates, inertia, momentum);
    for (int k = 0; k < 3; ++k) {
      if (k < count) {
        EXPECT_NEAR(axes[k].dot(motion), rates[k], 1e-14);
      } else {
        EXPECT_NEAR(given.basis.col(k).dot(inertia * motion - momentum), 0, 1e-14);
      }
    }
    const Matrix mobility = mobility_across(given, inertia);
    EXPECT_LT((mobility * momentum - motion_with(given, Vector::Zero(), inertia, momentum)).norm(), 1e-14);
  }
}

TEST(RigidRotation, AboutOneAxisIsExact) {
  const std::array held{Vector(1, 0, 0), Vector(0, 1, 0)};
  Matrix inertia;
  inertia << 3, 0.4, 0.2, 0.4, 2, -0.3, 0.2, -0.3, 4;
  const Quaternion q = turned_about(axes_of(held), Vector::Zero(), Quaternion::Identity(), inertia, {0, 0, 2}, 0.8);
  EXPECT_LT(angle(q, Quaternion(Eigen::AngleAxisd(0.8 * 2 / 4, Vector::UnitZ()))), 1e-15);
}

}  // namespace
}  // namespace pinball::rigid_rotation_test
