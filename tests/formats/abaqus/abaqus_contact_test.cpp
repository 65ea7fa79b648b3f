#include <gmock/gmock.h>

#include "abaqus_case.hpp"

/// Surfaces of Abaqus input that touch or are tied.
namespace pinball::test::abaqus_contact_test {
namespace {

using testing::Contains;
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

/// Of CalculiX.
TEST_F(AbaqusContact, IsMasslessNowhere) {
  const TranslatedDeck deck =
      translate(cubes + abaqus_step("*CONTACT PAIR, INTERACTION=p, TYPE=massless\nHigh.lower, Low.upper\n"));
  EXPECT_THAT(deck.understood, Contains(HasSubstr("*CONTACT PAIR, TYPE=MASSLESS")));
  EXPECT_EQ(read_scene(deck.source(path_)).contact_pairs.at(0).friction, 0.1);
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

TEST_F(AbaqusContact, IsTied) {
  const Scene tied =
      scene(cubes + "*TIE, NAME=t, ADJUST=YES, POSITION TOLERANCE=0.6\nHigh.lower, Low.upper\n" + abaqus_step());
  EXPECT_EQ(tied.tied_contacts.at(0).tolerance, 0.6);
}

}  // namespace
}  // namespace pinball::test::abaqus_contact_test
