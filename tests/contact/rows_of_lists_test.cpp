#include <gtest/gtest.h>

#include <cstring>
#include <random>
#include <span>
#include <vector>

#include <solver/contact/faces/feature_row.hpp>
#include <solver/contact/impulses/rows_of_lists.hpp>

/// Rows that the solver of impulses takes from lists, in parallel, against the same ones added one by one.
namespace pinball::rows_of_lists_test {
namespace {

/// Nodes of mass 1 that are all there is.
class Nodes final : public SurfaceSource<double> {
 public:
  explicit Nodes(std::int32_t count) : x_(4 * count), v_(4 * count), f_(4 * count), inverse_(count) {
    position = x_.data();
    velocity = v_.data();
    force = f_.data();
    inverse_mass = inverse_.data();
    node_count = count;
    std::mt19937 random(7);
    for (std::int32_t n = 0; n < count; ++n) {
      inverse_[n] = 1;
      for (int c = 0; c < 3; ++c) record(v_.data(), n)[c] = std::uniform_real_distribution<double>(-1, 1)(random);
    }
  }
  bool is_element(std::int64_t /*slot*/) const override { return false; }
  ContactElement element(std::int64_t /*slot*/) const override { return {}; }
  bool may_soon_erode(std::int64_t /*slot*/) const override { return false; }
  bool has_forces_of(const Nodes& other) const { return std::memcmp(f_.data(), other.f_.data(), f_.bytes()) == 0; }

 private:
  Array<double> x_, v_, f_, inverse_;
};

/// A row of a few of the nodes, which has some of them twice, or without weight.
FeatureRow random_row(std::mt19937& random, std::int64_t number, std::int32_t nodes) {
  std::uniform_real_distribution<double> between(-1, 1);
  FeatureRow row;
  row.first = number;
  row.second = -1 - number % 3;
  const Vec3<double> along{between(random), between(random), 2 + between(random)};
  row.direction = (1 / std::sqrt(dot(along, along))) * along;
  row.depth = 0.1 * between(random);
  row.size = row.reach = 1;
  row.add_node(static_cast<std::int32_t>(random() % nodes), -1);
  for (const double weight : {0.5, 0.0, 0.25, 0.25}) {
    row.add_node(static_cast<std::int32_t>((row.node[0] + 1 + random() % 3) % nodes), weight);
  }
  return row;
}

/// The same places of nodes, and the same bits of forces, in steps that remember each other: some rows go, and come
/// back.
void expect_same_forces(std::int32_t rows, std::int32_t nodes) {
  ContactSettings settings;
  settings.enforcement = Enforcement::lagrange;
  settings.friction = settings.static_friction = 0.2;
  Nodes of_lists(nodes), one_by_one(nodes);
  ImpulseSolver<double> taken(settings, nodes, {nodes, {}}), added(settings, nodes, {nodes, {}});
  std::mt19937 random(static_cast<unsigned>(rows));
  std::int64_t pushed = 0;
  for (int step = 0; step < 4; ++step) {
    std::mt19937 same(3);  // rows of each step are the same ones
    std::vector<std::vector<FeatureRow>> some(9);
    for (std::int32_t number = 0; number < rows; ++number) {
      const FeatureRow row = random_row(same, number, nodes);
      if (random() % 4 != 0) some[9 * number / rows].push_back(row);
    }
    some[4].clear();
    const std::vector<std::span<const FeatureRow>> lists(some.begin(), some.end());
    taken.begin_rows(std::span<const std::span<const FeatureRow>>(lists));
    added.begin_rows();
    for (const auto& list : some) {
      for (const FeatureRow& row : list) row.give_to(added);
    }
    const FeatureRow last = random_row(same, rows, nodes);  // as rows of spheres come
    last.give_to(taken);
    last.give_to(added);
    ASSERT_EQ(taken.nodes(), added.nodes());
    taken.finish_rows(of_lists, 1.0);
    added.finish_rows(one_by_one, 1.0);
    const ImpulseResult result = taken.solve(of_lists, {1.0, 1.0}), expected = added.solve(one_by_one, {1.0, 1.0});
    pushed += expected.pairs;
    EXPECT_EQ(result.pairs, expected.pairs);
    EXPECT_EQ(result.deepest, expected.deepest);
    EXPECT_EQ(result.penetration_ratio, expected.penetration_ratio);
    ASSERT_TRUE(of_lists.has_forces_of(one_by_one)) << rows << " rows, step " << step;
  }
  EXPECT_GE(pushed, rows / 4) << "rows that push, in all steps";
}

TEST(RowsOfLists, AreThoseThatAreAddedOneByOne) {
  for (const std::int32_t rows : {1, 40, 3000}) expect_same_forces(rows, 2 * rows + 6);
  expect_same_forces(900, 300);
}

/// The deepest of many rows is the first of those that are as deep.
TEST(RowsOfLists, NameTheFirstOfTheDeepest) {
  const std::int32_t rows = 5000;
  Nodes nodes(2 * rows);
  ContactSettings settings;
  settings.enforcement = Enforcement::lagrange;
  ImpulseSolver<double> solver(settings, 2 * rows, {2 * rows, {}});
  std::vector<FeatureRow> list(rows);
  for (std::int32_t i = 0; i < rows; ++i) {
    FeatureRow& row = list[i];
    row.first = i;
    row.second = -1;
    row.direction = {0, 0, 1};
    row.depth = i == 1234 || i == 4321 ? 0.25 : 0.125;
    row.size = row.reach = 1;
    row.add_node(2 * i, -1);
    row.add_node(2 * i + 1, 1);
  }
  const std::span<const FeatureRow> all(list);
  solver.begin_rows(std::span<const std::span<const FeatureRow>>(&all, 1));
  solver.finish_rows(nodes, 1.0);
  const ImpulseResult result = solver.solve(nodes, {1.0, 1.0});
  EXPECT_EQ(result.deepest, 2 * 1234);
  EXPECT_EQ(result.penetration_ratio, 0.25);
}

}  // namespace
}  // namespace pinball::rows_of_lists_test
