#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>
#include <vector>

#include <kernels/contact_impulse.hpp>

namespace pinball {
namespace {

constexpr int node_count = 7;

struct System {
  std::vector<ImpulseNode> nodes;
  std::vector<ImpulseRow> rows;
};

/// Rows between random nodes in random directions; `repeated`: the last row stands twice, as redundant rows do;
/// `held`: one node is, along y.
System random_system(std::mt19937& random, int rows, bool repeated, bool held = true) {
  std::uniform_real_distribution<double> number(-1, 1);
  System s;
  for (int n = 0; n < node_count; ++n) {
    ImpulseNode node{};
    const double inverse_mass = 1.5 + number(random);
    for (int c = 0; c < 3; ++c) {
      node.velocity[c] = number(random);
      node.inverse_mass[c] = inverse_mass;
    }
    if (n == 0 && held) node.inverse_mass[1] = 0;
    s.nodes.push_back(node);
  }
  for (int i = 0; i < rows; ++i) {
    ImpulseRow row{};
    row.nodes = 4;
    Eigen::Vector3d a(number(random), number(random), number(random));
    a.normalize();
    for (int k = 0; k < 4; ++k) {
      row.node[k] = (i + k * (1 + i % 2)) % node_count;
      row.weight[k] = k < 2 ? -0.5 : 0.5;
    }
    for (int c = 0; c < 3; ++c) row.direction[c] = a[c];
    row.position_rate = 0.2 * number(random);
    s.rows.push_back(row);
  }
  if (repeated) s.rows.push_back(s.rows.back());
  for (ImpulseRow& row : s.rows) load_masses(row, s.nodes.data());
  return s;
}

Eigen::VectorXd velocities(const System& s) {
  Eigen::VectorXd v(3 * node_count);
  for (int n = 0; n < node_count; ++n) {
    for (int c = 0; c < 3; ++c) v[3 * n + c] = s.nodes[static_cast<std::size_t>(n)].velocity[c];
  }
  return v;
}

/// The velocities that close no gap, by a direct solution of the active rows for every choice of them.
Eigen::VectorXd direct_solution(const System& s) {
  const int rows = static_cast<int>(s.rows.size());
  Eigen::MatrixXd G = Eigen::MatrixXd::Zero(rows, 3 * node_count);
  Eigen::MatrixXd mobility = Eigen::MatrixXd::Zero(3 * node_count, 3 * node_count);
  Eigen::VectorXd r(rows);
  for (int i = 0; i < rows; ++i) {
    const ImpulseRow& row = s.rows[static_cast<std::size_t>(i)];
    for (int k = 0; k < row.nodes; ++k) {
      for (int c = 0; c < 3; ++c) G(i, 3 * row.node[k] + c) += row.weight[k] * row.direction[c];
    }
    r[i] = row.position_rate;
  }
  for (int n = 0; n < node_count; ++n) {
    for (int c = 0; c < 3; ++c) mobility(3 * n + c, 3 * n + c) = s.nodes[static_cast<std::size_t>(n)].inverse_mass[c];
  }
  const Eigen::VectorXd v = velocities(s);
  for (int active = 0; active < 1 << rows; ++active) {
    std::vector<int> chosen;
    for (int i = 0; i < rows; ++i) {
      if ((active >> i & 1) != 0) chosen.push_back(i);
    }
    Eigen::VectorXd p = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(chosen.size()));
    Eigen::VectorXd after = v;
    if (!chosen.empty()) {
      const Eigen::MatrixXd some = G(chosen, Eigen::all);
      const Eigen::MatrixXd delassus = some * mobility * some.transpose();
      const Eigen::VectorXd closing = some * v + Eigen::VectorXd(r(chosen));
      p = delassus.completeOrthogonalDecomposition().solve(closing);
      after = v - mobility * some.transpose() * p;
    }
    if ((p.size() == 0 || p.minCoeff() > -1e-10) && (G * after + r).maxCoeff() < 1e-10) return after;
  }
  ADD_FAILURE() << "no set of active rows solves the system";
  return v;
}

TEST(ContactImpulse, SweepsFindTheDirectSolution) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 200; ++trial) {
    System s = random_system(random, 1 + trial % 6, trial % 3 == 0);
    const Eigen::VectorXd expected = direct_solution(s);
    for (int sweep = 0; sweep < 10000; ++sweep) {
      if (gauss_seidel_sweep(s.rows.data(), static_cast<std::int64_t>(s.rows.size()), s.nodes.data()) < 1e-13) break;
    }
    EXPECT_LT((velocities(s) - expected).norm(), 1e-9) << "trial " << trial;
    for (const ImpulseRow& row : s.rows) EXPECT_GE(row.impulse, 0);
  }
}

TEST(ContactImpulse, SweepsDoNotMindWhereTheyBegin) {
  std::mt19937 random(8);
  System s = random_system(random, 5, true);
  const Eigen::VectorXd expected = direct_solution(s);
  for (ImpulseRow& row : s.rows) {
    row.impulse = 0.3;
    apply_impulse(row, row.impulse, s.nodes.data());
  }
  for (int sweep = 0; sweep < 10000; ++sweep) gauss_seidel_sweep(s.rows.data(), 6, s.nodes.data());
  EXPECT_LT((velocities(s) - expected).norm(), 1e-9);
}

TEST(ContactImpulse, ProjectionTakesOutEnergyAndKeepsMomentum) {
  std::mt19937 random(9);
  for (int trial = 0; trial < 200; ++trial) {
    System s = random_system(random, 1 + trial % 6, trial % 3 == 0, false);
    for (ImpulseRow& row : s.rows) row.position_rate = 0;
    const auto sums = [&s] {
      std::array<double, 4> sum{};
      for (const ImpulseNode& node : s.nodes) {
        for (std::size_t c = 0; c < 3; ++c) {
          sum[c] += node.velocity[c] / node.inverse_mass[0];
          sum[3] += 0.5 * node.velocity[c] * node.velocity[c] / node.inverse_mass[0];
        }
      }
      return sum;
    };
    const std::array<double, 4> before = sums();
    project_velocities(s.rows.data(), static_cast<std::int64_t>(s.rows.size()), s.nodes.data());
    const std::array<double, 4> after = sums();
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(after[c], before[c], 1e-14);
    EXPECT_LE(after[3], before[3] * (1 + 1e-15));
  }
}

TEST(ContactImpulse, ProjectionOfEqualRowsIsExact) {
  // Two rows that share all their nodes: each gives half of the impulse.
  std::mt19937 random(10);
  System s = random_system(random, 1, true, false);
  for (ImpulseRow& row : s.rows) row.position_rate = 5;  // surely closing
  project_velocities(s.rows.data(), 2, s.nodes.data());
  EXPECT_GT(s.rows[0].impulse, 0);
  EXPECT_EQ(s.rows[0].impulse, s.rows[1].impulse);
  EXPECT_NEAR(closing_rate(s.rows[0], s.nodes.data()), -5, 1e-14);
}

}  // namespace
}  // namespace pinball
