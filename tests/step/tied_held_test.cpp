#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <solver/results/warnings.hpp>
#include <tests/support/tied_case.hpp>

/// Constraints of nodes that are tied to faces.
namespace pinball::test::tied_held_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

FixedConstraint hold(const std::string& body, double height, const std::vector<Point>& directions) {
  FixedConstraint fixed;
  fixed.nodes.where = "clamp";
  fixed.nodes.body = body;
  fixed.nodes.plane = Plane{{0, 0, height}, {0, 0, 1}};
  fixed.directions = directions;
  return fixed;
}

TiedResult of(const Scene& scene) { return Solver<double>(scene).model().tie_counts.at(0); }

/// Constraints of one body were looked at one by one: held along x, and along y and z by another, nodes were tied and
/// fell.
TEST(TiedNodesThatAreHeld, AreSoByAllConstraintsTogether) {
  Scene scene = glued(3, 2, 2e-4);
  scene.fixed_constraints = {hold("high", 0.6, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}})};
  EXPECT_EQ(of(scene).held, 16);
  scene.fixed_constraints = {hold("high", 0.6, {{1, 0, 0}}), hold("high", 0.6, {{0, 1, 0}, {0, 0.6, 0.8}})};
  EXPECT_EQ(of(scene).held, 16);
  EXPECT_EQ(of(scene).nodes, 0);
  scene.constraints = {{{0, 0, 0.6}, {0, 0, 1}, "high"}};
  scene.fixed_constraints = {hold("high", 0.6, {{1, 0, 0}, {0, 1, 0}})};
  EXPECT_EQ(of(scene).held, 16);
}

/// The faces decide, and a constraint of tied nodes alone does nothing: that is told.
TEST(TiedNodesThatAreHeld, InPartAreToldWhereTheirFacesAreFree) {
  Scene scene = glued(3, 2, 2e-4);
  scene.fixed_constraints = {hold("high", 0.6, {{0, 0, 1}})};
  EXPECT_EQ(of(scene).nodes, 16);
  EXPECT_EQ(of(scene).free, 16);
  RunSummary summary;
  summary.tied = {of(scene)};
  EXPECT_THAT(
      start_warnings(summary),
      ElementsAre(HasSubstr("contact.tied glue: 16 nodes are tied, and 16 of these are held in directions in which")));
  scene.fixed_constraints.push_back(hold("low", 0.6, {{0, 0, 1}}));
  EXPECT_EQ(of(scene).free, 0) << "the faces are held, too";
  scene.fixed_constraints = {hold("high", 0.6, {{1, 0, 0}}), hold("low", 0.6, {{0, 0, 1}})};
  EXPECT_EQ(of(scene).free, 16) << "along another direction";
  PrescribedVelocity first, second;
  first.nodes = second.nodes = scene.fixed_constraints[1].nodes;
  first.direction = Point{1, 0, 0};
  first.when.end = 1e-4;
  second.direction = Point{0.6, 0.8, 0};
  second.when.start = 1e-4;
  scene.prescribed_velocities = {first, second};
  EXPECT_EQ(of(scene).free, 16) << "while these move, one after the other";
}

/// A wall of tied nodes alone did nothing, without a word.
TEST(TiedNodesAtRigidWalls, AreToldWhereTheirFacesAreNotTaken) {
  Scene scene = glued(3, 2, 2e-4);
  RigidWall wall;
  wall.name = "floor";
  wall.plane = Plane{{0, -0.1, 0}, {0, 1, 0}};
  scene.rigid_walls = {wall};
  const auto warnings = [&scene] { return Solver<double>(scene).mesh().warnings; };
  EXPECT_THAT(warnings(), testing::IsEmpty()) << "of all nodes";
  scene.rigid_walls[0].body = "low";
  EXPECT_THAT(warnings(), testing::IsEmpty());
  scene.rigid_walls[0].body = "high";
  EXPECT_THAT(warnings(), ElementsAre(HasSubstr("rigid wall floor: 16 of the nodes that it takes are tied to faces")));
  scene.rigid_walls[0].nodes.box = Box{{-1, -1, 0.7}, {1, 1, 2}};
  EXPECT_THAT(warnings(), testing::IsEmpty()) << "none of them is tied";
  scene.rigid_walls[0].nodes.box.reset();
  scene.tied_contacts[0].end = 1e-4;
  scene.rigid_walls[0].when.start = 1e-4;
  EXPECT_THAT(warnings(), testing::IsEmpty()) << "one after the other";
}

/// Of the symmetry of a whole model nothing is to be told.
TEST(TiedNodesThatAreHeld, BySymmetryAreNotTold) {
  Scene scene = glued(3, 2, 2e-4);
  scene.constraints = {{{0, 0, 0}, {1, 0, 0}, ""}, {{0, 0, 0}, {0, 1, 0}, ""}};
  EXPECT_EQ(of(scene).nodes, 16);
  EXPECT_EQ(of(scene).free, 0);
  EXPECT_EQ(of(scene).held, 0);
}

}  // namespace
}  // namespace pinball::test::tied_held_test
