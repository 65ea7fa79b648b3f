#include <gmock/gmock.h>

#include <tests/formats/abaqus/abaqus_case.hpp>

#include "deck_case.hpp"

/// What has a number or a name of its own is given once; the message names both places.
namespace pinball::test::given_once_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class DeckGivenOnce : public DeckTest {
 protected:
  void expect_once(const std::string& cards, const std::string& what) {
    const std::string once = cube + elastic + ends + set_of_top;
    EXPECT_EQ(error(once + cards), no_error) << cards;
    EXPECT_THAT(error(once + cards + cards), AllOf(HasSubstr(what + " is given twice, first in deck.k:")));
  }
};

TEST_F(DeckGivenOnce, WhatHasANumber) {
  expect_once("*MAT_ELASTIC\n7,1.,2.,0.3\n", "material 7");
  expect_once("*SECTION_SOLID\n7,1\n", "section 7");
  expect_once("*HOURGLASS\n7,1\n", "hourglass control 7");
  expect_once("*DEFINE_CURVE\n7\n0.,1.\n1.,1.\n", "curve or table 7");
  expect_once("*DEFINE_TABLE\n7\n0.,1.\n1.,1.\n", "curve or table 7");
  expect_once("*DEFINE_VECTOR\n7,0,0,0,1,0,0\n", "vector 7");
  expect_once("*DEFINE_COORDINATE_VECTOR\n7,1,0,0,0,1,0\n", "local system 7");
  expect_once("*DEFINE_BOX\n7,0,1,0,1,0,1\n", "box 7");
  expect_once("*SET_PART_LIST\n7\n1\n", "set of parts 7");
  expect_once("*SET_NODE_LIST\n7\n1,2\n", "set of nodes 7");
  expect_once("*SET_SOLID\n7\n10\n", "set of solids 7");
  expect_once("*SET_SEGMENT\n7\n1,2,3,4\n", "set of segments 7");
  expect_once("*DEFINE_TRANSFORMATION\n7\nTRANSL,1,0,0\n", "transformation 7");
  expect_once("*PART\nother\n7,1,1\n", "part 7");
  expect_once("*RIGIDWALL_PLANAR_ID\n7,floor\n0\n0.,0.,-1.,0.,0.,0.\n", "rigid wall 7");
  EXPECT_THAT(error(cube + elastic + ends + elastic),
              HasSubstr("deck.k:22: material 1 is given twice, first in deck.k:18"));
  EXPECT_THAT(error(cube + "*DEFINE_CURVE\n7\n0.,1.\n*DEFINE_TABLE\n7\n0.,1.\n" + elastic + ends),
              HasSubstr("curve or table 7 is given twice"));
}

TEST_F(DeckGivenOnce, ControlsAndContacts) {
  expect_once("*CONTROL_TIMESTEP\n0.,0.8\n", "*CONTROL_TIMESTEP");
  expect_once("*CONTROL_HOURGLASS\n1,0.1\n", "*CONTROL_HOURGLASS");
  expect_once("*CONTROL_BULK_VISCOSITY\n1.5,0.06\n", "*CONTROL_BULK_VISCOSITY");
  expect_once("*DAMPING_GLOBAL\n0,1.\n", "*DAMPING_GLOBAL");
  expect_once("*DATABASE_GLSTAT\n1.\n", "*DATABASE_GLSTAT");
  expect_once("*CONTACT_AUTOMATIC_SINGLE_SURFACE_ID\n7\n0\n", "contact 7");
  EXPECT_THAT(error(cube + elastic + ends + ends),
              HasSubstr("deck.k:22: *CONTROL_TERMINATION is given twice, first in deck.k:20"));
  EXPECT_EQ(error(cube + elastic + ends + "*CONTROL_ENERGY\n2\n*CONTROL_ENERGY\n2\n"), no_error)
      << "ignored, all of it";
}

TEST_F(DeckGivenOnce, ThatOfACaseTakesThePlaceOfThatOfAll) {
  const std::string both = cube + elastic + ends + "*CASE_BEGIN_1\n*CONTROL_TERMINATION\n2.E-6\n" +
                           "*MAT_ELASTIC\n1,1.,2.,0.3\n*CASE_END_1\n";
  DeckOptions first;
  first.chosen_case = 1;
  EXPECT_EQ(scene(both, first).time.end, 2e-6);
  EXPECT_EQ(scene(both, first).materials.at(0).density, 1);
  EXPECT_EQ(scene(both).time.end, 1e-6);
}

/// A case has a contact beside that of all cases: both are done, and the later has no name.
TEST_F(DeckGivenOnce, ContactsOfOneNumberHaveOneName) {
  const auto contact = [](const std::string& friction) {
    return "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_ID\n7\n1,1,3,3\n" + friction + "\n\n";
  };
  DeckOptions first;
  first.chosen_case = 1;
  const Scene s =
      scene(cube + elastic + ends + contact("0.1") + "*CASE_BEGIN_1\n" + contact("0.2") + "*CASE_END_1\n", first);
  ASSERT_EQ(s.contact_pairs.size(), 2U);
  EXPECT_EQ(s.contact_pairs[0].name, "contact_7");
  EXPECT_NE(s.contact_pairs[1].name, "contact_7");
  EXPECT_EQ(s.contact_pairs[1].friction, 0.2);
}

TEST_F(DeckGivenOnce, NumbersThatAreTitlesOfOthersFindTheirOwn) {
  const std::string sets = "*SET_NODE_LIST_TITLE\n8\n7\n1,2\n*SET_NODE_LIST_TITLE\n7\n8\n5,6,7,8\n";
  const Scene s = scene(cube + elastic + ends + sets + "*BOUNDARY_SPC_SET\n7,0,1,1,1\n");
  EXPECT_EQ(build_model<double>(s).constraints.size(), 6u) << "of two nodes, and not of four";
}

class AbaqusGivenOnce : public AbaqusTest {
 protected:
  void expect_once(const std::string& keywords, const std::string& what) {
    EXPECT_EQ(error(abaqus_cube + abaqus_steel + keywords + abaqus_step()), no_error) << keywords;
    EXPECT_THAT(error(abaqus_cube + abaqus_steel + keywords + keywords + abaqus_step()),
                HasSubstr(what + " is given twice, first in deck.inp:"));
  }
};

TEST_F(AbaqusGivenOnce, WhatHasAName) {
  expect_once("*MATERIAL, NAME=Other\n*DENSITY\n1.\n", "*MATERIAL OTHER");
  expect_once("*AMPLITUDE, NAME=a\n0., 0., 1., 1.\n", "*AMPLITUDE A");
  expect_once("*SECTION CONTROLS, NAME=a\n", "*SECTION CONTROLS A");
  expect_once("*SURFACE INTERACTION, NAME=a\n", "*SURFACE INTERACTION A");
  expect_once("*SURFACE, NAME=a\nCube, S1\n", "surface A");
  EXPECT_THAT(
      error(abaqus_cube + abaqus_steel + "*material, name=STEEL\n*DENSITY\n1.\n*ELASTIC\n1.,0.\n" + abaqus_step()),
      HasSubstr("deck.inp:23: *MATERIAL STEEL is given twice, first in deck.inp:18"));
}

TEST_F(AbaqusGivenOnce, OptionsOfMaterialsAndOfSteps) {
  expect_once("*PLASTIC\n300., 0.\n", "*PLASTIC at the rate 0 of one material");
  expect_once("*DAMPING, ALPHA=1.\n", "*DAMPING of one material");
  const auto twice = [&](const std::string& keywords) {
    return error(abaqus_cube + abaqus_steel + abaqus_step(keywords + keywords));
  };
  EXPECT_THAT(twice("*BULK VISCOSITY\n0.06, 1.2\n"), HasSubstr("*BULK VISCOSITY of step 1 is given twice"));
  EXPECT_THAT(twice("*FIXED MASS SCALING, DT=1E-7, TYPE=BELOW MIN\n"), HasSubstr("*FIXED MASS SCALING of step 1"));
  EXPECT_THAT(error(abaqus_cube + abaqus_steel + abaqus_step("*DYNAMIC, EXPLICIT\n, 2.E-6\n")),
              HasSubstr("*DYNAMIC of step 1 is given twice"));
  EXPECT_EQ(error(abaqus_cube + abaqus_steel + abaqus_step() + abaqus_step()), no_error);
}

TEST_F(AbaqusGivenOnce, PartsInstancesAndSections) {
  const std::string part = "*PART, NAME=p\n" + abaqus_cube + "*END PART\n";
  const std::string instance = "*INSTANCE, NAME=i, PART=p\n*END INSTANCE\n";
  EXPECT_THAT(error(part + part + abaqus_steel + abaqus_step()),
              HasSubstr("part P is given twice, first in deck.inp:1"));
  EXPECT_THAT(error(part + "*ASSEMBLY\n" + instance + instance + "*END ASSEMBLY\n" + abaqus_steel + abaqus_step()),
              HasSubstr("instance I is given twice, first in deck.inp:21"));
  EXPECT_THAT(error(abaqus_cube + "*SOLID SECTION, ELSET=Cube, MATERIAL=Steel\n" + abaqus_steel + abaqus_step()),
              HasSubstr("deck.inp:18: *SOLID SECTION: element 10 is in that of Cube, too, deck.inp:16"));
}

}  // namespace
}  // namespace pinball::test::given_once_test
