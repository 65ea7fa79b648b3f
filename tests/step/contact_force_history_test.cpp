#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <solver/simulation.hpp>
#include <tests/support/solver_case.hpp>

/// What history.csv says of the contact forces on the bodies.
namespace pinball::contact_force_history_test {
namespace {

/// Columns "NAME_contact_force_x" and so on, at the end of a row.
Point contact_force(const HistoryRow& row, std::size_t body) {
  const std::size_t first = row.more.size() - 3 * (row.bodies.size() - body);
  return {row.more[first], row.more[first + 1], row.more[first + 2]};
}

Point momentum_of(const BodyResult& body) {
  Point momentum = body.velocity;
  for (double& p : momentum) p *= body.mass_remaining;
  return momentum;
}

class ContactForceHistory : public testing::TestWithParam<const char*> {};

TEST_P(ContactForceHistory, IsEqualAndOppositeAndItsImpulseIsTheChangeOfMomentum) {
  Simulation simulation(
      read_scene(find_scene("two_blocks"), {.set = {std::string("contact.enforcement=") + GetParam()}}));
  const Point begin = momentum_of(simulation.bodies()[1]);
  double impulse = 0, largest = 0, time = 0;
  while (simulation.step()) {
    const HistoryRow row = simulation.history_row();
    const Point first = contact_force(row, 0), second = contact_force(row, 1);
    for (std::size_t k = 0; k < 3; ++k) {
      largest = std::max(largest, std::abs(second[k]));
      EXPECT_NEAR(first[k] + second[k], 0, 1e-10 * largest) << "step " << row.step;
    }
    impulse += second[2] * row.dt;
    time = row.time;
  }
  const double change = momentum_of(simulation.bodies()[1])[2] - begin[2];
  EXPECT_GT(std::abs(change), 0);
  EXPECT_NEAR(impulse / change, 1, 0.02) << "to t = " << time;
}

INSTANTIATE_TEST_SUITE_P(Enforcement, ContactForceHistory, testing::Values("penalty", "lagrange", "projection"));

/// The contact forces of the fields, which history.csv has the sums of, are those that the nodes have felt: with
/// friction, in every direction.
class ContactForcesWithFriction : public testing::TestWithParam<Enforcement> {};

TEST_P(ContactForcesWithFriction, HaveTheImpulseThatTheBodiesTake) {
  Scene scene = test::scene_of({test::block("lower", {3, 3, 2}, 0.1, {0, 0, 0}, {0, 0, 20}),
                                test::block("upper", {2, 2, 2}, 0.1, {0.03, 0.04, 0.201}, {30, -10, -20})},
                               2e-4);
  scene.contact.enforcement = GetParam();
  scene.contact.gap = ContactGap::face;
  scene.contact.friction = scene.contact.static_friction = 0.4;
  Simulation simulation(scene);
  const Point begin = momentum_of(simulation.bodies()[1]);
  Point impulse{};
  double dt_before = 0;
  while (simulation.step()) {
    const FieldSnapshot fields = simulation.snapshot();
    const HistoryRow row = simulation.history_row();
    Point sums[2] = {};
    for (std::size_t n = 0; n < fields.contact_force.size(); ++n) {
      for (std::size_t k = 0; k < 3; ++k) sums[n < 48 ? 0 : 1][k] += fields.contact_force[n][k];
    }
    for (std::size_t body = 0; body < 2; ++body) {
      const Point column = contact_force(row, body);
      for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(column[k], sums[body][k], 1e-9 * (1 + std::abs(column[k])));
    }
    for (std::size_t k = 0; k < 3; ++k) impulse[k] += sums[1][k] * (dt_before + simulation.dt()) / 2;
    dt_before = simulation.dt();
  }
  const Point end = momentum_of(simulation.bodies()[1]);
  EXPECT_LT(end[0] - begin[0], -0.1 * std::abs(end[2] - begin[2])) << "it is to be slowed down";
  EXPECT_GT(end[1] - begin[1], 0.03 * std::abs(end[2] - begin[2]));
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(impulse[k], end[k] - begin[k], 1e-9 * std::abs(end[2] - begin[2])) << k;
  }
}

INSTANTIATE_TEST_SUITE_P(Impulses, ContactForcesWithFriction,
                         testing::Values(Enforcement::lagrange, Enforcement::projection),
                         [](const auto& test) { return std::string(enforcement_name(test.param)); });

TEST(ContactForceColumns, StandAtTheEndAndOnlyWhereThereIsContact) {
  using testing::ElementsAre;
  const Simulation with(read_scene(find_scene("two_blocks")));
  const Simulation without(read_scene(find_scene("two_blocks"), {.set = {"contact.method=none"}}));
  EXPECT_EQ(with.history_columns().size(), without.history_columns().size() + 6);
  std::vector<std::string> names;
  for (const BodyResult& body : with.bodies()) {
    for (const char* axis : {"x", "y", "z"}) names.push_back(body.name + "_contact_force_" + axis);
  }
  const std::vector<std::string> columns = with.history_columns();
  EXPECT_EQ(std::vector<std::string>(columns.end() - 6, columns.end()), names);
}

}  // namespace
}  // namespace pinball::contact_force_history_test
