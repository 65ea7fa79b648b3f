#include <gmock/gmock.h>

#include <solver/results/warnings.hpp>

namespace pinball::warnings_test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

RunSummary sound() {
  RunSummary s;
  s.contact_method = "pinball";
  s.contact_enforcement = "penalty";
  s.contact_gap = "pinball";
  s.balance_error_in_motion.largest = 0.1;
  s.contact_created.largest = 0.01;
  s.contact_swallowed.largest = s.contact_swallowed_sound = 0.2;
  s.hourglass_large.largest = 0.1;
  s.hourglass_created.largest = 0.01;
  s.max_penetration_ratio = 0.25;
  s.bodies.resize(2);
  return s;
}

TEST(Warnings, ASoundRunHasNone) { EXPECT_THAT(warnings(sound()), IsEmpty()); }

TEST(Warnings, FormsOfContactSayWhatTheyCannotDo) {
  RunSummary s = sound();
  for (const char* enforcement : {"projection", "lagrange"}) {
    s.contact_enforcement = enforcement;
    EXPECT_THAT(start_warnings(s), IsEmpty()) << "balls";
  }
  s.contact_gap = "face";
  s.max_penetration_ratio = s.contact_swallowed.largest = 0;
  EXPECT_THAT(start_warnings(s), IsEmpty());
  s.contact_enforcement = "projection";
  EXPECT_THAT(start_warnings(s), ElementsAre(AllOf(HasSubstr("edges and corners"), HasSubstr("\"lagrange\""))));
  s.contact_method = "slideline";
  EXPECT_THAT(start_warnings(s), ElementsAre(AllOf(HasSubstr("edges that cross"), HasSubstr("folds onto itself"),
                                                   HasSubstr("contact.method = \"pinball\""))));
  s.contact_enforcement = "penalty";
  EXPECT_THAT(start_warnings(s), ElementsAre(HasSubstr("smaller than the faces")));
  EXPECT_EQ(start_warnings(s), warnings(s));
}

TEST(Warnings, EnergyBalance) {
  RunSummary s = sound();
  s.balance_error_in_motion = {0.4, 1.5e-4, "element 17 of body rod"};
  EXPECT_THAT(warnings(s), ElementsAre("the energy balance was off by up to 40 % of the energy in motion, beyond 10 % "
                                       "since time 0.00015 (the step was set by element 17 of body rod): try a smaller "
                                       "time.cfl or contact.beta"));
  s.contact_method = "none";
  EXPECT_THAT(warnings(s), ElementsAre(testing::EndsWith("time.cfl")));
}

/// Shorter steps lose more of what is slow.
TEST(Warnings, EnergyOfSinglePrecisionNamesIt) {
  for (WatchedShare RunSummary::*const share :
       {&RunSummary::balance_error_in_motion, &RunSummary::internal_below_zero}) {
    RunSummary s = sound();
    s.*share = {0.4, 1.5e-4, "element 17 of body rod"};
    s.precision = "float";
    EXPECT_THAT(warnings(s), ElementsAre(HasSubstr("try precision = \"mixed\", which keeps what is slow, or a smaller "
                                                   "time.cfl")));
    s.precision = "double";
    EXPECT_THAT(warnings(s), ElementsAre(testing::Not(HasSubstr("precision"))));
  }
}

TEST(Warnings, PenetrationUnlessSomethingEroded) {
  RunSummary s = sound();
  s.max_penetration_ratio = 0.6;
  s.max_penetration_time = 0.5;
  s.max_penetration_place = "node 3 of body b";
  EXPECT_THAT(warnings(s), ElementsAre(AllOf(HasSubstr("into each other by up to 60 %"),
                                             HasSubstr("at time 0.5 at node 3 of body b: try a larger contact.beta"))));
  s.bodies[1].eroded_elements = 1;
  EXPECT_THAT(warnings(s), IsEmpty());
}

TEST(Warnings, FacesThatImpulsesHoldApartMayNotBeDeep) {
  RunSummary s = sound();
  s.max_penetration_ratio = 0.06;
  s.contact_swallowed.largest = 0;
  s.contact_enforcement = "lagrange";
  EXPECT_THAT(warnings(s), IsEmpty()) << "balls";
  s.contact_gap = "face";
  EXPECT_THAT(warnings(s), ElementsAre(HasSubstr("up to 6 %")));
}

TEST(Warnings, ContactEnergy) {
  RunSummary s = sound();
  s.contact_created = {0.06, 2, "node 4 of body a"};
  EXPECT_THAT(warnings(s),
              ElementsAre(AllOf(HasSubstr("contact made energy out of nothing, up to 6 %"),
                                HasSubstr("beyond 1 % since time 2 (largest force on node 4 of body a)"))));
  s = sound();
  s.contact_swallowed = {0.6, 2, "node 4 of body a"};
  EXPECT_THAT(warnings(s), ElementsAre(AllOf(HasSubstr("contact swallowed 60 %"),
                                             HasSubstr("beyond 20 % since time 2 ("), HasSubstr("node 4 of body a"))));
  s.contact_swallowed_sound = 0;
  EXPECT_THAT(warnings(s), IsEmpty()) << "something is meant to swallow";
}

TEST(Warnings, HourglassEnergy) {
  RunSummary s = sound();
  s.hourglass_large = {0.34, 3, "element 5 of body a"};
  s.hourglass_created = {0.02, 4, "element 6 of body a"};
  EXPECT_THAT(
      warnings(s),
      ElementsAre(AllOf(HasSubstr("made energy out of nothing, up to 2 %"), HasSubstr("since time 4 (most of it in "
                                                                                      "element 6 of body a)")),
                  AllOf(HasSubstr("hourglass energy reached 34 %"), HasSubstr("since time 3 (most of it in element "
                                                                              "5 of body a)"))));
}

TEST(Warnings, WhatIsKnownAtTheStart) {
  RunSummary s = sound();
  EXPECT_THAT(start_warnings(s), IsEmpty());
  s.unseen_balls = "the balls of element 1 of body a and element 2 of body b never meet";
  EXPECT_THAT(warnings(s),
              ElementsAre(AllOf(testing::StartsWith(s.unseen_balls), HasSubstr("contact.gap = \"face\""))));
  EXPECT_EQ(start_warnings(s), warnings(s));
  s.unseen_balls = "";
  s.unstable_hourglass = "the hourglass coefficient is too large";
  EXPECT_THAT(warnings(s), ElementsAre(s.unstable_hourglass));
  EXPECT_EQ(start_warnings(s), warnings(s));
}

TEST(Warnings, WhatNobodyIsLikelyToMean) {
  RunSummary s = sound();
  s.unlikely = {"no two bodies can meet", "material m is of other units"};
  EXPECT_THAT(warnings(s), ElementsAre(s.unlikely[0], s.unlikely[1]));
  EXPECT_EQ(start_warnings(s), warnings(s));
}

TEST(Warnings, ContactThatDidNotConverge) {
  RunSummary s = sound();
  s.iterations = {100, 5000, 50, 3, 0, 0.16, 8e-4};
  EXPECT_THAT(warnings(s), IsEmpty());
  s.iterations.at_bound = 4;
  EXPECT_THAT(warnings(s), ElementsAre(AllOf(
                               HasSubstr("did not converge in 4 of 100 steps with contact (4 %), within 50 iterations"),
                               HasSubstr("0.16 of a velocity was left, 0.08 % of the largest"))));
}

TEST(Warnings, Overlaps) {
  RunSummary s = sound();
  s.overlaps = {{"pin", "plate", 0, 32, "node 17 of body pin", 0.5, 0.05}};
  EXPECT_THAT(warnings(s),
              ElementsAre(AllOf(HasSubstr("bodies pin and plate overlap at the start, by 32 of their nodes"),
                                HasSubstr("deepest at node 17 of body pin, which lies 0.5 deep (5 % of an element)"),
                                HasSubstr("contact.overlap = \"adjust\""))));
  EXPECT_EQ(start_warnings(s), warnings(s));
  s.overlaps[0].share = 0.29;
  EXPECT_THAT(warnings(s), ElementsAre(HasSubstr("lets such nodes pass")));
  s.overlaps[0] = {"a", "b", 12, 0, "", 0, 0};
  EXPECT_THAT(warnings(s), ElementsAre(HasSubstr("by 12 points or edges of their elements")));
  s.overlaps.assign(8, s.overlaps[0]);
  s.overlaps[7] = {"c", "d", 0, 1, "node 3 of body c", 0.1, 0.2};
  EXPECT_THAT(warnings(s), testing::SizeIs(6));
  EXPECT_THAT(warnings(s)[0], HasSubstr("bodies c and d"));
  EXPECT_THAT(warnings(s)[5], HasSubstr("3 more pairs of bodies overlap"));
}

}  // namespace
}  // namespace pinball::warnings_test
