#include <gmock/gmock.h>

#include <set>

#include <solver/formats/abaqus/mesh/abaqus_mesh.hpp>

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

/// Faces of a C3D8 are numbered by its eight places, whichever nodes stand there: S3 is 1, 2, 6, 5.
TEST_F(AbaqusLoads, FacesOfCollapsedHexahedraAreThoseOfTheirPlaces) {
  struct Form {
    const char* nodes;
    std::vector<std::vector<std::int64_t>> faces;  ///< P1 to P6; empty: it has no area
  };
  const std::vector<Form> forms{
      {"1, 2, 3, 4, 5, 5, 5, 5", {{1, 2, 3, 4}, {}, {1, 2, 5, 5}, {2, 3, 5, 5}, {3, 4, 5, 5}, {1, 4, 5, 5}}},
      {"1, 2, 3, 3, 5, 6, 7, 7", {{1, 2, 3, 3}, {5, 6, 7, 7}, {1, 2, 5, 6}, {2, 3, 6, 7}, {}, {1, 3, 5, 7}}},
      {"1, 2, 3, 3, 5, 5, 5, 5", {{1, 2, 3, 3}, {}, {1, 2, 5, 5}, {2, 3, 5, 5}, {}, {1, 3, 5, 5}}}};
  const auto different = [](const auto& face) { return std::set<std::int64_t>(face.begin(), face.end()); };
  for (const Form& form : forms) {
    std::string collapsed = abaqus_cube;
    collapsed.replace(collapsed.find("1, 2, 3, 4, 5, 6, 7, 8"), 22, form.nodes);
    for (int side = 1; side <= 6; ++side) {
      const std::string surface = fmt::format("*SURFACE, NAME=s\nCube, S{}\n", side);
      const std::string text = collapsed + surface + abaqus_steel;
      const std::string load = abaqus_step(fmt::format("*DLOAD\nCube, P{}, 2.\n", side));
      const Scene s = scene(text + load);
      const MeshFile file = abaqus_mesh(parse_abaqus_deck(text + load, "deck.inp")).file;
      const FaceSet& set = *find_set(file.face_sets, "s");
      const std::vector<std::int64_t>& expected = form.faces[side - 1];
      ASSERT_EQ(s.pressures.size(), expected.empty() ? 0U : 1U) << form.nodes << " P" << side;
      ASSERT_EQ(set.faces.size(), s.pressures.size());
      if (expected.empty()) {
        EXPECT_THAT(translate(text + load).understood, Contains(HasSubstr("nodes that are the same leave no face")));
        continue;
      }
      ASSERT_EQ(s.pressures[0].corners.size(), 1U);
      EXPECT_EQ(different(s.pressures[0].corners[0]), different(expected)) << form.nodes << " P" << side;
      std::set<std::int64_t> of_set;
      for (const std::int32_t node : set.faces[0]) of_set.insert(file.node_ids[node]);
      EXPECT_EQ(of_set, different(expected)) << form.nodes << " S" << side;
    }
  }
}

TEST_F(AbaqusLoads, OfKindsThatAreNotReadAreRefused) {
  for (const std::string kind : {"P0", "P7", "P9", "PX", "P12", "P", "BX", "CENTRIF"})
    EXPECT_THAT(error(abaqus_cube + abaqus_steel + abaqus_step("*DLOAD\nCube, " + kind + ", 2.\n")),
                AllOf(HasSubstr("for this version has not"), HasSubstr("*DLOAD, " + kind + " (")))
        << kind;
}

TEST_F(AbaqusLoads, NodesMayBeginWithASpin) {
  const std::string model = abaqus_cube + abaqus_steel,
                    spin = "*INITIAL CONDITIONS, TYPE=ROTATING VELOCITY, DEFINITION=COORDINATES\ntop, 3., 1., 2.\n";
  const Scene s = scene(model + spin + "0.5, 0.25, 0., 0.5, 0.25, 2.\n" + abaqus_step());
  ASSERT_EQ(s.initial_velocities.size(), 1U);
  EXPECT_EQ(s.initial_velocities[0].nodes.set, "top");
  EXPECT_EQ(s.initial_velocities[0].velocity, (Point{1, 2, 0}));
  EXPECT_EQ(s.initial_velocities[0].angular_velocity, (Point{0, 0, 3}));
  EXPECT_EQ(s.initial_velocities[0].centre, (Point{0.5, 0.25, 0}));
  EXPECT_THAT(error(model + spin + "0.5, 0.25, 0., 0.5, 0.25, 0.\n" + abaqus_step()),
              HasSubstr("expected two points of the axis"));
  EXPECT_THAT(error(model + "*INITIAL CONDITIONS, TYPE=VELOCITY\n5, 1, 1.\n" + spin + "0., 0., 0., 0., 0., 2.\n" +
                    abaqus_step()),
              HasSubstr("TYPE=ROTATING VELOCITY of nodes with another velocity (deck.inp:"));
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
