#pragma once

#include <Eigen/QR>
#include <cmath>
#include <cstdint>
#include <vector>

#include "eigen_points.hpp"
#include "joint_rows.hpp"

namespace pinball {

/// Velocities of a body, or changes of them.
struct Twist {
  Point velocity{};          ///< [length/time]
  Point angular_velocity{};  ///< [1/time]
};

/// K = G M^-1 G^T of the rows of joints that hang together, and what is asked of it. Rows are brought to K_ii = 1; what
/// is left of a row after those before it counts as nothing below 1e-10, and so does K_ii below that part of what
/// bodies would have that move in all directions as they do in their easiest: what holds them leaves that to rounding.
class JointSystem {
 public:
  struct Row {
    std::int32_t first, second;  ///< bodies; -1: the ground
    RowGradient gradient;
  };
  void add(const Row& row) { rows_.push_back(row); }
  /// side(body): its mobility.
  template <class Side>
  void decompose(const Side& side);

  std::int64_t size() const { return std::ssize(rows_); }
  const RowGradient& gradient(std::int64_t row) const { return rows_[row].gradient; }
  /// K^+ rates
  Eigen::VectorXd solve(const Eigen::VectorXd& rates) const {
    return scale_.cwiseProduct(Eigen::VectorXd(inverse_.solve(scale_.cwiseProduct(rates))));
  }
  /// G v
  Eigen::VectorXd rates(const std::vector<Twist>& twists) const;
  /// Adds factor G^T impulses to the wrenches of the bodies.
  void add_wrenches(const Eigen::VectorXd& impulses, double factor, std::vector<Wrench>& wrench) const;

 private:
  std::vector<Row> rows_;
  Eigen::VectorXd scale_;  ///< 1/sqrt(K_ii); 0: nothing moves along the row
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> inverse_;
};

/// K_ii of a body that moves in all directions as it does in its easiest.
inline double most_of(const RigidSide& side, const RowGradient& gradient, bool is_first) {
  return gradient.force.squaredNorm() * side.most_translation +
         (is_first ? gradient.first : gradient.second).squaredNorm() * side.most_rotation;
}

template <class Side>
void JointSystem::decompose(const Side& side) {
  constexpr double nothing = 1e-10;
  Eigen::MatrixXd k(size(), size());
  Eigen::VectorXd most = Eigen::VectorXd::Zero(size());
  for (std::int64_t i = 0; i < size(); ++i) {
    for (std::int64_t j = 0; j < size(); ++j) {
      double sum = 0;
      for (const bool of_first_i : {true, false}) {
        const std::int32_t body = of_first_i ? rows_[i].first : rows_[i].second;
        if (body < 0) continue;
        if (i == j) most[i] += most_of(side(body), rows_[i].gradient, of_first_i);
        for (const bool of_first_j : {true, false}) {
          if (body != (of_first_j ? rows_[j].first : rows_[j].second)) continue;
          const RowGradient &a = rows_[i].gradient, &b = rows_[j].gradient;
          const double sign = of_first_i == of_first_j ? 1 : -1;
          sum += sign * a.force.dot(eigen(side(body).translation) * b.force) +
                 (of_first_i ? a.first : a.second).dot(eigen(side(body).rotation) * (of_first_j ? b.first : b.second));
        }
      }
      k(i, j) = sum;
    }
  }
  scale_ = k.diagonal().binaryExpr(
      most, [](double own, double of_all) { return own > nothing * of_all ? 1 / std::sqrt(own) : 0.0; });
  inverse_.setThreshold(nothing);
  inverse_.compute(scale_.asDiagonal() * k * scale_.asDiagonal());
}

inline Eigen::VectorXd JointSystem::rates(const std::vector<Twist>& twists) const {
  Eigen::VectorXd all = Eigen::VectorXd::Zero(size());
  for (std::int64_t i = 0; i < size(); ++i) {
    const RowGradient& gradient = rows_[i].gradient;
    if (const std::int32_t a = rows_[i].first; a >= 0)
      all[i] += gradient.first.dot(eigen(twists[a].angular_velocity)) - gradient.force.dot(eigen(twists[a].velocity));
    if (const std::int32_t b = rows_[i].second; b >= 0)
      all[i] += gradient.second.dot(eigen(twists[b].angular_velocity)) + gradient.force.dot(eigen(twists[b].velocity));
  }
  return all;
}

inline void JointSystem::add_wrenches(const Eigen::VectorXd& impulses, double factor,
                                      std::vector<Wrench>& wrench) const {
  for (std::int64_t i = 0; i < size(); ++i) {
    const RowGradient& gradient = rows_[i].gradient;
    const double size = factor * impulses[i];
    if (const std::int32_t a = rows_[i].first; a >= 0)
      wrench[a].join({point(-size * gradient.force), point(size * gradient.first)});
    if (const std::int32_t b = rows_[i].second; b >= 0)
      wrench[b].join({point(size * gradient.force), point(size * gradient.second)});
  }
}

}  // namespace pinball
