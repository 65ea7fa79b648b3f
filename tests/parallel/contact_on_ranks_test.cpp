#include <gtest/gtest.h>

#include <fstream>
#include <tuple>
#include <vector>

#include <tests/support/changing_scene.hpp>
#include <tests/support/folder_case.hpp>
#include <tests/support/saved_state.hpp>

#include "contact_scenes.hpp"
#include "outcome.hpp"

/// Contact, ties, rigid bodies, and what begins and ends: on any ranks the bits of one process.
namespace pinball::contact_on_ranks_test {
namespace {

using namespace test;

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

TEST(ContactOnRanks, OfJointedBodies) { EXPECT_GT(expect_same_on<double>(some_ranks, with_jointed_bodies()).pairs, 0); }

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
