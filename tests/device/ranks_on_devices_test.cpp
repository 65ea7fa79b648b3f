#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "ranks_on_devices_case.hpp"

/// Several ranks with a device each: the bits of one process on that device, whatever their number and whatever each
/// works.
namespace pinball::ranks_on_devices_test {
namespace {

using namespace test;

class RanksOnDevices : public RanksOnDevicesTest {
 protected:
  RanksOnDevices()
      : RanksOnDevicesTest({{1, {}}, {2, {}}, {3, {Partition::By::random, 1}}, {4, {Partition::By::graph, 0}}}) {}
};

/// More elements than one piece of a sum has, of the mock device, too.
TEST_P(RanksOnDevices, TearABlockAsOneDeviceDoes) {
  Scene scene = torn();
  if (GetParam() == Device::mock) std::get<BlockMesh>(scene.bodies[0].mesh).elements = {24, 18, 15};
  EXPECT_GT(expect_same<double>(scene).eroded, 0);
}

TEST_P(RanksOnDevices, TearABlockInSinglePrecision) {
  EXPECT_GT(expect_same<float>(torn(Precision::float32)).eroded, 0);
}

TEST_P(RanksOnDevices, HaveLoadsConstraintsPressuresGravityDampingAndWalls) {
  const Scene scene = held_and_driven();
  expect_same<double>(scene);
  const auto run_and_name = [](Solver<double>& solver) {
    run(solver);
    return solver.boundary().forces(solver.model());
  };
  Solver<double> alone(on_device(scene));
  const std::vector<ForceResult> expected = run_and_name(alone);
  EXPECT_GT(alone.boundary().walls()[0].impulse, 0);
  const std::vector<ForceResult> found = solved_on<double>(3, {}, on_device(scene), run_and_name);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_NE(norm(found[i].force), 0) << found[i].name;
    EXPECT_EQ(found[i].force, expected[i].force) << found[i].name;
  }
}

/// Of the bodies that do not touch.
TEST_P(RanksOnDevices, HaveWhatBeginsAndEnds) {
  Scene scene = changing();
  scene.contact.method = ContactMethod::none;
  scene.contact_pairs.clear();
  scene.tied_contacts.clear();
  expect_same<double>(scene);
}

TEST_P(RanksOnDevices, LeaveOutTilesAtRest) { EXPECT_GT(expect_same<double>(resting_bar()).resting, 0); }

TEST_P(RanksOnDevices, WorkTilesAtRestAllTheSame) {
  Scene scene = resting_bar();
  scene.skip.resting = false;
  expect_same<double>(scene);
}

TEST_P(RanksOnDevices, HaveEquations) { expect_same<double>(with_equations()); }

TEST_P(RanksOnDevices, FoldElements) { expect_same<double>(pressed_block(1)); }

TEST_P(RanksOnDevices, GoOnFromEachOthersStates) {
  expect_to_go_on(torn());
  expect_to_go_on(resting_bar());
}

TEST_P(RanksOnDevices, SayWhatEachHas) {
  const auto devices = [](Solver<double>& solver) { return solver.shared_work().devices; };
  const std::vector<std::string> found = solved_on<double>(4, {}, on_device(torn()), devices);
  if (GetParam() == Device::mock) {
    EXPECT_THAT(found, testing::ElementsAre("mock", "mock", "mock", "mock"));
  } else {
    const std::string name = "GPU emulated on the processor, ";
    EXPECT_THAT(found, testing::ElementsAre(name + "0 of 3", name + "1 of 3", name + "2 of 3", name + "0 of 3"));
  }
}

std::string refusal(const Scene& scene) {
  return error_of([&] {
    on_ranks(
        2, {}, [&](ThreadRanks& ranks) { return Solver<double>(scene, &ranks), 0; },
        [&](ThreadRanks& ranks) { EXPECT_THROW(Solver<double>(scene, &ranks), InputError); });
  });
}

TEST_P(RanksOnDevices, RefuseByNameWhatNoDeviceCanDo) {
  Scene scene = on_device(torn());
  scene.time.subcycling = true;
  EXPECT_THAT(refusal(scene), testing::HasSubstr("no device can do this scene yet: it has subcycling; expected "
                                                 "--device none"));
}

INSTANTIATE_TEST_SUITE_P(On, RanksOnDevices, testing::ValuesIn(devices()), name_of_device);

}  // namespace
}  // namespace pinball::ranks_on_devices_test
