#include <gmock/gmock.h>

#include <solver/model/model.hpp>

#include "deck_case.hpp"

/// *CONTACT_... of decks: pairs of bodies and sets, ties, and what is refused.
namespace pinball::test::deck_contacts_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class DeckContacts : public DeckTest {};

/// A second cube, of part 2, above the first.
const std::string two_cubes = cube + "*NODE\n" + square_lines(11, 1.1) + square_lines(15, 2) +
                              "*ELEMENT_SOLID\n20,2,11,12,13,14,15,16,17,18\n*PART\ncube\n2,1,1\n" + elastic + ends;

TEST_F(DeckContacts, OfTwoPartsAreAPair) {
  const Scene s =
      scene(two_cubes + "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_ID\n7,name\n1,2,3,3\n0.3,0.1,5.,0,0,0,1.0E-7,2.0E-7\n");
  EXPECT_EQ(s.bodies.at(1).name, "part_2") << "a second title of that name";
  EXPECT_EQ(s.contact.method, ContactMethod::pinball);
  const ContactPair& pair = s.contact_pairs.at(0);
  EXPECT_EQ(pair.name, "contact_7");
  EXPECT_THAT(pair.first.bodies, ElementsAre("cube"));
  EXPECT_THAT(pair.second.bodies, ElementsAre("part_2"));
  EXPECT_EQ(pair.friction, 0.1);
  EXPECT_EQ(pair.static_friction, 0.3);
  EXPECT_EQ(pair.friction_decay, 5);
  EXPECT_EQ(pair.start, 1e-7);
  EXPECT_EQ(pair.end, 2e-7);
}

TEST_F(DeckContacts, OfASingleSurfaceOfAllNeedNoPairs) {
  const Scene all = scene(two_cubes + "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0\n0.2,0.1\n");
  EXPECT_TRUE(all.contact_pairs.empty());
  EXPECT_TRUE(all.contact.self);
  EXPECT_EQ(all.contact.friction, 0.2) << "without DC the coefficient is FS";
  const Scene one = scene(two_cubes + "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n1,0,3\n\n");
  ASSERT_EQ(one.contact_pairs.size(), 1u);
  EXPECT_THAT(one.contact_pairs[0].first.bodies, ElementsAre("cube"));
  EXPECT_TRUE(one.contact_pairs[0].second.empty());
}

/// One line more, and a second one where it begins with &.
TEST_F(DeckContacts, MayHaveLinesOfProcessors) {
  const std::string sides = "1,2,3,3\n0.3\n";
  for (const std::string& lines : {std::string("0,200\n"), std::string("\n"), std::string("0,200\n&,1\n")}) {
    for (const char* options : {"_MPP\n", "_ID_MPP\n7\n", "_MPP_ID\n7\n"}) {
      const Scene s = scene(two_cubes + "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE" + options + lines + sides);
      ASSERT_EQ(s.contact_pairs.size(), 1U);
      EXPECT_THAT(s.contact_pairs[0].second.bodies, ElementsAre("part_2"));
      EXPECT_EQ(s.contact_pairs[0].friction, 0.3);
    }
  }
  const std::string named = "*PARAMETER\nI one,1\n*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_MPP\n\n&one,2,3,3\n0.3\n";
  EXPECT_THAT(scene(two_cubes + named).contact_pairs.at(0).first.bodies, ElementsAre("cube")) << "a parameter";
  const auto told = translate(two_cubes + "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_MPP\n1,100\n&,1,0.5\n" + sides);
  for (const char* field : {"IGNORE", "BCKT", "CHKSEGS", "PENSF"})
    EXPECT_THAT(told.understood,
                testing::Contains(HasSubstr("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_MPP: " + std::string(field))));
  EXPECT_THAT(told.understood, testing::Not(testing::Contains(HasSubstr("field 1"))));
}

/// All of one surface, whatever else the keyword says.
TEST_F(DeckContacts, OfOtherNamesAreTheSame) {
  for (const char* name : {"AUTOMATIC_GENERAL_INTERIOR", "AIRBAG_SINGLE_SURFACE"}) {
    const Scene s = scene(two_cubes + "*CONTACT_" + name + "\n0\n0.2\n");
    EXPECT_TRUE(s.contact.self) << name;
    EXPECT_EQ(s.contact.friction, 0.2) << name;
  }
  for (const char* name : {"NODES_TO_SURFACE_CONSTRAINED", "SURFACE_TO_SURFACE_CONSTRAINED", "SURFACE_TO_SURFACE_BEAM"})
    EXPECT_DOUBLE_EQ(
        scene(two_cubes + "*CONTACT_TIED_" + name + "_OFFSET\n2,1,3,3\n\n,,-0.1,-0.1\n").tied_contacts.at(0).tolerance,
        0.12);
}

TEST_F(DeckContacts, MayBeOfSets) {
  const std::string sets =
      "*SET_PART_LIST\n4\n2\n*SET_SEGMENT\n5\n5,6,7,8\n*SET_NODE_LIST\n6\n11,12\n*SET_PART_LIST\n9\n1\n";
  const Scene s = scene(two_cubes + sets +
                        "*CONTACT_ERODING_SURFACE_TO_SURFACE\n4,5,2,0\n0.5\n,,,,,,0.5\n1,1,1\n"
                        "*CONTACT_AUTOMATIC_NODES_TO_SURFACE\n6,9,4,6\n\n*CONTACT_NODES_TO_SURFACE\n6,5,4,0\n");
  ASSERT_EQ(s.contact_pairs.size(), 3u);
  EXPECT_THAT(s.contact_pairs[0].first.bodies, ElementsAre("part_2"));
  EXPECT_EQ(s.contact_pairs[0].second.faces.at(0).set, "5");
  EXPECT_EQ(s.contact_pairs[0].friction, 0.25) << "FSF";
  EXPECT_EQ(s.contact_pairs[1].first.nodes.at(0).set, "6");
  EXPECT_THAT(s.contact_pairs[1].second.bodies, ElementsAre("part_2")) << "all but set 9";
  EXPECT_EQ(s.contact_pairs[2].second.faces.at(0).set, "5");
}

TEST_F(DeckContacts, MayBeTied) {
  const Scene s = scene(two_cubes + "*CONTACT_TIED_SURFACE_TO_SURFACE_OFFSET_ID\n3,glue\n2,1,3,3\n\n,,-0.1,-0.1\n");
  EXPECT_EQ(s.contact.method, ContactMethod::none);
  const TiedContact& tied = s.tied_contacts.at(0);
  EXPECT_EQ(tied.name, "contact_3");
  EXPECT_THAT(tied.first.bodies, ElementsAre("part_2"));
  EXPECT_DOUBLE_EQ(tied.tolerance, 0.12);
  for (const std::string one_of_both : {",,-0.1,", ",,,-0.1"}) {
    const std::string cards = "*CONTACT_TIED_SURFACE_TO_SURFACE_OFFSET\n2,1,3,3\n\n";
    EXPECT_DOUBLE_EQ(scene(two_cubes + cards + one_of_both + "\n").tied_contacts.at(0).tolerance, 0.06) << one_of_both;
  }
  EXPECT_EQ(build_model<double>(s).tie_counts.at(0).nodes, 4);
  const Scene far = scene(two_cubes + "*CONTACT_TIED_NODES_TO_SURFACE\n2,1,3,3\n");
  EXPECT_EQ(build_model<double>(far).tie_counts.at(0).nodes, 0) << "0.1 is more than 0.05 of the diagonal";
  EXPECT_EQ(build_model<double>(far).tie_counts[0].near, 4);
}

TEST_F(DeckContacts, InsideBodiesAreReported) {
  EXPECT_THAT(translate(two_cubes + "*CONTACT_INTERIOR\n3\n").understood,
              testing::Contains(HasSubstr("corners that are about to turn over resist in any case")));
  EXPECT_EQ(scene(two_cubes + "*CONTACT_INTERIOR\n3\n").contact.method, ContactMethod::none);
}

TEST_F(DeckContacts, OneWayAndMortarAreAsWithout) {
  const auto given = [&](const std::string& name, const std::string& lines) {
    return scene(two_cubes + "*CONTACT_" + name + "\n" + lines);
  };
  const std::string sides = "1,2,3,3\n0.3,0.1,5.\n";
  for (const char* name :
       {"AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE", "ONE_WAY_SURFACE_TO_SURFACE", "AUTOMATIC_SURFACE_TO_SURFACE_MORTAR"}) {
    const Scene s = given(name, sides);
    const ContactPair& pair = s.contact_pairs.at(0);
    EXPECT_THAT(pair.first.bodies, ElementsAre("cube")) << name;
    EXPECT_THAT(pair.second.bodies, ElementsAre("part_2")) << name;
    EXPECT_EQ(pair.static_friction, 0.3) << name;
  }
  EXPECT_EQ(given("AUTOMATIC_SINGLE_SURFACE_MORTAR", "0\n").contact.method, ContactMethod::pinball);
  EXPECT_TRUE(given("AUTOMATIC_SINGLE_SURFACE_MORTAR_ID", "4,all\n0\n").contact_pairs.empty());
  EXPECT_THAT(translate(two_cubes + "*CONTACT_AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE\n" + sides).understood,
              testing::Contains(HasSubstr("both sides touch each other, not the first the second alone")));
}

TEST_F(DeckContacts, ThatWouldBeOthersAreRefused) {
  const auto refused = [&](const std::string& cards) { return error(two_cubes + cards); };
  EXPECT_THAT(refused("*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0,0,0,0,4\n"), HasSubstr("with SBOXID"));
  EXPECT_THAT(refused("*CONTACT_AUTOMATIC_SINGLE_SURFACE\n3,0,1\n"), HasSubstr("SSTYP or MSTYP 1"));
  EXPECT_THAT(refused("*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0\n-1.0\n"), HasSubstr("FS = -1"));
  EXPECT_THAT(refused("*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0\n0.1,0.1,0,3.\n"), HasSubstr("friction stress (VC)"));
  EXPECT_THAT(refused("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK\n1,2,3,3\n"), HasSubstr("TIEBREAK"));
}

}  // namespace
}  // namespace pinball::test::deck_contacts_test
