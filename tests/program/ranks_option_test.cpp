#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include <tests/support/output_case.hpp>
#include <tests/support/program.hpp>
#include <tests/support/scene_text.hpp>

/// info --ranks, from outside.
namespace pinball::ranks_option_test {
namespace {

using test::Finished;
using test::run;

class RanksOption : public testing::Test {
 protected:
  void SetUp() override { std::ofstream(file_) << test::cube_scene; }
  Finished info(const std::string& more) const { return run("info " + file_ + " " + more); }

 private:
  const test::TemporaryFolder folder_{"ranks_option"};
  const std::string file_ = folder_ / "scene.toml";
};

TEST_F(RanksOption, HasALineForEachNumber) {
  const Finished f = info("--ranks 2,3 --refine 4");
  EXPECT_EQ(f.status, 0) << f.text;
  EXPECT_THAT(f.text, testing::ContainsRegex("\non several processes \\(mpirun -n\\)\nranks  +most elements[^\n]*"
                                             "\n +2 [^\n]* kB\n +3 [^\n]* kB\n"));
  EXPECT_THAT(info("").text, testing::Not(testing::HasSubstr("mpirun")));
}

TEST_F(RanksOption, KnowsRanksWithSubcycling) {
  const Finished f = info("--ranks 2 --refine 4 --set time.subcycling=true");
  EXPECT_EQ(f.status, 0) << f.text;
  EXPECT_THAT(f.text, testing::ContainsRegex("\nranks  +most elements[^\n]*\n +2 [^\n]* kB\n"));
}

TEST_F(RanksOption, RefusesWhatIsNoNumberOfProcesses) {
  for (const std::string given : {"1", "0", "-2", "two", "2,1", "2+3"})
    EXPECT_EQ(info("--ranks " + given).status, 2) << given;
}

}  // namespace
}  // namespace pinball::ranks_option_test
