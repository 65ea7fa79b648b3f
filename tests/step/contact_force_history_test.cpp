#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <solver/simulation.hpp>

/// What history.csv says of the contact forces on the bodies.
namespace pinball {
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
}  // namespace pinball
