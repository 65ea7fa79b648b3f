#include <gmock/gmock.h>

#include <tests/support/solver_case.hpp>

#include "abaqus_case.hpp"

/// *EQUATION: displacements of nodes that add up to zero.
namespace pinball::test::abaqus_equations_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class AbaqusEquations : public AbaqusTest {
 protected:
  static std::string deck(const std::string& model, const std::string& step = "") {
    return abaqus_cube + abaqus_steel + model + abaqus_step(step);
  }
};

TEST_F(AbaqusEquations, AreOfNodesInLinesOfFourTerms) {
  const Scene s =
      scene(deck("*EQUATION\n5\n1, 1, 1., 2, 1, -0.5, 3, 2, 2., 4, 3, 1.\n5, 1, -3.\n2\n6, 3, 1., 7, 3, -1.\n"));
  ASSERT_EQ(s.equation_terms.size(), 7U);
  std::vector<double> factors;
  std::string names, axes;
  for (const EquationTerm& term : s.equation_terms) {
    factors.push_back(term.factor);
    names += term.name.back();
    for (std::size_t k = 0; k < 3; ++k) axes += term.direction[k] == 1 ? std::string(1, "xyz"[k]) : "";
    EXPECT_EQ(term.nodes.nodes.size(), 1U);
  }
  EXPECT_THAT(factors, ElementsAre(1, -0.5, 2, 1, -3, 1, -1));
  EXPECT_EQ(names, "1111122");
  EXPECT_EQ(axes, "xxyzxzz");
  EXPECT_THAT(s.equation_terms[4].nodes.nodes, ElementsAre(5));
}

/// The lid follows a node of it that is pulled, and twice the base along x, node by node.
TEST_F(AbaqusEquations, OfSetsAreThoseOfTheirNodesInTheOrderOfTheirNumbers) {
  const Scene s =
      scene(deck("*NSET, NSET=rest\n8, 6, 7\n*EQUATION\n2\nrest, 3, 1.\n5, 3, -1.\n2\ntop, 1, 1., base, 1, -2.\n",
                 "*CLOAD\n5, 3, 1.\n1, 1, 1.\n"));
  ASSERT_EQ(s.equation_terms.size(), 4U);
  EXPECT_THAT(s.equation_terms[0].nodes.nodes, ElementsAre(6, 7, 8));
  Solver<double> solver(s);
  run(solver);
  const auto way = [&](std::size_t node) { return minus(position_of(solver, node), solver.mesh().nodes[node]); };
  EXPECT_GT(way(4)[2], 0);
  for (const std::size_t n : {5, 6, 7}) EXPECT_DOUBLE_EQ(position_of(solver, n)[2], position_of(solver, 4)[2]) << n;
  EXPECT_NE(way(0)[0], way(1)[0]);
  for (const std::size_t n : {0, 1, 2, 3}) EXPECT_NEAR(way(n + 4)[0], 2 * way(n)[0], 1e-15) << n;
}

/// u_5 = u_1, u_6 = u_2; node 7 is on the line from 3 to 4 where it stands above 3.
TEST_F(AbaqusEquations, OfMpcsAreThoseOfTheirKinds) {
  const Scene s =
      scene(deck("*MPC\nPIN, 5, 1\nTIE, 6, 2\nLINEAR, 7, 3, 4\nLINEAR, 8, 1, 2\n", "*CLOAD\n1, 1, 1.\n6, 2, 1.\n"));
  ASSERT_EQ(s.equation_terms.size(), 3U * (2 + 2 + 2 + 2));
  EXPECT_EQ(s.equation_terms[0].name, "mpc_1_x");
  EXPECT_EQ(s.equation_terms[1].factor, -1);
  EXPECT_THAT(s.equation_terms[1].nodes.nodes, ElementsAre(1));
  Solver<double> solver(s);
  run(solver);
  const auto way = [&](std::size_t node) { return minus(position_of(solver, node), solver.mesh().nodes[node]); };
  EXPECT_GT(way(0)[0], 0);
  EXPECT_GT(way(1)[1], 0);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(way(4)[k], way(0)[k], 1e-15);
    EXPECT_NEAR(way(5)[k], way(1)[k], 1e-15);
    EXPECT_NEAR(way(6)[k], way(2)[k], 1e-15);
    EXPECT_NEAR(way(7)[k], way(0)[k], 1e-15);
  }
  const Scene sets = scene(deck("*MPC\nTIE, top, base\n*NSET, NSET=lid\n6, 7, 8\n*MPC\nPIN, lid, 5\n"));
  ASSERT_EQ(sets.equation_terms.size(), 12U);
  EXPECT_THAT(sets.equation_terms[0].nodes.nodes, ElementsAre(5, 6, 7, 8));
  EXPECT_EQ(error_of([&] { Solver<double> taken(sets); }), no_error);
}

/// Half way between two nodes, and beyond them.
TEST_F(AbaqusEquations, OfLinearMpcsHaveSharesOfTheirLine) {
  const auto factors = [&](const std::string& more) {
    std::vector<double> all;
    for (const EquationTerm& term : scene(deck(more)).equation_terms) {
      if (term.name == "mpc_1_x") all.push_back(term.factor);
    }
    return all;
  };
  EXPECT_THAT(factors("*MPC\nLINEAR, 5, 1, 2\n"), ElementsAre(1, -1)) << "above 1";
  EXPECT_THAT(factors("*MPC\nLINEAR, 5, 1, 7\n"),
              ElementsAre(1, ::testing::DoubleNear(-2. / 3, 1e-15), ::testing::DoubleNear(-1. / 3, 1e-15)))
      << "a corner beside the diagonal";
}

TEST_F(AbaqusEquations, OfOtherMpcsAreRefused) {
  for (const char* kind : {"BEAM", "LINK", "SLIDER", "MEANROT", "STRAIGHT"})
    EXPECT_THAT(error(deck(std::string("*MPC\n") + kind + ", 5, 1\n")), HasSubstr(std::string("*MPC, ") + kind));
  EXPECT_THAT(error(deck("*MPC\nPIN, 5, 99\n")), HasSubstr("node 99 is not there"));
  EXPECT_THAT(error(deck("*MPC\nPIN, 5, top\n")), HasSubstr("expected a node behind a node"));
  EXPECT_THAT(error(deck("*MPC\nLINEAR, 5, 1, 1\n")), HasSubstr("expected two nodes in different places"));
  EXPECT_THAT(error(deck("*NODE\n50, 0., 0., 9.\n*MPC\nPIN, 5, 50\n")), HasSubstr("*MPC of a node of no solid"));
  EXPECT_THAT(error(deck("*MPC, USER, MODE=NODE\nPIN, 5, 1\n")), HasSubstr("*MPC, USER"));
}

TEST_F(AbaqusEquations, OfOtherThingsAreRefused) {
  EXPECT_THAT(error(deck("*EQUATION\n2\n1, 4, 1., 2, 1, -1.\n")), HasSubstr("*EQUATION with degree of freedom 4"));
  EXPECT_THAT(error(deck("*EQUATION\n2\n1, 1, 1., 2, 1, 0.\n")), HasSubstr("a coefficient that is not 0"));
  EXPECT_THAT(error(deck("*EQUATION\n5\n1, 1, 1., 2, 1, 1., 3, 1, 1., 4, 1, 1.\n")),
              HasSubstr("1 more terms of *EQUATION"));
  EXPECT_THAT(error(deck("*EQUATION\n0\n")), HasSubstr("a number of terms >= 1"));
  EXPECT_THAT(error(deck("*EQUATION\n2\n1, 1, 1., top, 1, -1.\n")), HasSubstr("got a set of several"));
  EXPECT_THAT(error(deck("*EQUATION\n2\n1, 1, 1., 99, 1, -1.\n")), HasSubstr("node 99 is not there"));
  EXPECT_THAT(error(deck("*NODE\n50, 0., 0., 9.\n*EQUATION\n2\n1, 1, 1., 50, 1, -1.\n")),
              HasSubstr("*EQUATION of a node of no solid"));
  EXPECT_THAT(
      error(
          deck("*NSET, NSET=mixed, UNSORTED\n4, 1\n*NSET, NSET=two\n2, 3\n*EQUATION\n2\nmixed, 1, 1., two, 1, -1.\n")),
      HasSubstr("UNSORTED"));
  EXPECT_THAT(error(deck("*EQUATION, INPUT=other.txt\n")), HasSubstr("INPUT"));
  const Scene sizes = scene(deck("*NSET, NSET=three\n1, 2, 3\n*EQUATION\n2\ntop, 1, 1., three, 1, -1.\n"));
  EXPECT_THAT(error_of([&] { Solver<double> refused(sizes); }), HasSubstr("expected 4 nodes"));
}

}  // namespace
}  // namespace pinball::test::abaqus_equations_test
