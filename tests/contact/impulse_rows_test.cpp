#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>
#include <utility>
#include <vector>

#include <solver/contact/impulses/pair_names.hpp>
#include <tests/support/impulse_system.hpp>

namespace pinball {
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

/// The velocities that close no gap, by a direct solution of the active rows for every choice of them.
Eigen::VectorXd direct_solution(const ImpulseSystem& s) {
  const int rows = static_cast<int>(s.rows.size());
  Eigen::MatrixXd G = Eigen::MatrixXd::Zero(rows, 3 * node_count);
  Eigen::MatrixXd mobility = Eigen::MatrixXd::Zero(3 * node_count, 3 * node_count);
  Eigen::VectorXd r(rows);
  for (int i = 0; i < rows; ++i) {
    const RowView row = s.rows[static_cast<std::size_t>(i)];
    for (int k = 0; k < row.nodes; ++k) {
      for (int c = 0; c < 3; ++c) G(i, 3 * row.node[k] + c) += row.weight[k] * row.direction[c];
    }
    r[i] = s.rows.rows[static_cast<std::size_t>(i)].position_rate;
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
    ImpulseSystem s = random_system(random, 1 + trial % 6, trial % 3 == 0);
    const Eigen::VectorXd expected = direct_solution(s);
    s.build();
    for (int sweep = 0; sweep < 10000; ++sweep) {
      if (s.packs.sweep(s.velocities.data()) < 1e-13) break;
    }
    EXPECT_LT((velocities(s) - expected).norm(), 1e-9) << "trial " << trial;
    for (std::size_t i = 0; i < s.rows.size(); ++i) EXPECT_GE(s.impulse(i), 0);
  }
}

TEST(ContactImpulse, SweepsDoNotMindWhereTheyBegin) {
  std::mt19937 random(8);
  ImpulseSystem s = random_system(random, 5, true);
  const Eigen::VectorXd expected = direct_solution(s);
  for (ImpulseRow& row : s.rows.rows) row.impulse = 0.3;
  s.build();
  s.packs.apply(s.velocities.data());
  for (int sweep = 0; sweep < 10000; ++sweep) s.packs.sweep(s.velocities.data());
  EXPECT_LT((velocities(s) - expected).norm(), 1e-9);
}

TEST(ContactImpulse, ProjectionTakesOutEnergyAndKeepsMomentum) {
  std::mt19937 random(9);
  for (int trial = 0; trial < 200; ++trial) {
    ImpulseSystem s = random_system(random, 1 + trial % 6, trial % 3 == 0, false);
    for (ImpulseRow& row : s.rows.rows) row.position_rate = 0;
    s.build();
    const Vec3<double> before = s.momentum();
    const double energy = s.kinetic_energy();
    s.packs.project(s.velocities.data());
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
  s.packs.project(s.velocities.data());
  EXPECT_GT(s.impulse(0), 0);
  EXPECT_EQ(s.impulse(0), s.impulse(1));
  EXPECT_NEAR(lane(closing_rate<RowPacks::Lanes>(s.packs.pack(0), s.velocities.data()), 0), -5, 1e-14);
}

TEST(ContactImpulse, RowsOfAnyWidthDoWhatOneLaneDoes) {
  // Rows that share no node, of 2 to 16 nodes each, held ones among them: one colour, full packs and others, each row
  // compared with the same one by itself.
  std::mt19937 random(11);
  std::uniform_real_distribution<double> number(-1, 1);
  for (const int count : {1, 7, 8, 9, 31}) {
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
    s.build();
    const double change = s.packs.sweep(s.velocities.data());
    double largest = 0;
    for (std::size_t i = 0; i < alone.size(); ++i) {
      alone[i].build(-1, 1);
      largest = std::max(largest, alone[i].packs.sweep(alone[i].velocities.data()));
      EXPECT_NEAR(s.impulse(i), alone[i].impulse(0), 1e-14);
    }
    EXPECT_NEAR(change, largest, 1e-14);
    int node = 0;
    for (const ImpulseSystem& one : alone) {
      for (int n = 0; n < static_cast<int>(one.nodes.size()); ++n, ++node) {
        for (int c = 0; c < 4; ++c) EXPECT_NEAR(s.velocity(node)[c], one.velocity(n)[c], 1e-14);
      }
    }
  }
}

TEST(RowPacks, SweepsGiveTheSameBitsForAnyNumberOfThreads) {
  // Two facing layers of nodes, a row for each pair of facing quadrilaterals: four colours of thousands of rows.
  constexpr int edge = 110;
  const auto swept = [](int threads, double mu) {
    std::mt19937 random(12);
    std::uniform_real_distribution<double> number(-1, 1);
    ImpulseSystem s;
    for (int n = 0; n < 2 * edge * edge; ++n) {
      const Vec3<double> v{number(random), number(random), number(random)};
      s.add_node(v, 1.5 + number(random), n % edge == 0);
    }
    for (int j = 0; j + 1 < edge; ++j) {
      for (int i = 0; i + 1 < edge; ++i) {
        s.add_row({0, 0, 1}, 0.1 * number(random));
        for (const int n : {0, 1, edge, edge + 1}) {
          s.add_entry(j * edge + i + n, -0.25);
          s.add_entry(edge * edge + j * edge + i + n, 0.25);
        }
      }
    }
    DefaultExecutionSpace::set_concurrency(threads);
    s.build(mu);
    EXPECT_TRUE(s.packs.sweeps_are_shared_out());
    EXPECT_GE(s.packs.order().colour_offsets().size(), 4U + 1);
    std::vector<double> bits;
    for (int sweep = 0; sweep < 5; ++sweep) bits.push_back(s.packs.sweep(s.velocities.data()));
    s.packs.project(s.velocities.data());
    DefaultExecutionSpace::set_concurrency(1);
    bits.insert(bits.end(), s.velocities.data(), s.velocities.data() + s.velocities.size());
    return bits;
  };
  for (const double mu : {-1.0, 0.3}) {
    const std::vector<double> one = swept(1, mu);
    for (const int threads : {1, 2, 3, 8}) EXPECT_EQ(swept(threads, mu), one) << threads << " threads";
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

TEST(RowOrder, RowsOfAColourShareNoNode) {
  // A floor of nodes, of which each is in four rows, and one node that 100 rows share: more than 64 colours.
  ImpulseSystem s;
  constexpr int edge = 20;
  for (int n = 0; n <= edge * edge; ++n) s.add_node({0, 0, 0}, 1, n % 7 == 0);
  for (int j = 0; j + 1 < edge; ++j) {
    for (int i = 0; i + 1 < edge; ++i) {
      s.add_row({0, 0, 1}, 0);
      for (const int n : {0, 1, edge, edge + 1}) s.add_entry(j * edge + i + n, 0.25);
      if ((i + j) % 4 == 0 && i + j < 100) s.add_entry(edge * edge, -1);
    }
  }
  s.build();
  const RowOrder& order = s.packs.order();
  const std::vector<std::int32_t>& offsets = order.colour_offsets();
  EXPECT_GT(offsets.size(), 64U + 1);
  std::vector<int> seen(s.rows.size(), 0);
  for (std::size_t c = 0; c + 1 < offsets.size(); ++c) {
    std::vector<int> taken(s.nodes.size(), 0);
    for (std::int32_t pack = offsets[c]; pack < offsets[c + 1]; ++pack) {
      for (int l = 0; l < order.width(); ++l) {
        const std::int32_t i = order.row(pack, l);
        if (i < 0) continue;
        ++seen[static_cast<std::size_t>(i)];
        const RowView row = s.rows[static_cast<std::size_t>(i)];
        for (int k = 0; k < row.nodes; ++k) EXPECT_EQ(taken[static_cast<std::size_t>(row.node[k])]++, 0);
      }
    }
  }
  for (const int times : seen) EXPECT_EQ(times, 1);
}

}  // namespace
}  // namespace pinball
