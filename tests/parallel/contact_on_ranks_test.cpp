#include <gtest/gtest.h>

#include <fstream>
#include <tuple>
#include <vector>

#include <tests/support/changing_scene.hpp>
#include <tests/support/folder_case.hpp>
#include <tests/support/saved_state.hpp>
#include <tests/support/solver_case.hpp>

#include "outcome.hpp"

/// Contact, ties, rigid bodies, and what begins and ends: on any ranks the bits of one process.
namespace pinball::contact_on_ranks_test {
namespace {

using namespace test;

/// A block that goes through a plate: both erode, and new surface comes up all the time.
Scene eroding(ContactMethod method, Enforcement enforcement, ContactGap gap) {
  Scene scene = scene_of({block("plate", {9, 9, 3}, 0.01, {0, 0, 0}),
                          block("block", {3, 3, 4}, 0.011, {0.029, 0.031, 0.0301}, {150, 0, -900})},
                         6e-5);
  scene.materials = {plastic_material("steel", 4e8, 0.25)};
  scene.element.bulk_viscosity = true;
  scene.contact.method = method;
  scene.contact.enforcement = enforcement;
  scene.contact.gap = gap;
  return scene;
}

/// Blocks on each other: two are glued, the glue ends, and some of its faces erode before.
Scene glued() {
  Scene scene = scene_of({block("low", {6, 6, 4}, 0.01, {0, 0, 0}, {0, 0, 60}),
                          block("high", {5, 5, 3}, 0.012, {0, 0, 0.04}, {30, 0, -60}),
                          block("top", {4, 4, 3}, 0.015, {0, 0, 0.0761}, {0, 20, -400})},
                         4e-5);
  scene.materials = {plastic_material("steel", 2e8, 0.05)};
  scene.contact.enforcement = Enforcement::lagrange;
  scene.contact.gap = ContactGap::face;
  scene.contact.friction = scene.contact.static_friction = 0.2;
  TiedContact tied;
  tied.name = "glue";
  tied.first.bodies = {"high"};
  tied.second.bodies = {"low"};
  tied.start = 2e-6;
  tied.end = 3e-5;
  scene.tied_contacts = {tied};
  return scene;
}

/// A rigid block falls on a soft one that hangs on a rigid plate, which is moved.
Scene with_rigid_bodies(Enforcement enforcement) {
  Scene scene = scene_of({block("plate", {6, 6, 1}, 0.01, {0, 0, 0}), block("soft", {5, 5, 4}, 0.01, {0, 0, 0.01}),
                          block("hammer", {3, 3, 3}, 0.01, {0.011, 0.012, 0.0505}, {20, 0, -150})},
                         6e-5);
  scene.contact.enforcement = enforcement;
  if (enforcement != Enforcement::penalty) {
    scene.contact.gap = ContactGap::face;
    scene.contact.friction = 0.3;
  }
  for (const char* name : {"plate", "hammer"}) {
    RigidBody rigid;
    rigid.name = name;
    rigid.bodies = {name};
    scene.rigid_bodies.push_back(rigid);
  }
  AttachedNodes attached;
  attached.rigid_body = "plate";
  attached.nodes.body = "soft";
  attached.nodes.plane = Plane{{0, 0, 0.01}, {0, 0, 1}};
  scene.attached_nodes = {attached};
  RigidMotion motion;
  motion.rigid_body = "plate";
  motion.direction = Point{0, 0, 1};
  motion.speed = 30;
  motion.when.start = 1e-5;
  scene.rigid_motions = {motion};
  return scene;
}

class ChangesOnRanks : public FolderTest {
 protected:
  Scene changing() const {
    const std::string path = (folder_ / "scene.toml").string();
    std::ofstream(path) << changing_scene;
    return read_scene(path);
  }
};

TEST(ContactOnRanks, ByEveryAlgorithmWhileElementsErode) {
  for (const auto& [method, enforcement, gap] :
       {std::tuple{ContactMethod::pinball, Enforcement::penalty, ContactGap::pinball},
        std::tuple{ContactMethod::pinball, Enforcement::lagrange, ContactGap::pinball},
        std::tuple{ContactMethod::pinball, Enforcement::lagrange, ContactGap::face},
        std::tuple{ContactMethod::slideline, Enforcement::penalty, ContactGap::pinball},
        std::tuple{ContactMethod::slideline, Enforcement::projection, ContactGap::pinball}}) {
    const Outcome of = expect_same_on<double>(some_ranks, eroding(method, enforcement, gap));
    EXPECT_GT(of.eroded, 20);
    EXPECT_GT(of.pairs, 0);
    EXPECT_GT(of.searches, 3);
  }
}

/// Springs that hold nothing: what lies in what at the end, their insides too, is known to rank 0.
TEST(ContactOnRanks, OfBodiesThatGoThroughEachOther) {
  Scene scene = scene_of({block("a", {6, 6, 6}, 0.01, {0, 0, 0}, {0, 0, 300}),
                          block("b", {6, 6, 6}, 0.01, {0.003, 0.002, 0.0601}, {0, 0, -300})},
                         5e-5);
  scene.contact.beta = 1e-9;
  const Outcome of = expect_same_on<double>({{3, {}}, {4, {Partition::By::random, 1}}}, scene);
  EXPECT_GT(of.numbers.back(), 100);
}

TEST(ContactOnRanks, InSinglePrecision) {
  Scene scene = eroding(ContactMethod::pinball, Enforcement::lagrange, ContactGap::face);
  scene.precision = Precision::float32;
  expect_same_on<float>({{3, {Partition::By::random, 4}}}, scene);
}

TEST(ContactOnRanks, InMixedPrecision) {
  Scene scene = eroding(ContactMethod::pinball, Enforcement::lagrange, ContactGap::face);
  scene.precision = Precision::mixed;
  EXPECT_GT(expect_same_on<double>(some_ranks, scene).pairs, 0);
}

TEST(ContactOnRanks, OfManyPartitionsAtRandom) {
  std::vector<Shared> all;
  for (std::uint64_t seed = 0; seed < 12; ++seed)
    all.push_back({2 + static_cast<int>(seed % 3), {Partition::By::random, seed}});
  expect_same_on<double>(all, eroding(ContactMethod::pinball, Enforcement::lagrange, ContactGap::face));
}

TEST(ContactOnRanks, OfTiesThatBeginEndAndBreak) {
  const Outcome of = expect_same_on<double>(some_ranks, glued());
  EXPECT_GT(of.eroded, 0);
  EXPECT_GT(of.pairs, 0);
  Scene scene = glued();
  scene.contact.method = ContactMethod::none;
  EXPECT_GT(expect_same_on<double>(some_ranks, scene).eroded, 0);
}

TEST(ContactOnRanks, OfRigidBodies) {
  for (const Enforcement enforcement : {Enforcement::lagrange, Enforcement::penalty})
    EXPECT_GT(expect_same_on<double>(some_ranks, with_rigid_bodies(enforcement)).pairs, 0);
  Scene scene = with_rigid_bodies(Enforcement::penalty);
  scene.contact.method = ContactMethod::none;
  expect_same_on<double>(some_ranks, scene);
}

/// The hammer on a guide.
TEST(ContactOnRanks, OfJointedBodies) {
  Scene scene = with_rigid_bodies(Enforcement::lagrange);
  scene.bodies[2].velocity = {0, 0, -150};
  Joint guide;
  guide.name = "guide";
  guide.kind = JointKind::translational;
  guide.bodies = {"hammer", ground};
  guide.point = Point{0.02, 0.02, 0.06};
  guide.axis = Point{0, 0, 1};
  scene.joints = {guide};
  EXPECT_GT(expect_same_on<double>(some_ranks, scene).pairs, 0);
}

TEST_F(ChangesOnRanks, WithContactAndTies) { EXPECT_GT(expect_same_on<double>(some_ranks, changing()).pairs, 0); }

TEST_F(ChangesOnRanks, Alone) {
  Scene scene = changing();
  scene.contact.method = ContactMethod::none;
  scene.tied_contacts.clear();
  expect_same_on<double>(some_ranks, scene);
}

/// From ranks to others and to one process and back, at several times.
TEST_F(ChangesOnRanks, AndContactGoOnFromAStateOnAnyOthers) {
  for (const Scene& scene : {eroding(ContactMethod::pinball, Enforcement::lagrange, ContactGap::face),
                             eroding(ContactMethod::pinball, Enforcement::penalty, ContactGap::pinball), glued(),
                             with_rigid_bodies(Enforcement::lagrange), changing()}) {
    expect_to_go_on_on_others(scene);
  }
}

}  // namespace
}  // namespace pinball::contact_on_ranks_test
