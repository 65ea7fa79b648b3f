#include <gtest/gtest.h>

#include <tests/support/collapsed_case.hpp>
#include <tests/support/tetrahedra_case.hpp>

#include "ranks_on_devices_case.hpp"

/// Tetrahedra and wedges, of which ranks with a device each tell each other volumes: the bits of one process on that
/// device.
namespace pinball::volumes_of_ranks_on_devices_test {
namespace {

using namespace test;

class VolumesOfRanksOnDevices : public RanksOnDevicesTest {
 protected:
  VolumesOfRanksOnDevices()
      : RanksOnDevicesTest({{1, {}}, {2, {}}, {3, {Partition::By::random, 1}}, {4, {Partition::By::graph, 0}}}) {}
};

/// More elements than one piece of a sum has: ranks also work elements of others for their sums. What erodes on one
/// rank no longer counts on the others.
TEST_P(VolumesOfRanksOnDevices, AreThoseOfOneDeviceWhereSomeErode) {
  const Outcome found = expect_same<double>(torn_tetrahedra(Precision::float64, {9, 8, 7}));
  EXPECT_GT(found.eroded, 10);
  EXPECT_LT(found.eroded, 9 * 8 * 7 * 6);
}

TEST_P(VolumesOfRanksOnDevices, AreThoseInSinglePrecision) {
  EXPECT_GT(expect_same<float>(torn_tetrahedra(Precision::float32)).eroded, 10);
}

TEST_P(VolumesOfRanksOnDevices, AreThoseBesideHexahedraOfTheSameBody) { expect_same<double>(striking_bar_of_both()); }

TEST_P(VolumesOfRanksOnDevices, AreThoseWithWedgesAndPyramids) {
  EXPECT_GT(expect_same<double>(torn_shapes()).eroded, 10);
}

TEST_P(VolumesOfRanksOnDevices, AreThoseInContact) {
  const Outcome found = expect_same<double>(striking_tetrahedra());
  EXPECT_GT(found.pairs, 0);
  EXPECT_GT(found.eroded, 0);
}

TEST_P(VolumesOfRanksOnDevices, GoOnFromEachOthersStates) {
  for (const Scene& scene : {torn_tetrahedra(), torn_shapes(), striking_bar_of_both()}) expect_to_go_on(scene);
}

INSTANTIATE_TEST_SUITE_P(On, VolumesOfRanksOnDevices, testing::ValuesIn(devices()), name_of_device);

}  // namespace
}  // namespace pinball::volumes_of_ranks_on_devices_test
