#include <gmock/gmock.h>

#include "abaqus_case.hpp"

namespace pinball::test::abaqus_steps_test {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double never = std::numeric_limits<double>::infinity();

class AbaqusSteps : public AbaqusTest {
 protected:
  /// Two steps, of 1e-6 and 2e-6.
  static std::string deck(const std::string& model, const std::string& first, const std::string& second) {
    return abaqus_cube + abaqus_steel + model + abaqus_step(first) + "*STEP\n*DYNAMIC, EXPLICIT\n, 2.0E-6\n" + second +
           "*END STEP\n";
  }
  Scene steps(const std::string& model, const std::string& first, const std::string& second) {
    return scene(deck(model, first, second));
  }
};

TEST_F(AbaqusSteps, FollowEachOther) {
  const Scene s = steps("*BOUNDARY\nbase, 1\n", "*BOUNDARY\nbase, 2\n", "*BOUNDARY\ntop, 3\n");
  EXPECT_DOUBLE_EQ(s.time.end, 3e-6);
  ASSERT_EQ(s.fixed_constraints.size(), 3u);
  for (const FixedConstraint& held : s.fixed_constraints) EXPECT_EQ(held.when.end, never) << "it stays so";
  EXPECT_EQ(s.fixed_constraints[1].when.start, 0);
  EXPECT_EQ(s.fixed_constraints[2].when.start, 1e-6);
}

TEST_F(AbaqusSteps, MayRenewWhatIsHeldAndMoved) {
  const Scene s =
      steps("*BOUNDARY\nbase, 1\n", "*BOUNDARY, TYPE=VELOCITY\ntop, 3, 3, 5.\n", "*BOUNDARY, OP=NEW\n1, 2\n");
  ASSERT_EQ(s.fixed_constraints.size(), 2u);
  EXPECT_EQ(s.fixed_constraints[0].when.end, 1e-6);
  EXPECT_THAT(s.fixed_constraints[1].nodes.nodes, ElementsAre(1));
  EXPECT_EQ(s.fixed_constraints[1].when.start, 1e-6);
  EXPECT_EQ(s.prescribed_velocities.at(0).when.end, 1e-6);
}

TEST_F(AbaqusSteps, ReplaceWhatIsSaidOfTheSameNodes) {
  const Scene s = steps("", "*BOUNDARY, TYPE=VELOCITY\ntop, 1, 3, 5.\n", "*BOUNDARY, TYPE=VELOCITY\ntop, 3, 3, -5.\n");
  ASSERT_EQ(s.prescribed_velocities.size(), 4u);
  const auto spans = [&] {
    std::vector<std::pair<double, double>> all;
    for (const PrescribedVelocity& one : s.prescribed_velocities) all.emplace_back(one.when.start, one.when.end);
    return all;
  };
  EXPECT_THAT(spans(),
              ElementsAre(std::pair(0., never), std::pair(0., never), std::pair(1e-6, never), std::pair(0., 1e-6)));
  EXPECT_EQ(s.prescribed_velocities[2].velocity[2], -5);
}

TEST_F(AbaqusSteps, MayReplaceWhatIsSaidOfSomeOfItsNodes) {
  const Scene s = steps("*BOUNDARY\nbase, ENCASTRE\n", "", "*BOUNDARY, TYPE=VELOCITY\n2, 3, 3, 5.\n");
  ASSERT_EQ(s.fixed_constraints.size(), 3u);
  EXPECT_EQ(s.fixed_constraints[0].directions.size(), 2u);
  EXPECT_EQ(s.fixed_constraints[0].nodes.set, "base");
  EXPECT_THAT(s.fixed_constraints[1].nodes.nodes, ElementsAre(1, 3, 4));
  EXPECT_EQ(s.fixed_constraints[1].when.end, never);
  EXPECT_THAT(s.fixed_constraints[2].nodes.nodes, ElementsAre(2));
  EXPECT_EQ(s.fixed_constraints[2].when.end, 1e-6);
  EXPECT_EQ(s.prescribed_velocities.at(0).when.start, 1e-6);
  const Scene twice = steps("*BOUNDARY\nbase, 3\n", "", "*BOUNDARY, TYPE=VELOCITY\n2, 3, 3, 5.\n3, 3, 3, 6.\n");
  ASSERT_EQ(twice.fixed_constraints.size(), 2u);
  EXPECT_THAT(twice.fixed_constraints[0].nodes.nodes, ElementsAre(1, 4));
  EXPECT_THAT(twice.fixed_constraints[1].nodes.nodes, ElementsAre(2, 3));
  const Scene one = scene(abaqus_cube + abaqus_steel + "*BOUNDARY\nbase, 3\n" +
                          abaqus_step("*BOUNDARY, TYPE=VELOCITY\nbase, 3, 3, 5.\n"));
  EXPECT_THAT(one.fixed_constraints, IsEmpty()) << "what is before the step, too";
}

TEST_F(AbaqusSteps, MayGoOnBringingNodesElsewhere) {
  const Scene s = steps("*AMPLITUDE, NAME=a\n0., 0., 1e-6, 1.\n", "*BOUNDARY, AMPLITUDE=a\ntop, 3, 3, 5.\n",
                        "*BOUNDARY, AMPLITUDE=a\ntop, 3, 3, -2.\n");
  ASSERT_EQ(s.prescribed_velocities.size(), 2u);
  const PrescribedVelocity &first = s.prescribed_velocities[1], &second = s.prescribed_velocities[0];
  EXPECT_EQ(first.when.end, 1e-6);
  EXPECT_EQ(second.quantity, MotionQuantity::displacement);
  EXPECT_EQ(second.when.start, 1e-6);
  EXPECT_THAT(second.table.times, ElementsAre(1e-6, DoubleEq(2e-6)));
  EXPECT_THAT(second.table.factors, ElementsAre(0, -2));
}

/// They come and go within 1e-9 of the time of a step.
TEST_F(AbaqusSteps, MayLoadAnewAndOtherwise) {
  const auto near = [](double time) { return testing::DoubleNear(time, 2e-15); };
  const Scene late = steps("", "", "*CLOAD\ntop, 1, 2.\n");
  EXPECT_THAT(late.loads.at(0).table.times, ElementsAre(near(1e-6), 1e-6));
  EXPECT_LT(late.loads[0].table.times[0], 1e-6);
  EXPECT_THAT(late.loads[0].table.factors, ElementsAre(0, 2));
  EXPECT_EQ(late.loads[0].nodes.set, "top");

  const Scene changed = steps("", "*CLOAD\ntop, 1, 2.\ntop, 2, 7.\n", "*CLOAD\ntop, 1, 3.\n");
  ASSERT_EQ(changed.loads.size(), 3u);
  EXPECT_THAT(changed.loads[0].table.times, ElementsAre(0, near(1e-6), 1e-6));
  EXPECT_THAT(changed.loads[0].table.factors, ElementsAre(2, 2, 0));
  EXPECT_THAT(changed.loads[1].table.times, IsEmpty()) << "of another direction";
  EXPECT_THAT(changed.loads[2].table.factors, ElementsAre(0, 3));

  const Scene of_one = steps("", "*CLOAD\ntop, 1, 2.\n", "*CLOAD\n5, 1, 0.\n");
  ASSERT_EQ(of_one.loads.size(), 2u) << "none of 0";
  EXPECT_THAT(of_one.loads[0].nodes.nodes, ElementsAre(6, 7, 8));
  EXPECT_THAT(of_one.loads[0].table.times, IsEmpty());
  EXPECT_THAT(of_one.loads[1].nodes.nodes, ElementsAre(5));
  EXPECT_THAT(of_one.loads[1].table.factors, ElementsAre(2, 2, 0));

  const Scene twice = steps("", "*CLOAD\ntop, 1, 2.\ntop, 1, 3.\n", "*CLOAD\ntop, 1, 4.\n");
  ASSERT_EQ(twice.loads.size(), 3u) << "both of the first step end";
  EXPECT_THAT(twice.loads[1].table.factors, ElementsAre(3, 3, 0));
}

TEST_F(AbaqusSteps, MayEndAllLoadsOfAKeyword) {
  const Scene s =
      steps("", "*CLOAD\ntop, 1, 2.\n*DLOAD\n, GRAV, 9., 0., 0., -1.\n10, P2, 5.\n", "*CLOAD, OP=NEW\nbase, 1, 3.\n");
  EXPECT_THAT(s.loads.at(0).table.factors, ElementsAre(2, 2, 0));
  EXPECT_THAT(s.loads.at(1).table.factors, ElementsAre(0, 3));
  EXPECT_THAT(s.gravities.at(0).table.times, IsEmpty());
  EXPECT_THAT(s.pressures.at(0).table.times, IsEmpty());
  const Scene distributed = steps("", "*DLOAD\n, GRAV, 9., 0., 0., -1.\n10, P2, 5.\n10, P3, 6.\n",
                                  "*DLOAD\n, GRAV, 4., 1., 0., 0.\n10, P3, 7.\n");
  ASSERT_EQ(distributed.gravities.size(), 2u);
  EXPECT_THAT(distributed.gravities[0].table.factors, ElementsAre(9, 9, 0));
  EXPECT_EQ(distributed.gravities[1].acceleration[0], 1);
  EXPECT_THAT(distributed.gravities[1].table.factors, ElementsAre(0, 4));
  ASSERT_EQ(distributed.pressures.size(), 3u);
  EXPECT_THAT(distributed.pressures[0].table.times, IsEmpty());
  EXPECT_THAT(distributed.pressures[1].table.factors, ElementsAre(6, 6, 0));
  EXPECT_THAT(distributed.pressures[2].table.factors, ElementsAre(0, 7));
}

TEST_F(AbaqusSteps, HaveAmplitudesOfTheirOwnTimeOrOfAll) {
  const std::string model =
      "*AMPLITUDE, NAME=own\n0., 0., 4e-6, 4.\n*AMPLITUDE, NAME=all, TIME=TOTAL TIME\n0., 0., 4e-6, 4.\n";
  const auto table = [&](const std::string& first, const std::string& second) {
    const Scene s = steps(model, first, second);
    return s.loads.empty() ? s.prescribed_velocities.at(0).table : s.loads[0].table;
  };
  const TimeTable ended = table("*CLOAD, AMPLITUDE=own\ntop, 1, 1.\n", "");
  EXPECT_THAT(ended.times, ElementsAre(0, 1e-6)) << "the load stays what it is at the end of its step";
  EXPECT_THAT(ended.factors, ElementsAre(0, DoubleEq(1)));
  EXPECT_THAT(table("*CLOAD, AMPLITUDE=all\ntop, 1, 1.\n", "").times, ElementsAre(0, 4e-6));
  const TimeTable of_all = table("", "*CLOAD, AMPLITUDE=all\ntop, 1, 1.\n");
  EXPECT_THAT(of_all.times, ElementsAre(testing::Lt(1e-6), 1e-6, 4e-6));
  EXPECT_THAT(of_all.factors, ElementsAre(0, DoubleEq(1), 4)) << "what it is when the step begins";
  const TimeTable of_own = table("", "*CLOAD, AMPLITUDE=own\ntop, 1, 1.\n");
  EXPECT_THAT(of_own.times, ElementsAre(testing::Lt(1e-6), 1e-6, DoubleEq(5e-6)));
  EXPECT_THAT(of_own.factors, ElementsAre(0, 0, 4));
  const std::string moved = "*BOUNDARY, TYPE=VELOCITY, AMPLITUDE=";
  EXPECT_THAT(table("", moved + "own\ntop, 1, 1, 1.\n").times, ElementsAre(1e-6, DoubleEq(5e-6)));
  EXPECT_THAT(table("", moved + "all\ntop, 1, 1, 1.\n").times, ElementsAre(0, 4e-6));
}

TEST_F(AbaqusSteps, WriteAsOftenAsTheOneThatAsksForMost) {
  const Scene s = steps("", "*OUTPUT, FIELD, NUMBER INTERVAL=2\n", "*OUTPUT, FIELD, NUMBER INTERVAL=2\n");
  EXPECT_DOUBLE_EQ(s.output.field_interval, 5e-7);
}

TEST_F(AbaqusSteps, MayNotChangeWhatHasNoBeginning) {
  const auto message = [this](const std::string& first, const std::string& second) {
    return error(deck("*AMPLITUDE, NAME=a\n0., 0., 1., 1.\n", first, second));
  };
  EXPECT_THAT(message("", "*CONTACT\n"), HasSubstr("*CONTACT in a step behind the first"));
  EXPECT_THAT(message("", "*BOUNDARY, TYPE=ACCELERATION, AMPLITUDE=a\ntop, 1, 1, 1.\n"),
              HasSubstr("a later step gives no accelerations"));
  EXPECT_THAT(message("*BULK VISCOSITY\n0.06, 1.2\n", "*BULK VISCOSITY\n0.1, 1.2\n"),
              HasSubstr("*BULK VISCOSITY that is another one than before (deck.inp:34)"));
  EXPECT_THAT(message("", "*BULK VISCOSITY\n0.1, 1.2\n"),
              HasSubstr("*BULK VISCOSITY that is another one than before (deck.inp:32)"));
  EXPECT_EQ(message("", "*BULK VISCOSITY\n0.06, 1.2\n"), no_error) << "what held before";
  EXPECT_EQ(message("*BULK VISCOSITY\n0.1, 1.2\n", ""), no_error) << "it goes on";
  EXPECT_THAT(error(abaqus_cube + abaqus_steel + abaqus_step() +
                    "*STEP\n*DYNAMIC, EXPLICIT, SCALE FACTOR=0.5\n, 1e-6\n*END STEP\n"),
              HasSubstr("*DYNAMIC: another SCALE FACTOR than in a step before"));
  EXPECT_THAT(error(abaqus_cube + abaqus_steel + abaqus_step() +
                    "*STEP, AMPLITUDE=RAMP\n*DYNAMIC, EXPLICIT\n, 1e-6\n*END STEP\n"),
              HasSubstr("*STEP, AMPLITUDE=RAMP beside other steps"));
  EXPECT_THAT(error(abaqus_cube + abaqus_steel + "*STEP\n*END STEP\n" + abaqus_step()),
              HasSubstr("deck.inp:23: expected *STEP with *DYNAMIC, EXPLICIT"));
}

/// What acts in a step is refused elsewhere: it would act in all of them, or hide what a step says.
TEST_F(AbaqusSteps, HaveTheirKeywordsInThem) {
  for (const std::string keywords : {"*CLOAD\ntop, 1, 1.\n", "*DLOAD\n, GRAV, 9., 0., 0., -1.\n",
                                     "*FIXED MASS SCALING, FACTOR=4.\n", "*BULK VISCOSITY\n0.1, 1.\n"}) {
    const std::string name = keywords.substr(0, keywords.find_first_of(",\n"));
    EXPECT_EQ(error(abaqus_cube + abaqus_steel + abaqus_step(keywords)), no_error) << keywords;
    for (const std::string& deck : {keywords + abaqus_step(), abaqus_step() + keywords}) {
      EXPECT_THAT(error(abaqus_cube + abaqus_steel + deck), HasSubstr(name + " outside of a step (deck.inp:"));
    }
  }
  const std::string held = "*BOUNDARY\nbase, 1, 3\n";
  EXPECT_EQ(error(abaqus_cube + abaqus_steel + held + abaqus_step()), no_error);
  EXPECT_THAT(error(abaqus_cube + abaqus_steel + abaqus_step() + held), HasSubstr("*BOUNDARY behind *END STEP ("));
}

/// Of a node the last line counts, also where a set stands in several of them; nothing is left to report.
TEST_F(AbaqusSteps, BeginWithTheLastVelocityThatIsGiven) {
  const std::string head = abaqus_cube + abaqus_steel + "*NSET, NSET=all\n1, 2, 3, 4, 5, 6, 7, 8\n",
                    lines = "*INITIAL CONDITIONS, TYPE=VELOCITY\nall, 1, 5.\ntop, 1, 7.\nall, 1, 9.\ntop, 2, 3.\n";
  const Model<double> model = build_model<double>(scene(head + lines + abaqus_step()));
  for (std::size_t n = 0; n < 8; ++n) {
    EXPECT_EQ(model.nodes.velocity[4 * n], 9) << n;
    EXPECT_EQ(model.nodes.velocity[4 * n + 1], n < 4 ? 0 : 3) << n;
  }
  for (const std::string& line : translate(head + lines + abaqus_step()).understood)
    EXPECT_EQ(line.find("not used: *INITIAL"), std::string::npos) << line;
}

}  // namespace
}  // namespace pinball::test::abaqus_steps_test
