#include <gmock/gmock.h>

#include <solver/results/warnings.hpp>

namespace pinball {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

RunSummary sound() {
  RunSummary s;
  s.contact_method = "pinball";
  s.balance_error_max = 0.1;
  s.max_penetration_ratio = 0.25;
  s.bodies.resize(2);
  return s;
}

TEST(Warnings, ASoundRunHasNone) { EXPECT_THAT(warnings(sound()), IsEmpty()); }

TEST(Warnings, EnergyBalance) {
  RunSummary s = sound();
  s.balance_error_max = 0.4;
  EXPECT_THAT(warnings(s), ElementsAre(HasSubstr("off by up to 40 %: try a smaller time.cfl or contact.beta")));
  s.contact_method = "none";
  EXPECT_THAT(warnings(s), ElementsAre(testing::EndsWith("time.cfl")));
}

TEST(Warnings, PenetrationUnlessSomethingEroded) {
  RunSummary s = sound();
  s.max_penetration_ratio = 0.6;
  EXPECT_THAT(warnings(s), ElementsAre(HasSubstr("into each other by up to 60 %")));
  s.bodies[1].eroded_elements = 1;
  EXPECT_THAT(warnings(s), IsEmpty());
}

TEST(Warnings, SweepsThatWereNotEnough) {
  RunSummary s = sound();
  s.sweeps = {100, 5000, 50, 100, 10};
  EXPECT_THAT(warnings(s), IsEmpty());
  s.sweeps.unsolved = 11;
  EXPECT_THAT(warnings(s), ElementsAre(HasSubstr("not solved for in 11 of 100 steps with contact, where 50 sweeps")));
}

TEST(Warnings, Overlap) {
  RunSummary s = sound();
  s.overlapping_bodies = "a and b";
  EXPECT_THAT(warnings(s), ElementsAre(HasSubstr("bodies a and b overlap at the start")));
}

}  // namespace
}  // namespace pinball
