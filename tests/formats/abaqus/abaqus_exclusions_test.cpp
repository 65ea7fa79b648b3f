#include <gmock/gmock.h>

#include <solver/scene/given/toml_file.hpp>

#include "abaqus_case.hpp"

namespace pinball::test::abaqus_exclusions_test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// Three cubes, A, B and C, in a row.
class AbaqusExclusions : public AbaqusTest {
 protected:
  const std::string deck_ =
      "*PART, NAME=Cube\n" + abaqus_cube +
      "*SURFACE, NAME=skin\nCube,\n*SURFACE, NAME=lid\nCube, S2\n*SURFACE, NAME=floor\nCube, S1\n"
      "*SURFACE, NAME=points, TYPE=NODE\ntop,\n*END PART\n"
      "*ASSEMBLY\n*INSTANCE, NAME=A, PART=Cube\n*END INSTANCE\n"
      "*INSTANCE, NAME=B, PART=Cube\n0., 0., 1.5\n*END INSTANCE\n"
      "*INSTANCE, NAME=C, PART=Cube\n0., 0., 3.\n*END INSTANCE\n"
      "*ELSET, ELSET=outer\nA.Cube, C.Cube\n*SURFACE, NAME=outer\nouter,\n"
      "*SURFACE, NAME=lids\nA.Cube, S2\nB.Cube, S2\n*END ASSEMBLY\n*SURFACE INTERACTION, NAME=p\n" +
      abaqus_steel;

  std::string with(const std::string& keywords) const { return deck_ + abaqus_step("*CONTACT\n" + keywords); }
  static std::string all_but(const std::string& lines) {
    return "*CONTACT INCLUSIONS, ALL EXTERIOR\n*CONTACT EXCLUSIONS\n" + lines;
  }
  /// Pairs as "A C" of a first side alone, "A C | B" of two.
  std::vector<std::string> pairs(const std::string& keywords) {
    const auto side = [](const ContactSide& one) {
      std::vector<std::string> names = one.bodies;
      for (const MeshSetName& set : one.faces) names.push_back(set.set);
      for (const MeshSetName& set : one.nodes) names.push_back(set.set);
      return fmt::format("{}", fmt::join(names, " "));
    };
    std::vector<std::string> all;
    for (const ContactPair& pair : scene(with(keywords)).contact_pairs)
      all.push_back(side(pair.first) + (pair.second.empty() ? "" : " | " + side(pair.second)));
    return all;
  }
};

TEST_F(AbaqusExclusions, OfTwoBodiesLeaveAllOthers) {
  EXPECT_THAT(pairs(all_but("A.skin, B.skin\n")), ElementsAre("A C", "B", "B | C"));
  EXPECT_THAT(pairs(all_but("outer, B.skin\n")), ElementsAre("A C", "B"));
  EXPECT_THAT(pairs(all_but("A.skin, B.skin\nB.skin, C.skin\nC.skin, A.skin\n")), ElementsAre("A", "B", "C"));
}

TEST_F(AbaqusExclusions, OfABodyWithItselfOrWithAll) {
  EXPECT_THAT(pairs(all_but("B.skin,\n")), ElementsAre("A C", "A C | B"));
  EXPECT_THAT(pairs(all_but("B.skin, b.SKIN\n")), ElementsAre("A C", "A C | B"));
  EXPECT_THAT(pairs(all_but(", B.skin\n")), ElementsAre("A C"));
  EXPECT_THAT(pairs(all_but("outer\n")), ElementsAre("B", "A C | B"));
}

TEST_F(AbaqusExclusions, MayLeaveNothing) {
  const TranslatedDeck deck = translate(with(all_but(",\n")));
  EXPECT_THAT(write_toml(deck.given->table), HasSubstr("[contact]  # all of which is excluded\nmethod = \"none\"\n"));
  EXPECT_THAT(deck.understood, testing::Contains("contact: none, all of it is excluded"));
}

TEST_F(AbaqusExclusions, AreOfAllFacesHoweverTheyAreNamed) {
  const std::string by_faces = "*SURFACE, NAME=six\nA.Cube, S1\nA.Cube, S2\nA.Cube, S3\nA.Cube, S4\nA.Cube, S5\n";
  EXPECT_THAT(error(with(all_but("six,\n") + by_faces)), HasSubstr("*CONTACT EXCLUSIONS of six and itself"));
  EXPECT_THAT(pairs(all_but("six,\n") + by_faces + "A.Cube, S6\n"), ElementsAre("B C", "A | B C"));
}

TEST_F(AbaqusExclusions, OfAPartOfABodyAreRefusedByName) {
  EXPECT_THAT(error(with(all_but("A.skin, C.skin\nA.lid, B.floor\n"))),
              AllOf(HasSubstr("*CONTACT EXCLUSIONS of A.lid and B.floor (deck.inp:58): only whole bodies"),
                    Not(HasSubstr("C.skin"))));
  EXPECT_THAT(error(with(all_but("A.skin, B.points\n"))), HasSubstr("*CONTACT EXCLUSIONS of A.skin and B.points"));
  EXPECT_THAT(error(with(all_but("A.lid, none\n"))), HasSubstr("deck.inp:57: there is no surface none"));
}

TEST_F(AbaqusExclusions, ChangeIncludedPairs) {
  const auto included = [](const std::string& pairs, const std::string& exclusions) {
    return "*CONTACT INCLUSIONS\n" + pairs + "*CONTACT EXCLUSIONS\n" + exclusions;
  };
  EXPECT_THAT(pairs(included("A.lid, B.floor\nB.lid, C.floor\n", "A.skin, B.skin\n")), ElementsAre("B.lid | C.floor"));
  EXPECT_THAT(pairs(included("A.lid, B.floor\nB.lid, C.floor\n", "B.floor, A.lid\n")), ElementsAre("B.lid | C.floor"));
  EXPECT_THAT(pairs(included("A.points, B.floor\nB.lid, C.floor\n", "B.skin, A.skin\n")),
              ElementsAre("B.lid | C.floor"));
  EXPECT_THAT(pairs(included("A.lid, outer\n", "A.skin,\n")), ElementsAre("A.lid | C"));
  EXPECT_THAT(error(with(included("lids, C.floor\n", "A.lid, C.floor\n"))),
              HasSubstr("*CONTACT EXCLUSIONS of A.lid and C.floor"))
      << "the rest of lids has no name";
}

TEST_F(AbaqusExclusions, OfWhatDoesNotTouchAreDroppedAndTold) {
  const std::string keywords =
      "*CONTACT INCLUSIONS\nA.lid, B.floor\n*CONTACT EXCLUSIONS\nB.lid, C.floor\nA.floor, B.floor\n";
  EXPECT_THAT(pairs(keywords), ElementsAre("A.lid | B.floor"));
  EXPECT_THAT(translate(with(keywords)).understood,
              testing::IsSupersetOf({HasSubstr("deck.inp:58): not in general contact anyway"),
                                     HasSubstr("deck.inp:59): not in general contact anyway")}));
}

TEST_F(AbaqusExclusions, AreOfGeneralContactAndNotOfPairs) {
  EXPECT_THAT(pairs(all_but("A.skin, B.skin\n*CONTACT PAIR, INTERACTION=p\nA.lid, B.floor\n")),
              ElementsAre("A C", "B", "B | C", "A.lid | B.floor"));
  EXPECT_THAT(pairs(all_but("A.skin, B.skin\n*CONTACT PROPERTY ASSIGNMENT\nA.skin, B.skin, p\n")),
              ElementsAre("A C", "B", "B | C"));
}

}  // namespace
}  // namespace pinball::test::abaqus_exclusions_test
