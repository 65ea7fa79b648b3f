#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include <tests/device/device_case.hpp>
#include <tests/support/every_input.hpp>

/// What the host does in a step whose elements and nodes are a device's: contact, ties and rigid bodies (StepSpace),
/// and rows of history of a state that stays where it is.
namespace pinball::device_stages_test {
namespace {

using namespace test;

/// With what output asks for.
Scene eroding_impact() {
  Scene scene = eroding_rod();
  scene.output.body_energies = true;
  for (const char* body : {"rod", "plate"}) {
    Probe probe;
    probe.name = std::string("of_") + body;
    probe.body = body;
    probe.point = {20e-3, 20e-3, 10e-3};
    probe.quantities = {"displacement", "velocity"};
    scene.probes.push_back(probe);
    probe.name += "_element";
    probe.kind = ProbeKind::element;
    probe.quantities = {"stress", "plastic_strain"};
    scene.probes.push_back(probe);
  }
  return scene;
}

/// With impulses on faces, friction, and self-contact.
Scene eroding_impact_of_faces() {
  Scene scene = eroding_impact();
  scene.contact.gap = ContactGap::face;
  scene.contact.enforcement = Enforcement::lagrange;
  scene.contact.friction = 0.3;
  return scene;
}

/// A block tied to one that is held, from a time on, and let go again.
Scene tied_blocks() {
  Scene scene = scene_of(
      {block("low", {3, 3, 3}, 0.2, {0, 0, 0}), block("high", {4, 4, 4}, 0.15, {0, 0, 0.6}, {5, 0, 0})}, 6e-4, false);
  TiedContact tied;
  tied.name = "glue";
  tied.first.bodies = {"high"};
  tied.second.bodies = {"low"};
  tied.start = 1e-4;
  tied.end = 4e-4;
  scene.tied_contacts = {tied};
  return scene;
}

/// A rigid ram, pushed, on a block that stands on a rigid floor under gravity.
Scene ram() {
  Scene scene =
      scene_of({block("floor", {4, 4, 1}, 0.1, {-0.1, -0.1, -0.101}), block("block", {4, 4, 4}, 0.05, {0, 0, 0}),
                block("ram", {2, 2, 2}, 0.1, {0.02, 0.01, 0.201}, {0, 0, -50})},
               4e-4);
  for (const char* body : {"floor", "ram"}) {
    RigidBody rigid;
    rigid.name = rigid.bodies.emplace_back(body);
    scene.rigid_bodies.push_back(rigid);
  }
  scene.rigid_bodies[0].held = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  scene.gravities = {Gravity{}};
  scene.gravities[0].acceleration = {0, 0, -9.81};
  scene.contact.gap = ContactGap::face;
  scene.contact.enforcement = Enforcement::lagrange;
  return scene;
}

/// The ram falls on a hinge.
Scene hinged_ram() {
  Scene scene = ram();
  scene.bodies.back().velocity = {};
  scene.gravities[0].acceleration = {0, 0, -3e5};
  Joint hinge;
  hinge.name = "hinge";
  hinge.kind = JointKind::revolute;
  hinge.bodies = {"ram", "ground"};
  hinge.point = {-0.3, 0.1, 0.3};
  hinge.axis = {0, 1, 0};
  scene.joints = {hinge};
  return scene;
}

struct Case {
  std::string name;
  std::function<Scene()> scene;
};

const std::vector<Case>& cases() {
  static const std::vector<Case> all = {
      {"balls", [] { return eroding_impact(); }},
      {"balls_of_present_size",
       [] {
         Scene scene = eroding_impact();
         scene.contact.radius = ContactRadius::current;
         return scene;
       }},
      {"balls_by_impulses",
       [] {
         Scene scene = eroding_impact();
         scene.contact.enforcement = Enforcement::lagrange;
         return scene;
       }},
      {"faces", [] { return eroding_impact_of_faces(); }},
      {"slideline",
       [] {
         Scene scene = scene_of(
             {block("a", {4, 4, 2}, 0.05, {0, 0, 0}), block("b", {2, 2, 2}, 0.07, {0.03, 0.02, 0.101}, {0, 0, -30})},
             4e-4);
         scene.contact.method = ContactMethod::slideline;
         return scene;
       }},
      {"ties", [] { return tied_blocks(); }},
      {"rigid", [] { return ram(); }},
      {"balls_of_a_rigid_body",
       [] {
         Scene scene = ram();
         scene.contact.gap = ContactGap::pinball;
         scene.contact.enforcement = Enforcement::penalty;
         return scene;
       }},
      {"joints", [] { return hinged_ram(); }},
  };
  return all;
}

class DeviceStages : public testing::TestWithParam<std::tuple<Device, Case>> {
 protected:
  Device device() const { return std::get<0>(GetParam()); }
  Scene scene() const { return std::get<1>(GetParam()).scene(); }
};

TEST_P(DeviceStages, AreThoseOfTheHost) {
  expect_same_run<double>(scene(), device());
  Scene single = scene();
  single.precision = Precision::float32;
  expect_same_run<float>(single, device());
}

TEST_P(DeviceStages, GoOnFromWhatAnotherDeviceHasSaved) {
  const std::uint64_t on_host = hash_on<double>(scene(), Device::none), whole = hash_on<double>(scene(), device());
  EXPECT_EQ(hash_of_parts(scene(), device(), device()), whole);
  if (!same_bits) return;
  EXPECT_EQ(hash_of_parts(scene(), device(), Device::none), on_host);
  EXPECT_EQ(hash_of_parts(scene(), Device::none, device()), on_host);
}

/// Numbers of a row as one list; those of energies but for round-off of what cancels.
std::vector<double> numbers_of(const HistoryRow& row) {
  std::vector<double> numbers = row.more;
  for (const BodyResult& body : row.bodies) {
    numbers.insert(numbers.end(),
                   {body.mass_remaining, body.max_plastic_strain, static_cast<double>(body.eroded_elements)});
    numbers.insert(numbers.end(), body.velocity.begin(), body.velocity.end());
  }
  numbers.insert(numbers.end(), row.momentum.begin(), row.momentum.end());
  return numbers;
}

/// Rows in the middle of a run, for which no whole state is copied; of all columns that depend on the state.
void expect_same_rows(const Scene& scene, Device device) {
  Scene on_device = scene;
  on_device.device = device;
  Solver<double> host(scene), there(on_device);
  std::vector<double> largest;
  for (int step = 0; !host.at_end(); ++step) {
    host.step();
    there.step();
    if (step % 7 != 0) continue;
    const std::vector<double> expected = numbers_of(history_row(host)), found = numbers_of(history_row(there));
    ASSERT_EQ(found.size(), expected.size());
    largest.resize(expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      largest[i] = std::max(largest[i], std::abs(expected[i]));
      // Sums of what cancels are round-off of the numbers that do.
      const double scale = std::max(largest[i], 1e-3 * *std::ranges::max_element(largest));
      ASSERT_NEAR(found[i], expected[i], 1e-9 * scale) << step << ", number " << i;
    }
  }
}

TEST_P(DeviceStages, HaveTheHostsRowsOfHistory) { expect_same_rows(scene(), device()); }

/// Saved while bodies touch and erode, in steps that a list lasts for, too.
TEST_P(DeviceStages, GoOnAnywhereInARun) {
  Solver<double> host(scene());
  run(host);
  const std::uint64_t whole = hash_on<double>(scene(), device());
  for (const std::int64_t part : {2, 3, 4}) {
    const int steps = static_cast<int>(host.steps() * part / 5);
    EXPECT_EQ(hash_of_parts(scene(), device(), device(), steps), whole) << steps;
    if (!same_bits) continue;
    EXPECT_EQ(hash_of_parts(scene(), device(), Device::none, steps), state_hash(host.model())) << steps;
  }
}

std::string name_of_case(const testing::TestParamInfo<std::tuple<Device, Case>>& info) {
  return std::string(device_name(std::get<0>(info.param))) + "_" + std::get<1>(info.param).name;
}

INSTANTIATE_TEST_SUITE_P(On, DeviceStages, testing::Combine(testing::ValuesIn(devices()), testing::ValuesIn(cases())),
                         name_of_case);

Scene rod_plate() { return read_input(std::string(PINBALL_SOURCE_DIR) + "/data/scenes/rod_plate.toml"); }

/// The report's first problem, whole. In single precision runs that round otherwise part from about 2.3e-5 on.
TEST(DeviceStagesRodPlate, IsThatOfTheHost) {
  expect_same_run<double>(rod_plate(), Device::mock);
  Scene single = rod_plate();
  single.precision = Precision::float32;
  if (!same_bits) single.time.end = 2e-5;
  expect_same_run<float>(single, Device::mock);
}

TEST(DeviceStagesRodPlate, HasTheHostsRowsOfHistory) { expect_same_rows(rod_plate(), Device::mock); }

/// Bodies that have torn on a device fly on by the host to where they come in a run of the host.
TEST(DeviceStagesRodPlate, GoesOnByTheHost) {
  Scene on_device = rod_plate();
  on_device.device = Device::mock;
  Solver<double> whole(rod_plate()), first(on_device), second(rod_plate());
  run(whole);
  while (first.steps() < whole.steps() / 2) first.step();
  EXPECT_GT(first.counts().pairs(), 0);
  EXPECT_GT(first.counts().eroded_elements(), 10);
  load(second, saved(first));
  EXPECT_LT(second.counts().eroded_elements(), whole.counts().eroded_elements());
  run(second);
  expect_same_state(second, whole);
  EXPECT_EQ(hash_of_parts(rod_plate(), Device::mock, Device::mock, static_cast<int>(first.steps())),
            hash_on<double>(rod_plate(), Device::mock));
}

/// Else nothing of erosion is tested.
TEST(DeviceStagesCases, Erode) {
  for (const Scene& scene : {eroding_impact(), eroding_impact_of_faces(), rod_plate()}) {
    Solver<double> host(scene);
    run(host);
    EXPECT_GT(host.counts().eroded_elements(), 3);
  }
}

}  // namespace
}  // namespace pinball::device_stages_test
