#include <gmock/gmock.h>

#include "abaqus_case.hpp"

/// *CLOAD, *DLOAD, *DSLOAD and initial velocities: what of them is given more than once, or of a kind that
/// is not read.
namespace pinball::test::abaqus_loads_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

class AbaqusLoads : public AbaqusTest {
 protected:
  std::vector<std::string> notes(const std::string& loads) {
    return translate(abaqus_cube + abaqus_steel + "*SURFACE, NAME=s, TYPE=ELEMENT\nCube, S2\n" + abaqus_step(loads))
        .understood;
  }
};

/// As in CalculiX.
TEST_F(AbaqusLoads, OfOneNodeAndDegreeAddUpAndAreReported) {
  const std::string twice = "*CLOAD\n5, 1, 2.\n*CLOAD\ntop, 1, 3.\n";
  EXPECT_EQ(scene(abaqus_cube + abaqus_steel + abaqus_step(twice)).loads.size(), 2U);
  EXPECT_THAT(notes(twice), Contains(AllOf(HasSubstr("*CLOAD ("), HasSubstr(".inp:31): 1 load that is there already, "
                                                                            "the first is that of node 5 along x; "
                                                                            "both act, and add up"))));
  EXPECT_THAT(notes("*CLOAD\ntop, 2, 2.\ntop, 2, 2.\n"), Contains(HasSubstr("4 loads that are there already")));
  EXPECT_THAT(notes("*DLOAD\nCube, P2, 2.\n10, P2, 2.\n"), Contains(HasSubstr("the first is P2 of element 10")));
  EXPECT_THAT(notes("*DLOAD\n, GRAV, 9., 0., 0., -1.\nCube, GRAV, 9., 0., 0., -1.\n"),
              Contains(HasSubstr("the first is GRAV of Cube along 0. 0. -1.")));
  EXPECT_THAT(notes("*DSLOAD\ns, P, 2.\ns, P, 2.\n"), Contains(HasSubstr("the first is P of surface s")));
}

TEST_F(AbaqusLoads, OfOtherNodesDirectionsAndFacesAreNot) {
  for (const char* loads : {"*CLOAD\n5, 1, 2.\n6, 1, 2.\n5, 2, 2.\n", "*DLOAD\nCube, P2, 2.\nCube, P1, 2.\n",
                            "*DLOAD\n, GRAV, 9., 0., 0., -1.\n, GRAV, 9., 1., 0., 0.\n"})
    EXPECT_THAT(notes(loads), Not(Contains(HasSubstr("already")))) << loads;
}

TEST_F(AbaqusLoads, OfKindsThatAreNotReadAreRefused) {
  for (const std::string kind : {"P0", "P7", "P9", "PX", "P12", "P", "BX", "CENTRIF"})
    EXPECT_THAT(error(abaqus_cube + abaqus_steel + abaqus_step("*DLOAD\nCube, " + kind + ", 2.\n")),
                AllOf(HasSubstr("for this version has not"), HasSubstr("*DLOAD, " + kind + " (")))
        << kind;
}

TEST_F(AbaqusLoads, InitialVelocitiesThatLaterLinesReplaceAreReported) {
  const auto lines = [&](const std::string& velocities) {
    return translate(abaqus_cube + abaqus_steel + "*INITIAL CONDITIONS, TYPE=VELOCITY\n" + velocities + abaqus_step())
        .understood;
  };
  EXPECT_THAT(lines("5, 1, 1.\ntop, 1, 3.\n"),
              Contains(AllOf(HasSubstr("*INITIAL CONDITIONS ("),
                             HasSubstr("takes the place of what lines before give 1 of its nodes"))));
  EXPECT_THAT(lines("5, 1, 1.\ntop, 2, 3.\n"), Not(Contains(HasSubstr("takes the place"))));
}

}  // namespace
}  // namespace pinball::test::abaqus_loads_test
