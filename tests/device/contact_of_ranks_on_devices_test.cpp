#include <gtest/gtest.h>

#include <tuple>
#include <vector>

#include <tests/parallel/contact_scenes.hpp>

#include "ranks_on_devices_case.hpp"

/// Contact, ties and rigid bodies of several ranks with a device each: the bits of one process on that device.
namespace pinball::contact_of_ranks_on_devices_test {
namespace {

using namespace test;

const std::vector<Shared> one_to_four{
    {1, {}}, {2, {}}, {3, {Partition::By::random, 1}}, {4, {Partition::By::graph, 0}}};

class ContactOfRanksOnDevices : public RanksOnDevicesTest {
 protected:
  ContactOfRanksOnDevices() : RanksOnDevicesTest({{2, {}}, {3, {Partition::By::random, 1}}}) {}
};

TEST_P(ContactOfRanksOnDevices, IsOfEveryAlgorithmWhileElementsErode) {
  for (const auto& [method, enforcement, gap] :
       {std::tuple{ContactMethod::pinball, Enforcement::lagrange, ContactGap::face},
        std::tuple{ContactMethod::pinball, Enforcement::lagrange, ContactGap::pinball},
        std::tuple{ContactMethod::pinball, Enforcement::penalty, ContactGap::face},
        std::tuple{ContactMethod::pinball, Enforcement::penalty, ContactGap::pinball},
        std::tuple{ContactMethod::slideline, Enforcement::penalty, ContactGap::pinball},
        std::tuple{ContactMethod::slideline, Enforcement::projection, ContactGap::pinball}}) {
    const Outcome of = expect_same<double>(eroding(method, enforcement, gap));
    EXPECT_GT(of.eroded, 20);
    EXPECT_GT(of.pairs, 0);
    EXPECT_GT(of.searches, 3);
  }
}

TEST_P(ContactOfRanksOnDevices, IsThereInSinglePrecision) {
  Scene scene = eroding(ContactMethod::pinball, Enforcement::lagrange, ContactGap::face);
  scene.precision = Precision::float32;
  EXPECT_GT(expect_same<float>(scene).pairs, 0);
}

/// Without erosion, while lists last.
TEST_P(ContactOfRanksOnDevices, ReadsTheNodesOfItsLists) {
  Scene scene = eroding(ContactMethod::pinball, Enforcement::lagrange, ContactGap::face);
  scene.bodies[1].velocity = {15, 0, -90};
  scene.time.end = 1.5e-4;
  scene.contact.friction = scene.contact.static_friction = 0.2;
  const Outcome of = expect_same_on<double>(one_to_four, on_device(scene));
  EXPECT_EQ(of.eroded, 0);
  EXPECT_GT(of.pairs, 0);
  EXPECT_LT(of.searches, of.steps / 2);
}

TEST_P(ContactOfRanksOnDevices, IsBesideTiesThatBeginEndAndBreak) {
  const Outcome of = expect_same<double>(glued());
  EXPECT_GT(of.eroded, 0);
  EXPECT_GT(of.pairs, 0);
  Scene scene = glued();
  scene.contact.method = ContactMethod::none;
  EXPECT_GT(expect_same<double>(scene).eroded, 0);
}

TEST_P(ContactOfRanksOnDevices, IsOfRigidAndJointedBodies) {
  for (const Enforcement enforcement : {Enforcement::lagrange, Enforcement::penalty})
    EXPECT_GT(expect_same<double>(with_rigid_bodies(enforcement)).pairs, 0);
  EXPECT_GT(expect_same<double>(with_jointed_bodies()).pairs, 0);
  Scene scene = with_rigid_bodies(Enforcement::penalty);
  scene.contact.method = ContactMethod::none;
  expect_same<double>(scene);
}

TEST_P(ContactOfRanksOnDevices, IsBesideWhatBeginsAndEnds) { EXPECT_GT(expect_same<double>(changing()).pairs, 0); }

TEST_P(ContactOfRanksOnDevices, GoesOnFromAStateOnAnyOthers) {
  expect_to_go_on(eroding(ContactMethod::pinball, Enforcement::lagrange, ContactGap::face));
  expect_to_go_on(glued());
}

INSTANTIATE_TEST_SUITE_P(On, ContactOfRanksOnDevices, testing::ValuesIn(devices()), name_of_device);

}  // namespace
}  // namespace pinball::contact_of_ranks_on_devices_test
