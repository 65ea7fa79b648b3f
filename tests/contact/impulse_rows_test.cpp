#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>
#include <utility>
#include <vector>

#include <kernels/exec.hpp>
#include <solver/contact/impulses/pair_names.hpp>
#include <tests/support/impulse_system.hpp>

namespace pinball::impulse_rows_test {
namespace {

using test::ImpulseSystem;

constexpr int node_count = 7;

/// Rows between random nodes in random directions; `repeated`: the last row stands twice, as redundant rows do;
/// `held`: one node is, along y.
ImpulseSystem random_system(std::mt19937& random, int rows, bool repeated, bool held = true) {
  std::uniform_real_distribution<double> number(-1, 1);
  ImpulseSystem s;
  for (int n = 0; n < node_count; ++n) {
    const double inverse_mass = 1.5 + number(random);
    const Vec3<double> v{number(random), number(random), number(random)};
    s.add_node(v, inverse_mass, n == 0 && held);
  }
  for (int i = 0; i < rows; ++i) {
    Eigen::Vector3d a(number(random), number(random), number(random));
    a.normalize();
    const double rate = 0.2 * number(random);
    for (int times = repeated && i + 1 == rows ? 2 : 1; times > 0; --times) {
      s.add_row({a[0], a[1], a[2]}, rate);
      for (int k = 0; k < 4; ++k) s.add_entry((i + k * (1 + i % 2)) % node_count, k < 2 ? -0.5 : 0.5);
    }
  }
  return s;
}

Eigen::VectorXd velocities(const ImpulseSystem& s) {
  Eigen::VectorXd v(3 * node_count);
  for (int n = 0; n < node_count; ++n) {
    for (int c = 0; c < 3; ++c) v[3 * n + c] = s.velocity(n)[c];
  }
  return v;
}

struct DirectSolution {
  Eigen::VectorXd impulses, velocities;
};

/// By a direct solution of the active rows for every choice of them.
DirectSolution direct_solution(const ImpulseSystem& s) {
  const int rows = static_cast<int>(s.rows.size());
  Eigen::MatrixXd G = Eigen::MatrixXd::Zero(rows, 3 * node_count), sizes = Eigen::MatrixXd::Zero(rows, node_count);
  Eigen::MatrixXd mobility = Eigen::MatrixXd::Zero(3 * node_count, 3 * node_count);
  Eigen::VectorXd r(rows), a2(rows);
  for (int n = 0; n < node_count; ++n) {
    for (int c = 0; c < 3; ++c) mobility(3 * n + c, 3 * n + c) = s.nodes[static_cast<std::size_t>(n)].inverse_mass[c];
  }
  for (int i = 0; i < rows; ++i) {
    const RowView row = s.rows[static_cast<std::size_t>(i)];
    for (int k = 0; k < row.nodes; ++k) {
      for (int c = 0; c < 3; ++c) G(i, 3 * row.node[k] + c) += row.weight[k] * row.direction[c];
      sizes(i, row.node[k]) += std::abs(row.weight[k]);
    }
    r[i] = s.rows.rows[static_cast<std::size_t>(i)].position_rate;
  }
  constexpr double e = ImpulseIterations::softness;
  Eigen::MatrixXd system = (1 - e) * G * mobility * G.transpose();
  for (int i = 0; i < rows; ++i) {
    const double* a = s.rows[static_cast<std::size_t>(i)].direction;
    for (int n = 0; n < node_count; ++n) {
      double along = 0;
      for (int c = 0; c < 3; ++c) along += a[c] * a[c] * mobility(3 * n + c, 3 * n + c);
      system(i, i) += e * sizes(i, n) * sizes.col(n).sum() * along;
    }
  }
  const Eigen::VectorXd closing = G * velocities(s) + r;
  for (int active = 0; active < 1 << rows; ++active) {
    std::vector<int> chosen;
    for (int i = 0; i < rows; ++i) {
      if ((active >> i & 1) != 0) chosen.push_back(i);
    }
    Eigen::VectorXd p = Eigen::VectorXd::Zero(rows);
    if (!chosen.empty()) {
      const Eigen::MatrixXd some = system(chosen, chosen);
      const Eigen::VectorXd of_some = some.ldlt().solve(Eigen::VectorXd(closing(chosen)));
      p(chosen) = of_some;
    }
    if (p.minCoeff() > -1e-10 && (closing - system * p).maxCoeff() < 1e-10)
      return {p, velocities(s) - mobility * G.transpose() * p};
  }
  ADD_FAILURE() << "no set of active rows solves the system";
  return {Eigen::VectorXd::Zero(rows), velocities(s)};
}

/// Impulses are known from velocities but for what the compliance divides.
void expect_solved(const ImpulseSystem& s, const DirectSolution& expected, int trial) {
  EXPECT_LT((velocities(s) - expected.velocities).norm(), 1e-9) << "trial " << trial;
  for (std::size_t i = 0; i < s.rows.size(); ++i) {
    EXPECT_NEAR(s.impulse(i), expected.impulses[static_cast<Eigen::Index>(i)], 1e-9 / ImpulseIterations::softness)
        << "trial " << trial << ", row " << i;
    EXPECT_GE(s.impulse(i), 0);
  }
}

TEST(ContactImpulse, IterationsFindTheDirectSolution) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 200; ++trial) {
    ImpulseSystem s = random_system(random, 1 + trial % 6, trial % 3 == 0);
    const DirectSolution expected = direct_solution(s);
    s.build();
    EXPECT_TRUE(s.solve().converged);
    expect_solved(s, expected, trial);
  }
}

TEST(ContactImpulse, IterationsDoNotMindWhereTheyBegin) {
  std::mt19937 random(8);
  for (int trial = 0; trial < 20; ++trial) {
    ImpulseSystem s = random_system(random, 5, true);
    const DirectSolution expected = direct_solution(s);
    for (ImpulseRow& row : s.rows.rows) row.impulse = 0.3 * trial;
    s.build();
    EXPECT_TRUE(s.solve().converged);
    expect_solved(s, expected, trial);
  }
}

/// The direction with which a row is added may have any length, as that of balls has: nodes move as they do otherwise.
TEST(ContactImpulse, DirectionsMayHaveAnyLength) {
  std::mt19937 random(13);
  for (int trial = 0; trial < 60; ++trial) {
    std::mt19937 same = random;
    ImpulseSystem unit = random_system(same, 1 + trial % 6, trial % 3 == 0);
    ImpulseSystem s = random_system(random, 1 + trial % 6, trial % 3 == 0);
    for (std::size_t i = 0; i < s.rows.size(); ++i) {
      const double length = 0.2 + 0.7 * static_cast<double>(i);
      ImpulseRow& row = s.rows.rows[i];
      for (double& a : row.direction) a *= length;
      row.position_rate *= length;
    }
    const double mu = trial % 2 == 0 ? -1 : 0.3;
    for (ImpulseSystem* system : {&unit, &s}) system->build(mu);
    if (trial % 4 < 2) {
      for (ImpulseSystem* system : {&unit, &s}) system->solve();
    } else {
      for (ImpulseSystem* system : {&unit, &s}) system->iterations.project(system->system, system->velocities.data());
    }
    EXPECT_LT((velocities(s) - velocities(unit)).norm(), 1e-9) << "trial " << trial;
    for (std::size_t i = 0; i < s.rows.size(); ++i) {
      const double length = 0.2 + 0.7 * static_cast<double>(i);
      EXPECT_NEAR(s.impulse(i) * length, unit.impulse(i), 1e-9 / ImpulseIterations::softness) << i;
    }
  }
}

/// Rows that are the same share the impulse, and close what one of them alone would.
TEST(ContactImpulse, IterationsShareOutAmongEqualRowsExactly) {
  std::mt19937 random(10);
  ImpulseSystem s = random_system(random, 1, true, false);
  for (ImpulseRow& row : s.rows.rows) row.position_rate = 5;  // surely closing
  s.build();
  s.solve();
  EXPECT_GT(s.impulse(0), 0);
  EXPECT_DOUBLE_EQ(s.impulse(0), s.impulse(1));
  EXPECT_NEAR(s.closing(0), -5, 1e-12);
}

TEST(ContactImpulse, ProjectionTakesOutEnergyAndKeepsMomentum) {
  std::mt19937 random(9);
  for (int trial = 0; trial < 200; ++trial) {
    ImpulseSystem s = random_system(random, 1 + trial % 6, trial % 3 == 0, false);
    for (ImpulseRow& row : s.rows.rows) row.position_rate = 0;
    s.build();
    const Vec3<double> before = s.momentum();
    const double energy = s.kinetic_energy();
    s.iterations.project(s.system, s.velocities.data());
    const Vec3<double> change = s.momentum() - before;
    EXPECT_LT(std::sqrt(dot(change, change)), 2e-14);
    EXPECT_LE(s.kinetic_energy(), energy * (1 + 1e-15));
  }
}

TEST(ContactImpulse, ProjectionOfEqualRowsIsExact) {
  // Two rows that share all their nodes: each gives half of the impulse.
  std::mt19937 random(10);
  ImpulseSystem s = random_system(random, 1, true, false);
  for (ImpulseRow& row : s.rows.rows) row.position_rate = 5;  // surely closing
  s.build();
  s.iterations.project(s.system, s.velocities.data());
  EXPECT_GT(s.impulse(0), 0);
  EXPECT_EQ(s.impulse(0), s.impulse(1));
  EXPECT_NEAR(s.closing(0), -5, 1e-14);
}

/// Rows that share no node, of 2 to 16 nodes each, held ones among them: each does what it does by itself.
TEST(ContactImpulse, IslandsDoWhatTheyDoAlone) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> number(-1, 1);
  for (const int count : {1, 7, 31, 600}) {
    ImpulseSystem s;
    std::vector<ImpulseSystem> alone(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
      const int half = 1 + i % 8;
      Eigen::Vector3d a(number(random), number(random), number(random));
      a.normalize();
      ImpulseSystem& one = alone[static_cast<std::size_t>(i)];
      for (ImpulseSystem* system : {&s, &one}) system->add_row({a[0], a[1], a[2]}, 0.1);
      for (int k = 0; k < 2 * half; ++k) {
        const Vec3<double> v{number(random), number(random), number(random)};
        const double inverse_mass = 1.5 + number(random);
        for (ImpulseSystem* system : {&s, &one}) {
          system->add_node(v, inverse_mass, i % 3 == 0 && k == 1);
          system->add_entry(static_cast<int>(system->nodes.size()) - 1, (k < half ? -1.0 : 1.0) / half);
        }
      }
    }
    s.build(0.3);
    EXPECT_EQ(s.system.islands().size(), alone.size());
    s.solve();
    int node = 0;
    for (std::size_t i = 0; i < alone.size(); ++i) {
      ImpulseSystem& one = alone[i];
      one.build(0.3);
      one.solve();
      EXPECT_EQ(s.impulse(i), one.impulse(0));
      for (int n = 0; n < static_cast<int>(one.nodes.size()); ++n, ++node) {
        for (int c = 0; c < 4; ++c) EXPECT_EQ(s.velocity(node)[c], one.velocity(n)[c]);
      }
    }
  }
}

TEST(ContactImpulse, IterationsGiveTheSameBitsForAnyNumberOfThreads) {
  // Two facing layers of nodes, a row for each pair of facing quadrilaterals: one island of thousands of rows, and
  // hundreds of small ones.
  constexpr int edge = 40;
  const auto solved = [](int threads, double mu, bool apart) {
    std::mt19937 random(12);
    std::uniform_real_distribution<double> number(-1, 1);
    ImpulseSystem s;
    for (int n = 0; n < 2 * edge * edge; ++n) {
      const Vec3<double> v{number(random), number(random), number(random)};
      s.add_node(v, 1.5 + number(random), n % edge == 0);
    }
    for (int j = 0; j + 1 < edge; ++j) {
      for (int i = 0; i + 1 < edge; ++i) {
        if (apart && (i % 4 == 3 || j % 4 == 3)) continue;
        s.add_row({0, 0, 1}, 0.1 * number(random));
        for (const int n : {0, 1, edge, edge + 1}) {
          s.add_entry(j * edge + i + n, -0.25);
          s.add_entry(edge * edge + j * edge + i + n, 0.25);
        }
      }
    }
    DefaultExecutionSpace::set_concurrency(threads);
    s.build(mu);
    EXPECT_EQ(s.system.islands().size(), apart ? std::size_t(10 * 10) : std::size_t(1));
    EXPECT_TRUE(s.solve().converged);
    std::vector<double> bits(s.velocities.data(), s.velocities.data() + s.velocities.size());
    s.iterations.project(s.system, s.velocities.data());
    DefaultExecutionSpace::set_concurrency(1);
    bits.insert(bits.end(), s.velocities.data(), s.velocities.data() + s.velocities.size());
    return bits;
  };
  for (const bool apart : {false, true}) {
    for (const double mu : {-1.0, 0.3}) {
      const std::vector<double> one = solved(1, mu, apart);
      for (const int threads : {2, 8}) EXPECT_EQ(solved(threads, mu, apart), one) << threads << " threads";
    }
  }
}

TEST(PairNames, FindWhatWasAddedAndNothingElse) {
  std::vector<std::pair<std::int32_t, std::int32_t>> pairs;
  for (std::int32_t i = 0; i < 50; ++i) {
    for (std::int32_t j = -1; j < 20; ++j) pairs.emplace_back(1000 * i, j);
  }
  PairNames names;
  for (const std::size_t count : {std::size_t(0), std::size_t(1), pairs.size() / 2, pairs.size()}) {
    names.reset(count);
    for (std::size_t i = 0; i < count; ++i) names.add(pairs[i].first, pairs[i].second, i);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const auto [first, second] = pairs[i];
      const std::size_t found = names.find(first, second, [&](std::size_t place) { return pairs[place] == pairs[i]; });
      EXPECT_EQ(found, i < count ? i : PairNames::none);
    }
  }
}

TEST(RowSystem, HasEachRowAndEachOfItsNodesOnce) {
  // Floors of nodes apart from each other, of which each node is in four rows; of every other one a node in all rows.
  ImpulseSystem s;
  constexpr int edge = 8, floors = 5;
  for (int n = 0; n < floors * (edge * edge + 1); ++n) s.add_node({0, 0, 0}, 1, n % 7 == 0);
  for (int j = 0; j + 1 < edge; ++j) {
    for (int i = 0; i + 1 < edge; ++i) {
      for (int floor = 0; floor < floors; ++floor) {  // their rows among each other
        const int first = floor * (edge * edge + 1);
        s.add_row({0, 0, 1}, 0);
        for (const int n : {0, 1, edge, edge + 1}) s.add_entry(first + j * edge + i + n, 0.25);
        if (floor % 2 == 0) s.add_entry(first + edge * edge, -1);
      }
    }
  }
  s.build();
  ASSERT_EQ(s.system.islands().size(), std::size_t(floors));
  std::vector<int> rows(s.rows.size(), 0), nodes(s.nodes.size(), 0);
  for (std::size_t floor = 0; floor < floors; ++floor) {
    const Island& island = s.system.islands()[floor];
    EXPECT_EQ(island.rows(), (edge - 1) * (edge - 1));
    std::int32_t before = -1;
    for (std::int32_t k = island.first_row; k < island.end_row; ++k) {
      ++rows[static_cast<std::size_t>(s.system.original(k))];
      EXPECT_GT(s.system.original(k), before) << "in the order in which they were added";
      before = s.system.original(k);
    }
    for (std::int32_t i = island.first_node; i < island.end_node; ++i) {
      const std::int32_t place = s.system.nodes()[static_cast<std::size_t>(i)];
      ++nodes[static_cast<std::size_t>(place)];
      s.system.for_rows_of(place, [&](std::int32_t k, double weight) {
        EXPECT_TRUE(island.first_row <= k && k < island.end_row);
        const RowView row = s.system.entries(k);
        int found = 0;
        for (int e = 0; e < row.nodes; ++e) found += row.node[e] == place && row.weight[e] == weight;
        EXPECT_EQ(found, 1);
      });
    }
  }
  for (const int times : rows) EXPECT_EQ(times, 1);
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const bool used = n % (edge * edge + 1) != edge * edge || n / (edge * edge + 1) % 2 == 0;
    EXPECT_EQ(nodes[n], used ? 1 : 0) << n;
  }
}

}  // namespace
}  // namespace pinball::impulse_rows_test
