#include <gtest/gtest.h>

#include <cmath>

#include <solver/formats/lsdyna/cards/keyword_scene.hpp>
#include <solver/formats/radioss/cards/radioss_scene.hpp>
#include <solver/simulation.hpp>

namespace pinball::test::radioss_decks_test {
namespace {

std::string own(const std::string& name) { return std::string(PINBALL_SOURCE_DIR "/data/decks/radioss/") + name; }

Simulation run(const TranslatedDeck& deck, const std::string& path) {
  Simulation s(read_scene(deck.source(path)));
  s.run();
  return s;
}

/// The same scene in the keywords of LS-DYNA.
void expect_same_bits(const std::string& name) {
  const std::string of_radioss = own(name + "_0000.rad"), of_dyna = own(name + ".k");
  const Simulation first = run(translate_radioss(of_radioss), of_radioss),
                   second = run(translate_deck(of_dyna), of_dyna);
  EXPECT_EQ(first.steps(), second.steps());
  EXPECT_EQ(first.state_hash(), second.state_hash()) << name;
}

TEST(RadiossDecks, ATaylorBarHasTheBitsOfTheOneOfLsDyna) { expect_same_bits("taylor_bar"); }
TEST(RadiossDecks, TwoBarsHaveTheBitsOfThoseOfLsDyna) { expect_same_bits("blocks"); }

TEST(RadiossDecks, BarsSwapTheirVelocities) {
  const std::string path = own("blocks_0000.rad");
  const Simulation s = run(translate_radioss(path), path);
  EXPECT_NEAR(s.bodies()[0].velocity[2], -10, 0.5);
  EXPECT_NEAR(s.bodies()[1].velocity[2], 0, 0.5);
  EXPECT_NEAR(s.bodies()[0].velocity[2] + s.bodies()[1].velocity[2], -10, 1e-9) << "momentum";
}

}  // namespace
}  // namespace pinball::test::radioss_decks_test
