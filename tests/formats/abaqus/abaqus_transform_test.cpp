#include <gmock/gmock.h>

#include <tests/support/solver_case.hpp>

#include "abaqus_case.hpp"

/// *TRANSFORM: local directions of nodes.
namespace pinball::test::abaqus_transform_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// The first axis along y, the second along -x; and about an upright axis through the middle of the cube.
const std::string turned = "*TRANSFORM, NSET=top\n0., 2., 0., -3., 1., 0.\n",
                  about = "*TRANSFORM, NSET=top, TYPE=C\n0.5, 0.5, -1., 0.5, 0.5, 3.\n";

class AbaqusTransforms : public AbaqusTest {
 protected:
  static std::string deck(const std::string& model, const std::string& step = "") {
    return abaqus_cube + abaqus_steel + model + abaqus_step(step);
  }
};

TEST_F(AbaqusTransforms, OfStraightAxesTurnWhatHoldsMovesAndLoads) {
  const Scene s = scene(deck(turned + "*BOUNDARY\ntop, 1\n1, 1\n5, 3\n*EQUATION\n2\n6, 2, 1., 2, 2, -1.\n",
                             "*BOUNDARY, TYPE=VELOCITY\ntop, 2, 2, 4.\n*CLOAD\n5, 1, 7.\n1, 1, 7.\n"));
  ASSERT_EQ(s.fixed_constraints.size(), 3U);
  std::vector<Point> held;
  for (const FixedConstraint& constraint : s.fixed_constraints) held.push_back(constraint.directions.at(0));
  EXPECT_THAT(held, testing::UnorderedElementsAre(Point{0, 1, 0}, Point{1, 0, 0}, Point{0, 0, 1}));
  ASSERT_EQ(s.prescribed_velocities.size(), 1U);
  EXPECT_EQ(*s.prescribed_velocities[0].direction, (Point{-1, 0, 0}));
  ASSERT_EQ(s.loads.size(), 2U);
  EXPECT_EQ(s.loads[0].force, (Point{0, 7, 0}));
  EXPECT_EQ(s.loads[1].force, (Point{7, 0, 0}));
  ASSERT_EQ(s.equation_terms.size(), 2U);
  EXPECT_EQ(s.equation_terms[0].direction, (Point{-1, 0, 0}));
  EXPECT_EQ(s.equation_terms[1].direction, (Point{0, 1, 0}));
}

/// Held along the circumference and up, the lid moves along radii alone.
TEST_F(AbaqusTransforms, OfACylinderHoldEachNodeAlongItsOwnDirections) {
  const Scene s = scene(deck(about + "*BOUNDARY\ntop, 2, 3\n", "*CLOAD\nbase, 1, 3.\n5, 3, 7.\n"));
  ASSERT_EQ(s.fixed_constraints.size(), 1U);
  const FixedConstraint& held = s.fixed_constraints[0];
  EXPECT_EQ(held.frame, Frame::cylindrical);
  EXPECT_THAT(held.directions, ElementsAre(Point{0, 1, 0}, Point{0, 0, 1}));
  EXPECT_EQ(held.axis.direction, (Point{0, 0, 1}));
  EXPECT_EQ(s.loads.at(1).force, (Point{0, 0, 7}));
  Solver<double> solver(s);
  run(solver);
  for (const std::size_t n : {4, 5, 6, 7}) {
    const Point start = solver.mesh().nodes[n], way = minus(position_of(solver, n), start);
    const Point radius{start[0] - 0.5, start[1] - 0.5, 0};
    EXPECT_GT(norm(way), 1e-12) << n;
    EXPECT_LT(norm(cross(way, radius)), 1e-9 * norm(way)) << n;
  }
}

TEST_F(AbaqusTransforms, WhatIsNotDoneIsRefused) {
  EXPECT_THAT(error(deck("*TRANSFORM, NSET=top, TYPE=S\n0., 0., 0., 0., 0., 1.\n")), HasSubstr("*TRANSFORM, TYPE=S"));
  EXPECT_THAT(error(deck("*TRANSFORM, NSET=top\n0., 0., 0., 0., 0., 1.\n")), HasSubstr("a point on the first axis"));
  EXPECT_THAT(error(deck("*TRANSFORM, NSET=top\n0., 1., 0., 0., 2., 0.\n")), HasSubstr("not on the first axis"));
  EXPECT_THAT(error(deck("*TRANSFORM, NSET=top, TYPE=C\n1., 1., 0., 1., 1., 0.\n")),
              HasSubstr("two points of an axis"));
  EXPECT_THAT(error(deck("*TRANSFORM, NSET=none\n0., 1., 0., 1., 0., 0.\n")), HasSubstr("none"));
  EXPECT_THAT(error(deck(about, "*CLOAD\n5, 1, 7.\n")), HasSubstr("*CLOAD along directions that differ"));
  EXPECT_THAT(error(deck(about, "*BOUNDARY, TYPE=VELOCITY\ntop, 1, 1, 4.\n")),
              HasSubstr("*BOUNDARY along directions that differ"));
  EXPECT_THAT(error(deck(about + "*EQUATION\n2\n6, 2, 1., 2, 2, -1.\n")), HasSubstr("*EQUATION along directions"));
  EXPECT_THAT(error(deck(about + "*MPC\nPIN, 6, 2\n")), HasSubstr("*MPC of nodes with a *TRANSFORM"));
  EXPECT_THAT(error(deck(turned + "*NSET, NSET=mixed\n1, 5\n*BOUNDARY\nmixed, 1\n")),
              HasSubstr("*BOUNDARY of nodes of which some have a *TRANSFORM"));
  EXPECT_THAT(
      error(deck(turned + "*NSET, NSET=one\n5\n*TRANSFORM, NSET=one\n0., 1., 0., 1., 0., 0.\n*BOUNDARY\ntop, 1\n")),
      HasSubstr("more than one *TRANSFORM"));
}

}  // namespace
}  // namespace pinball::test::abaqus_transform_test
