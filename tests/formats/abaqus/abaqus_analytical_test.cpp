#include <gmock/gmock.h>

#include <tests/support/solver_case.hpp>

#include "abaqus_case.hpp"

/// Analytical surfaces of rigid bodies: what is a rigid wall, and what is refused.
namespace pinball::test::abaqus_analytical_test {
namespace {

using testing::Contains;
using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pointwise;

/// A cube of 1 mm in an instance of its own, and a floor of 4 mm in another one.
std::string deck_of(const std::string& line, const std::string& contact, const std::string& placement = "",
                    const std::string& held = "floor, ENCASTRE\n", const std::string& more = "") {
  return "*PART, NAME=cube\n" + abaqus_cube + "*END PART\n*PART, NAME=floor\n*END PART\n*ASSEMBLY\n" +
         "*INSTANCE, NAME=cube-1, PART=cube\n*END INSTANCE\n*INSTANCE, NAME=floor-1, PART=floor\n" + placement +
         "*NODE\n1, 0., 0., 0.\n*NSET, NSET=point\n1,\n*SURFACE, TYPE=CYLINDER, NAME=ground\n" + line +
         "*RIGID BODY, REF NODE=point, ANALYTICAL SURFACE=ground\n*END INSTANCE\n" +
         "*NSET, NSET=floor, INSTANCE=floor-1\n1,\n*NSET, NSET=all, INSTANCE=cube-1\n1, 2, 3, 4, 5, 6, 7, 8\n" +
         "*SURFACE, NAME=outside\ncube-1.Cube,\n*END ASSEMBLY\n" + abaqus_steel +
         "*SURFACE INTERACTION, NAME=rub\n*FRICTION\n0.2,\n*BOUNDARY\n" + held + more + abaqus_step(contact);
}
const std::string straight = "START, -2., -0.1\nLINE, 2., -0.1\n",
                  general = "*CONTACT\n*CONTACT INCLUSIONS, ALL EXTERIOR\n*CONTACT PROPERTY ASSIGNMENT\n, , rub\n";

class AbaqusAnalytical : public AbaqusTest {
 protected:
  RigidWall wall_of(const std::string& text) { return scene(text).rigid_walls.at(0); }
};

TEST_F(AbaqusAnalytical, AStraightOneIsAWall) {
  const RigidWall wall = wall_of(deck_of(straight, general));
  EXPECT_EQ(wall.plane.point, (Point{-2, -0.1, 0}));
  EXPECT_EQ(wall.plane.normal, (Point{0, 1, 0}));
  EXPECT_EQ(wall.edge.value(), (Point{1, 0, 0}));
  EXPECT_THAT(wall.size, ElementsAre(4, 0));
  EXPECT_EQ(wall.friction, 0.2);
  EXPECT_TRUE(wall.nodes.set.empty()) << "of all nodes";
  EXPECT_EQ(wall_of(deck_of("START, 2., 0.\nLINE, -2., 0.\n", general)).plane.normal, (Point{0, -1, 0}))
      << "its other side";
  EXPECT_TRUE(scene(deck_of(straight, general)).rigid_bodies.empty());
}

/// Where its instance is moved and turned by a right angle about the first axis.
TEST_F(AbaqusAnalytical, GoesWithItsInstance) {
  const RigidWall wall = wall_of(deck_of(straight, general, "5., 0., 0.\n5., 0., 0., 6., 0., 0., 90.\n"));
  EXPECT_THAT(wall.plane.point, Pointwise(DoubleNear(1e-12), {3., 0., -0.1}));
  EXPECT_THAT(wall.plane.normal, Pointwise(DoubleNear(1e-12), {0., 0., 1.}));
  EXPECT_THAT(wall.edge.value(), Pointwise(DoubleNear(1e-12), {1., 0., 0.}));
}

TEST_F(AbaqusAnalytical, OfAPairMeetsTheOtherSurface) {
  for (const char* sides : {"outside, floor-1.ground\n", "floor-1.ground, outside\n", "ground, outside\n"}) {
    const std::string pair = std::string("*CONTACT PAIR, INTERACTION=rub\n") + sides;
    const Scene s = scene(deck_of(straight, pair));
    EXPECT_EQ(s.rigid_walls.at(0).nodes.set, "outside") << sides;
    EXPECT_EQ(s.rigid_walls[0].friction, 0.2);
    EXPECT_EQ(s.contact.method, ContactMethod::none);
  }
  EXPECT_TRUE(scene(deck_of(straight, "")).rigid_walls.empty());
  EXPECT_THAT(translate(deck_of(straight, "")).understood,
              Contains(HasSubstr("not used: *RIGID BODY, ANALYTICAL SURFACE (")));
}

/// A cube that falls rebounds from a wall under it, and goes by where the line has ended.
TEST_F(AbaqusAnalytical, StopsWhatFallsOnItsLine) {
  const auto speed = [&](const std::string& line) {
    std::string deck =
        deck_of(line, general, "", "floor, ENCASTRE\n", "*INITIAL CONDITIONS, TYPE=VELOCITY\nall, 2, -1.E5\n");
    deck.replace(deck.find(", 1.0E-6"), 8, ", 3.0E-6");
    Solver<double> solver(scene(deck));
    run_to_end(solver);
    RunSummary summary;
    fill_summary(solver, summary);
    return summary.bodies.at(0).velocity[1];
  };
  EXPECT_GT(speed(straight), 0.3e5);
  EXPECT_EQ(speed("START, -0.1, -0.1\nLINE, 1.1, -0.1\n"), speed(straight));
  EXPECT_NEAR(speed("START, 1.2, -0.1\nLINE, 3., -0.1\n"), -1e5, 1e-6);
  EXPECT_NEAR(speed("START, 2., -0.1\nLINE, -2., -0.1\n"), -1e5, 1e-6) << "its other side is free";
}

TEST_F(AbaqusAnalytical, OthersAreRefused) {
  const std::string curved = "START, 0., 0.\nCIRCL, 2., 0., 1., 0.\n",
                    bent = "START, 0., 0.\nLINE, 1., 0.\nLINE, 1., 1.\n",
                    axes = "0., 0., 0., 1., 0., 0.\n0., 1., 0.\nSTART, 0., 0.\nLINE, 1., 0.\n";
  for (const std::string& line : {curved, bent, axes})
    EXPECT_THAT(error(deck_of(line, general)), HasSubstr("*SURFACE of a rigid body that is not one straight line"));
  EXPECT_THAT(error(deck_of("START, 1., 0.\nLINE, 1., 0.\n", general)), HasSubstr("expected a line with a length"));
  for (const char* held : {"floor, PINNED\n", "floor, 1, 5\n"})
    EXPECT_THAT(error(deck_of(straight, general, "", held)),
                HasSubstr("*RIGID BODY, ANALYTICAL SURFACE that is not held"));
  EXPECT_THAT(error(deck_of(straight, "*CONTACT\n*CONTACT INCLUSIONS\nground, outside\n")),
              HasSubstr("*CONTACT INCLUSIONS with an analytical surface"));
}

}  // namespace
}  // namespace pinball::test::abaqus_analytical_test
