#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>

#include <solver/contact/algorithm/contact_ledger.hpp>
#include <solver/model/model_surface.hpp>
#include <tests/support/saved_state.hpp>

#include "impact_case.hpp"

/// The stages that a step calls whatever enforces contact, and the book of what they have done.
namespace pinball::contact_protocol_test {
namespace {

using namespace test;

class ContactProtocol : public testing::TestWithParam<std::tuple<ContactMethod, Enforcement>> {
 protected:
  /// The blocks have met and are 0.01 elements in each other, without any force yet.
  ContactProtocol() : model_(build_model<double>(scene())) {
    for (std::size_t i = 0; i < model_.nodes.position.size(); ++i) {
      model_.nodes.position[i] += dt_ * model_.nodes.velocity[i];
    }
  }
  static bool springs() { return std::get<1>(GetParam()) == Enforcement::penalty; }
  static Scene scene() {
    Scene scene = head_on_impact(0.01);
    std::tie(scene.contact.method, scene.contact.enforcement) = GetParam();
    return scene;
  }
  /// Nodes that have a force.
  std::set<std::int32_t> loaded() const {
    std::set<std::int32_t> nodes;
    for (std::int32_t n = 0; n < model_.nodes.count; ++n) {
      const double* f = record(model_.nodes.force.data(), n);
      if (f[0] != 0 || f[1] != 0 || f[2] != 0) nodes.insert(n);
    }
    return nodes;
  }

  static constexpr double dt_ = 1e-4;
  Model<double> model_;
};

INSTANTIATE_TEST_SUITE_P(All, ContactProtocol,
                         testing::Combine(testing::Values(ContactMethod::pinball, ContactMethod::slideline),
                                          testing::Values(Enforcement::penalty, Enforcement::projection,
                                                          Enforcement::lagrange)),
                         [](const auto& test) {
                           const bool pinball = std::get<0>(test.param) == ContactMethod::pinball;
                           return std::string(pinball ? "pinball_" : "slideline_") +
                                  enforcement_name(std::get<1>(test.param));
                         });

TEST_P(ContactProtocol, TheStageThatIsNotDueDoesNothing) {
  const auto contact = make_model_contact(model_);
  const ModelSurface<double> surface(model_);
  contact->update_surface(surface, {});
  contact->search(surface, dt_);
  ContactWork before = contact->before_step(surface, dt_);
  EXPECT_EQ(before.pairs > 0, springs());
  EXPECT_TRUE(loaded().empty()) << "no forces before add_forces";
  contact->add_forces(surface, before);
  EXPECT_EQ(before.frequency2 > 0, springs());
  const std::set<std::int32_t> by_springs = loaded();
  EXPECT_EQ(by_springs.empty(), !springs());
  const std::vector<std::int32_t> spring_nodes = contact->spring_nodes();
  for (const std::int32_t node : by_springs) EXPECT_TRUE(std::ranges::count(spring_nodes, node) > 0) << node;

  const ContactWork after = contact->after_constraints(surface, {dt_, dt_});
  EXPECT_EQ(contact->acts_on_velocities(), !springs());
  EXPECT_EQ(after.pairs > 0, !springs());
  EXPECT_EQ(after.frequency2, 0);
  const std::vector<std::int32_t>& impulse_nodes = contact->impulse_nodes();
  if (springs()) {
    EXPECT_EQ(loaded(), by_springs);
    EXPECT_TRUE(impulse_nodes.empty());
    EXPECT_EQ(after.dissipated, 0);
  } else {
    EXPECT_TRUE(spring_nodes.empty());
    EXPECT_FALSE(loaded().empty());
    for (const std::int32_t node : loaded()) EXPECT_EQ(std::ranges::count(impulse_nodes, node), 1) << node;
  }
}

TEST(ContactWork, AddsWhatSumsAndKeepsTheLargestOfTheRest) {
  ContactWork work{1, 2, 3, 4, 0.5, 6, 7, 8, {1, 9, 9, 0, 0}};
  work += {10, 20, 30, 40, 0.25, 60, 70, 5, {1, 20, 20, 1, 0}};
  EXPECT_EQ(work.stored, 11);
  EXPECT_EQ(work.eroded, 22);
  EXPECT_EQ(work.damped_power, 33);
  EXPECT_EQ(work.dissipated, 44);
  EXPECT_EQ(work.penetration_ratio, 0.5);
  EXPECT_EQ(work.iterations.iterations, 29);
  EXPECT_EQ(work.iterations.largest, 20);
  EXPECT_EQ(work.pairs, 66);
  EXPECT_EQ(work.frequency2, 70);
  EXPECT_EQ(work.expected_change, 8);
}

TEST(ContactLedger, SumsPowerByTheTrapezoidalRuleAndGoesOnAfterARestart) {
  ContactWork first, second;
  first.damped_power = 4;
  first.dissipated = 1;
  second.damped_power = 2;
  second.eroded = 8;
  ContactLedger ledger, again;
  ledger.book(first, 0.5);
  EXPECT_EQ(ledger.dissipated(), 2);  // 0.5 (0 + 4) 0.5 + 1
  const StateBytes bytes = test::saved(ledger);
  test::load(again, bytes);
  for (ContactLedger* one : {&ledger, &again}) {
    one->book(second, 1);
    EXPECT_EQ(one->dissipated(), 5);  // and 0.5 (4 + 2) 1
    EXPECT_EQ(one->eroded(), 8);
    EXPECT_EQ(one->damped_power(), 2);
  }
}

}  // namespace
}  // namespace pinball::contact_protocol_test
