#include <fstream>
#include <string>

#include <tests/support/scene_text.hpp>

#include "checkpoint_case.hpp"

/// What a failing run says, and the last good state that it leaves.
namespace pinball::failed_runs_test {
namespace {

using test::Checkpoints;
using test::cube_scene;
using test::Finished;
using test::replaced;
using test::run;
using testing::HasSubstr;

/// A cube alone, whose steps are unstable above a cfl of 1.
class FailedRuns : public Checkpoints {
 protected:
  void SetUp() override {
    std::ofstream(folder_ / "scene.toml") << replaced(cube_scene, "end = 1e-4", "end = 1e-2\ncfl = 1.2");
  }
  /// Expects a run to fail, and its last good state to go on with these changes, in which BEFORE is the last step that
  /// did not fail: at which of them the state was kept depends on how fast the run was.
  void expect_failure(const std::string& arguments, const std::string& message, const std::string& changes) {
    const Finished f = run("run --quiet " + (folder_ / "scene.toml") + ' ' + arguments + " --out " + half_);
    EXPECT_EQ(f.status, 1) << f.text;
    EXPECT_THAT(f.text, HasSubstr(message));
    EXPECT_THAT(f.text, HasSubstr("in step"));
    EXPECT_THAT(f.text, HasSubstr(": try "));
    EXPECT_THAT(f.text, HasSubstr("last_good.vtu and, for --restart, in " + half_ + "/last_good.pinball"));
    EXPECT_TRUE(exists(half_ + "/last_good.vtu"));
    const std::string last_good = "--restart " + half_ + "/last_good.pinball ";
    const Finished again = run("run --quiet " + last_good + "--out " + other_);  // the same bits, the same failure
    EXPECT_EQ(again.status, 1) << again.text;
    EXPECT_EQ(again.text.substr(0, again.text.find(';')), f.text.substr(0, f.text.find(';')));
    const int failed = std::stoi(f.text.substr(f.text.find("in step ") + 8));
    const bool bounded = changes.find("BEFORE") != std::string::npos;
    expect_done(last_good + (bounded ? replaced(changes, "BEFORE", std::to_string(failed - 1)) : changes));
    EXPECT_FALSE(exists(half_ + "/last_good.vtu"));
  }
};

TEST_F(FailedRuns, EnergyBalance) { expect_failure("", "energy balance", "--set time.cfl=0.9"); }
TEST_F(FailedRuns, NegativeVolume) {
  expect_failure("--set guard.energy_error=1e30", "no volume", "--set time.steps=BEFORE");
}
TEST_F(FailedRuns, NotFinite) {
  const std::string load = R"(
[[load]]
body = "cube"
force = [1e308, 0, 0]
times = [1e-3, 1.1e-3]
factors = [0, 1e10]
)";
  std::ofstream(folder_ / "scene.toml", std::ios::app) << load;
  expect_failure("--set time.cfl=0.5 --set output.interval=3e-4",
                 "a node of element 0 of body cube has a velocity that is not finite", "--set time.end=0.95e-3");
}
TEST_F(FailedRuns, CollapsedStep) {
  expect_failure("--set time.cfl=0.5 --set guard.time_step_collapse=1", "collapsed",
                 "--set guard.time_step_collapse=0");
}

}  // namespace
}  // namespace pinball::failed_runs_test
