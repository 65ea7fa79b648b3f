#include <gmock/gmock.h>

#include <tests/support/run_hash.hpp>

#include "abaqus_case.hpp"

/// *MASS of elements at nodes of solids that deform.
namespace pinball::test::abaqus_masses_test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

class AbaqusMasses : public AbaqusTest {
 protected:
  const std::string moving_ = "*INITIAL CONDITIONS, TYPE=VELOCITY\ntop, 3, -100.\n",
                    points_ = "*ELEMENT, TYPE=MASS, ELSET=Points\n301, 7\n302, 8\n";
};

TEST_F(AbaqusMasses, AreOfEachOfTheirNodes) {
  const std::string deck =
      abaqus_cube + points_ + "*MASS, ELSET=Points\n4.E-9,\n" + abaqus_steel + moving_ + abaqus_step();
  const Scene made = scene(deck);
  ASSERT_EQ(made.point_masses.size(), 1U);
  EXPECT_EQ(made.point_masses[0].mass, 4e-9);
  EXPECT_THAT(made.point_masses[0].nodes.nodes, ElementsAre(7, 8));
  const std::string without = abaqus_cube + abaqus_steel + moving_ + abaqus_step();
  Scene own = scene(without);
  PointMass point;
  point.nodes.plane = Plane{{0, 0, 1}, {0, 0, 1}};
  point.nodes.line = Line{{0, 1, 1}, {1, 0, 0}};
  point.mass = 8e-9;
  own.point_masses = {point};
  EXPECT_EQ(hash_of<double>(made), hash_of<double>(own));
  EXPECT_NE(hash_of<double>(made), hash_of<double>(scene(without)));
}

TEST_F(AbaqusMasses, OfOneNodeAddUp) {
  const Scene made = scene(abaqus_cube + points_ +
                           "*ELEMENT, TYPE=MASS, ELSET=More\n303, 7\n*MASS, ELSET=Points\n"
                           "4.E-9,\n*MASS, ELSET=More\n1.E-9,\n" +
                           abaqus_steel + abaqus_step());
  ASSERT_EQ(made.point_masses.size(), 2U);
  EXPECT_EQ(made.point_masses[0].mass, 4e-9);
  EXPECT_THAT(made.point_masses[0].nodes.nodes, ElementsAre(8));
  EXPECT_EQ(made.point_masses[1].mass, 4e-9 + 1e-9);
  EXPECT_THAT(made.point_masses[1].nodes.nodes, ElementsAre(7));
}

TEST_F(AbaqusMasses, MayBeOfASetOfSets) {
  const auto mass = [&](const std::string& sets) {
    const Scene made =
        scene(abaqus_cube + points_ + sets + "*MASS, ELSET=Outer\n2.E-9,\n" + abaqus_steel + abaqus_step());
    return made.point_masses.empty() ? 0.0 : made.point_masses[0].mass * made.point_masses[0].nodes.nodes.size();
  };
  EXPECT_EQ(mass("*ELSET, ELSET=Outer\nPoints\n"), 4e-9);
  EXPECT_EQ(mass("*ELSET, ELSET=Outer\nInner,\n*ELSET, ELSET=Inner\nPoints\n"), 4e-9);
  EXPECT_EQ(mass("*ELSET, ELSET=Outer\nInner,\n*ELSET, ELSET=Inner\n302\n"), 2e-9);
  EXPECT_EQ(mass("*ELSET, ELSET=Outer\nInner\n*ELSET, ELSET=Inner\nOuter\n"), 0) << "no end";
}

TEST_F(AbaqusMasses, AreHeavyWhereTheirSetIs) {
  const auto weighed = [&](const std::string& set, const std::string& sets) {
    return abaqus_cube + points_ + "*MASS, ELSET=Points\n4.E-9,\n" + sets + abaqus_steel +
           abaqus_step("*DLOAD\n" + set + ", GRAV, 9810., 0., 0., -1.\n");
  };
  const std::string lacks = "*DLOAD, GRAV of solids without the *MASS of their nodes (deck.inp:",
                    alone = "*DLOAD, GRAV of elements of one node without the solids of their nodes (deck.inp:";
  EXPECT_EQ(error(weighed("", "")), no_error);
  EXPECT_EQ(error(weighed("All", "*ELSET, ELSET=All\nCube, Points\n")), no_error);
  EXPECT_EQ(error(weighed("All", "*ELSET, ELSET=All\n10, 301, 302\n")), no_error);
  EXPECT_THAT(error(weighed("Cube", "")), HasSubstr(lacks));
  EXPECT_THAT(error(weighed("All", "*ELSET, ELSET=All\nCube, 301\n")), HasSubstr(lacks));
  EXPECT_THAT(error(weighed("Points", "")), HasSubstr(alone));
  EXPECT_THAT(error(weighed("All", "*ELSET, ELSET=All\nPoints\n")), HasSubstr(alone));
}

TEST_F(AbaqusMasses, OfNoNodeOfASolidAreRefused) {
  const std::string rest = abaqus_steel + abaqus_step();
  EXPECT_THAT(
      error(abaqus_cube + "*NODE\n9, 5., 5., 5.\n*ELEMENT, TYPE=MASS, ELSET=P\n301, 9\n*MASS, ELSET=P\n1.,\n" + rest),
      AllOf(HasSubstr("*MASS of a node that is no reference node of a rigid body"), HasSubstr("deck.inp:")));
  EXPECT_THAT(error(abaqus_cube + points_ + "*MASS, ELSET=Points\n-1.,\n" + rest), HasSubstr("expected a mass >= 0"));
  EXPECT_THAT(
      error(abaqus_cube + "*ELEMENT, TYPE=ROTARYI, ELSET=P\n301, 7\n*ROTARY INERTIA, ELSET=P\n1., 1., 1.\n" + rest),
      HasSubstr("*ROTARY INERTIA of a node that is no reference node of a rigid body"));
}

}  // namespace
}  // namespace pinball::test::abaqus_masses_test
