#include <gmock/gmock.h>

#include "abaqus_case.hpp"

/// Surfaces of Abaqus input that touch or are tied.
namespace pinball::test::abaqus_contact_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

/// Two cubes one above the other, with a surface of nodes on one of faces.
const std::string cubes =
    "*PART, NAME=Cube\n" + abaqus_cube + "*SURFACE, NAME=upper\nCube, S2\n*SURFACE, NAME=lower, TYPE=NODE\nbase,\n" +
    "*END PART\n*ASSEMBLY, NAME=A\n*INSTANCE, NAME=Low, PART=Cube\n*END INSTANCE\n*INSTANCE, NAME=High, PART=Cube\n"
    "0., 0., 1.5\n*END INSTANCE\n*END ASSEMBLY\n" +
    abaqus_steel +
    "*SURFACE INTERACTION, NAME=p\n*FRICTION, EXPONENTIAL DECAY\n0.3, 0.1, 2.\n*SURFACE INTERACTION, NAME=q\n";

class AbaqusContact : public AbaqusTest {
 protected:
  Scene contact(const std::string& keywords) { return scene(cubes + abaqus_step(keywords)); }
};

TEST_F(AbaqusContact, IsOfPairs) {
  const Scene one = contact("*CONTACT PAIR, INTERACTION=p\nHigh.lower, Low.upper\n");
  ASSERT_EQ(one.contact_pairs.size(), 1u);
  EXPECT_EQ(one.contact_pairs[0].friction, 0.1);
  EXPECT_EQ(one.contact_pairs[0].static_friction, 0.3);
  EXPECT_EQ(one.contact_pairs[0].friction_decay, 2);
  EXPECT_THAT(error(cubes + abaqus_step("*CONTACT PAIR, INTERACTION=p\nHigh.none, Low.upper\n")),
              HasSubstr("there is no surface High.none"));
  EXPECT_THAT(error(cubes + abaqus_step("*CONTACT PAIR, INTERACTION=r\nHigh.lower, Low.upper\n")),
              HasSubstr("there is no *SURFACE INTERACTION r"));
}

/// mu = mu_k + (mu_s - mu_k) exp(-d v), whichever of the two is more; without d it stays mu_s.
TEST_F(AbaqusContact, FrictionMayGrowWithTheSpeed) {
  const auto with = [](const std::string& friction) {
    std::string text = cubes;
    text.replace(text.find("0.3, 0.1, 2.\n"), 13, friction);
    return text + abaqus_step("*CONTACT PAIR, INTERACTION=p\nHigh.lower, Low.upper\n");
  };
  const Scene grows = scene(with("0.1, 0.3, 2.\n"));
  EXPECT_EQ(grows.contact_pairs.at(0).static_friction, 0.1);
  EXPECT_EQ(grows.contact_pairs.at(0).friction, 0.3);
  EXPECT_EQ(grows.contact_pairs.at(0).friction_decay, 2);
  const Scene stays = scene(with("0.3, 0.1\n"));
  EXPECT_EQ(stays.contact_pairs.at(0).friction, 0.3);
  EXPECT_THAT(translate(with("0.3, 0.1\n")).understood, Contains(HasSubstr("*FRICTION: coefficient while sliding")));
}

/// Springs stand for hard contact where they give way less than an element, here of 1 mm: E/k = 0.021 of one.
TEST_F(AbaqusContact, OfSpringsIsHardAndSaysHowFarTheyGiveWay) {
  const std::string pair = abaqus_step("*CONTACT PAIR, INTERACTION=s\nHigh.lower, Low.upper\n");
  const auto springs = [&](const std::string& line) {
    return cubes + "*SURFACE INTERACTION, NAME=s\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n" + line;
  };
  const TranslatedDeck deck = translate(springs("1.E7, 0.1, 0.001\n") + pair);
  EXPECT_THAT(deck.understood,
              Contains(AllOf(
                  HasSubstr("*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR"), HasSubstr("hard contact in its place"),
                  HasSubstr("overlap by pressure/1e+07: 2.1e-05 at a thousandth of Young's modulus 210000, or "
                            "0.021 of what an element gives way"))));
  EXPECT_THAT(deck.understood, Contains(HasSubstr("not used: *SURFACE BEHAVIOR: sigma-infinity")));
  EXPECT_THAT(deck.understood, Contains(HasSubstr("not used: *SURFACE BEHAVIOR: c0")));
  EXPECT_EQ(read_scene(deck.source(path_)).contact_pairs.size(), 1u);
  EXPECT_THAT(error(springs("1.E5\n") + pair), HasSubstr("as soft as 2.1 elements one behind the other"));
  EXPECT_THAT(error(springs("0.\n") + pair), HasSubstr("slope: expected more than 0, got 0"));
  EXPECT_THAT(error(springs("") + pair), HasSubstr("expected the slope of the pressure over the overclosure"));
  EXPECT_THAT(translate(springs("1.\n") + abaqus_step()).understood,
              Contains(HasSubstr("not used: *SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR")))
      << "an interaction of nothing";
}

TEST_F(AbaqusContact, OfSpringsBetweenRigidBodiesIsRefused) {
  std::string rigid = cubes + "*SURFACE INTERACTION, NAME=s\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n1.E7\n";
  rigid.insert(rigid.find("*END PART"),
               "*NODE, NSET=centre\n99, 0.5, 0.5, 0.5\n*RIGID BODY, REF NODE=centre, ELSET=Cube\n");
  EXPECT_THAT(error(rigid + abaqus_step("*CONTACT PAIR, INTERACTION=s\nHigh.lower, Low.upper\n")),
              HasSubstr("*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR of bodies that are all rigid"));
}

/// Of CalculiX.
TEST_F(AbaqusContact, IsMasslessNowhere) {
  const TranslatedDeck deck =
      translate(cubes + abaqus_step("*CONTACT PAIR, INTERACTION=p, TYPE=massless\nHigh.lower, Low.upper\n"));
  EXPECT_THAT(deck.understood, Contains(HasSubstr("*CONTACT PAIR, TYPE=MASSLESS")));
  EXPECT_EQ(read_scene(deck.source(path_)).contact_pairs.at(0).friction, 0.1);
}

/// Of faces as they are, it is the same where they slide little.
TEST_F(AbaqusContact, SlidesAsFarAsItDoes) {
  const TranslatedDeck deck =
      translate(cubes + abaqus_step("*CONTACT PAIR, INTERACTION=p, SMALL SLIDING\nHigh.lower, Low.upper\n"));
  EXPECT_THAT(deck.understood, Contains(HasSubstr("not used: *CONTACT PAIR, SMALLSLIDING")));
  EXPECT_EQ(read_scene(deck.source(path_)).contact_pairs.size(), 1U);
}

/// Of CalculiX, too.
TEST_F(AbaqusContact, OutputOfItIsIgnored) {
  EXPECT_THAT(translate(cubes + abaqus_step("*CONTACT PRINT, MASTER=a, SLAVE=b\nCF\n*CONTACT FILE\nCDIS\n")).ignored,
              ElementsAre(HasSubstr("*CONTACT PRINT"), HasSubstr("*CONTACT FILE")));
  EXPECT_THAT(translate(cubes + abaqus_step("*SECTION PRINT, SURFACE=a, NAME=s\nSOF\n*SECTION FILE\nSOF\n")).ignored,
              ElementsAre(HasSubstr("*SECTION PRINT"), HasSubstr("*SECTION FILE")));
}

TEST_F(AbaqusContact, IsGeneral) {
  const Scene included = contact(
      "*CONTACT\n*CONTACT INCLUSIONS\nHigh.lower, Low.upper\n, Low.upper\n"
      "*CONTACT PROPERTY ASSIGNMENT\n, , p\n");
  ASSERT_EQ(included.contact_pairs.size(), 2u);
  EXPECT_EQ(included.contact.friction, 0.1);
  const Scene assigned = contact(
      "*CONTACT\n*CONTACT INCLUSIONS, ALL EXTERIOR\n"
      "*CONTACT PROPERTY ASSIGNMENT\n, , q\nHigh.lower, Low.upper, p\n");
  ASSERT_EQ(assigned.contact_pairs.size(), 2u) << "all, and then these two";
  EXPECT_EQ(assigned.contact.friction, 0);
}

/// "To modify contact properties for specific contact interactions within the domain considered by general contact".
TEST_F(AbaqusContact, AnAssignmentMakesNothingTouchThatIsNotIncluded) {
  const auto with = [](const std::string& included, const std::string& assigned) {
    const std::string surfaces = "*SURFACE, NAME=whole\nLow.Cube,\n*SURFACE, NAME=both\nLow.Cube,\nHigh.Cube,\n";
    return std::string(cubes).insert(cubes.find("*END ASSEMBLY"), surfaces) +
           abaqus_step("*CONTACT\n*CONTACT PROPERTY ASSIGNMENT\n" + assigned + "*CONTACT INCLUSIONS\n" + included);
  };
  const std::string low = "whole,\n", said = "*CONTACT INCLUSIONS do not let these touch";
  EXPECT_EQ(scene(with(low, "High.upper, Low.upper, p\n")).contact_pairs.size(), 1u);
  EXPECT_THAT(translate(with(low, "High.upper, Low.upper, p\n")).understood, Contains(HasSubstr(said)));
  EXPECT_THAT(error(with(low, "both, , p\n")), HasSubstr("*CONTACT INCLUSIONS let a part of these touch"));
  const Scene partly = scene(with(low, "Low.upper, , p\n"));
  ASSERT_EQ(partly.contact_pairs.size(), 2u) << "the upper face is of what may touch itself";
  EXPECT_EQ(partly.contact_pairs[1].friction, 0.1) << "behind the pair that it is a part of";
  const Scene same = scene(with("High.lower, Low.upper\n", "Low.upper, High.lower, p\n"));
  EXPECT_EQ(same.contact_pairs.size(), 2u) << "of nodes, too";
}

/// "If the contact property assignments overlap, the last assignment applies in the overlap region."
TEST_F(AbaqusContact, TheLastAssignmentCounts) {
  const auto with = [](const std::string& assigned) {
    return cubes +
           abaqus_step("*CONTACT\n*CONTACT INCLUSIONS, ALL EXTERIOR\n*CONTACT PROPERTY ASSIGNMENT\n" + assigned);
  };
  const Scene all = scene(with("High.upper, Low.upper, p\n, , q\n"));
  EXPECT_EQ(all.contact_pairs.size(), 0u);
  EXPECT_EQ(all.contact.friction, 0);
  EXPECT_THAT(translate(with("High.upper, Low.upper, p\n, , q\n")).understood,
              Contains(AllOf(HasSubstr("of two surfaces ("), HasSubstr("one of all stands behind it, and counts"))));
  EXPECT_EQ(scene(with(", , q\nHigh.upper, Low.upper, p\n")).contact_pairs.size(), 2u);
}

TEST_F(AbaqusContact, IsTied) {
  const Scene tied =
      scene(cubes + "*TIE, NAME=t, ADJUST=YES, POSITION TOLERANCE=0.6\nHigh.lower, Low.upper\n" + abaqus_step());
  EXPECT_EQ(tied.tied_contacts.at(0).tolerance, 0.6);
}

}  // namespace
}  // namespace pinball::test::abaqus_contact_test
