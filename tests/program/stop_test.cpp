#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include <tests/support/output_case.hpp>
#include <tests/support/program.hpp>

/// The program from outside: what signals, a second run and missing streams do to it.
namespace pinball::stop_test {
namespace {

using Json = nlohmann::json;
using test::content;
using test::Finished;
using test::run;
using testing::HasSubstr;
using testing::Not;

class Stops : public testing::Test {
 protected:
  /// The tests may be run with signals ignored (nohup), as if they always were; what start() starts begins without.
  Stops() {
    for (const int signal : {SIGINT, SIGHUP, SIGUSR1, SIGXCPU}) ::signal(signal, SIG_IGN);
  }
  ~Stops() override {
    if (process_ > 0) end_with(SIGKILL);
  }
  /// Starts the program; what it says goes into a file.
  void start(std::vector<std::string> arguments) {
    std::vector<char*> argv{const_cast<char*>("pinball")};
    for (std::string& a : arguments) argv.push_back(a.data());
    argv.push_back(nullptr);
    process_ = ::fork();
    if (process_ != 0) return;
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGUSR1, SIGXCPU}) ::signal(signal, SIG_DFL);
    if (without_terminal_) ::signal(SIGHUP, SIG_IGN);  // as nohup does
    const int log = ::open(log_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    ::dup2(log, 1);
    ::dup2(log, 2);
    ::execv(PINBALL_PROGRAM, argv.data());
    ::_exit(127);
  }
  /// A run of many steps, up to where it has made some.
  void start_long_run() {
    std::filesystem::remove_all(out_);
    start({"run", "rod_plate", "--refine", "2", "--threads", "1", "--out", out_, "--set", "output.interval=step",
           "--set", "output.field_interval=1e-6"});
    while (content(out_ + "/history.csv").size() < 20000 && ::waitpid(process_, nullptr, WNOHANG) == 0) ::usleep(1000);
  }
  /// The status of the process; 1000 + signal where one has killed it.
  int end_with(int signal) {
    if (signal != 0) ::kill(process_, signal);
    int status = 0;
    ::waitpid(process_, &status, 0);
    process_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
  }
  /// The exit status of the program with these arguments and redirections.
  static int in_shell(const std::string& arguments) {
    const int status = std::system((std::string(PINBALL_PROGRAM) + ' ' + arguments).c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  Json summary() const { return Json::parse(content(out_ + "/summary.json")); }

  bool without_terminal_ = false;  ///< of what start() starts
  test::TemporaryFolder folder_{testing::UnitTest::GetInstance()->current_test_info()->name()};
  std::string out_ = folder_ / "out", log_ = folder_ / "log";
  pid_t process_ = 0;
};

TEST_F(Stops, ASignalEndsARunAfterItsStepWithAllItsFiles) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGUSR1, SIGXCPU}) {
    start_long_run();
    EXPECT_EQ(end_with(signal), 128 + signal);
    const Json json = summary();
    EXPECT_EQ(json["status"], "stopped");
    EXPECT_LT(json["end_time"], 5e-5);
    const std::string file = out_ + "/checkpoint.pinball", log = content(log_);
    EXPECT_THAT(log, HasSubstr("ends after this step"));
    EXPECT_THAT(log, HasSubstr("this goes on: pinball run --restart " + file));
    EXPECT_FALSE(std::filesystem::exists(out_ + "/pinball.lock"));
    const std::string more = " --quiet --set time.steps=" + std::to_string(json["steps"].get<int>() + 3);
    const Finished f = run("run --restart " + file + more);
    EXPECT_EQ(f.status, 0) << f.text;
    EXPECT_EQ(summary()["status"], "done");
  }
}

TEST_F(Stops, ALogThatNobodyReadsEndsNoRun) {
  const std::string steps = " --set time.steps=300 --set output.field_interval=1e-6 --out " + out_;
  in_shell("run rod_plate" + steps + " 2>&1 >/dev/null | head -c 1 >/dev/null");
  for (int wait = 0; wait < 300 && summary()["status"] == "running"; ++wait) ::usleep(100000);
  EXPECT_EQ(summary()["status"], "done");
}

TEST_F(Stops, AFileThatMayNotGrowIsAnErrorThatNamesIt) {
  const Finished f = run("run rod_plate --set output.interval=step --out " + out_, "ulimit -f 40;");
  EXPECT_EQ(f.status, 1) << f.text;
  EXPECT_THAT(f.text, HasSubstr("pinball: error: cannot write " + out_));
  EXPECT_THAT(f.text, HasSubstr("File too large"));
}

TEST_F(Stops, ARunWithoutATerminalGoesOn) {
  without_terminal_ = true;
  start_long_run();
  ::kill(process_, SIGHUP);
  ::usleep(50000);
  EXPECT_EQ(end_with(SIGINT), 130);
  EXPECT_EQ(summary()["status"], "stopped");
}

TEST_F(Stops, AKilledRunIsOneThatRuns) {
  start_long_run();
  EXPECT_EQ(end_with(SIGKILL), 1000 + SIGKILL);
  EXPECT_EQ(summary()["status"], "running");
  EXPECT_EQ(summary()["elements"], 14736);
  EXPECT_TRUE(std::filesystem::exists(out_ + "/fields.pvd"));
  EXPECT_EQ(run("run two_blocks --set output.field_interval=0 --quiet --out " + out_).status,
            0);  // its lock has died with it
  EXPECT_EQ(summary()["scene"], "two_blocks");
  EXPECT_FALSE(std::filesystem::exists(out_ + "/fields.pvd"));
}

TEST_F(Stops, ASecondSignalEndsARunAtOnce) {
  start_long_run();
  ::kill(process_, SIGSTOP);  // both are there before the step ends
  ::kill(process_, SIGINT);
  ::kill(process_, SIGTERM);
  const int status = end_with(SIGCONT);
  EXPECT_TRUE(status == 130 || status == 143) << status;
  EXPECT_EQ(summary()["status"], "running");
}

TEST_F(Stops, ComparisonsEndAtOnce) {
  for (const std::vector<std::string>& command : {std::vector<std::string>{"compare", "rod_plate", "--refine", "2"},
                                                  std::vector<std::string>{"verify", "rod_oblique"}}) {
    start(command);
    ::usleep(200000);
    EXPECT_EQ(end_with(SIGINT), 130) << command[0];
    start(command);
    ::usleep(200000);
    EXPECT_EQ(end_with(SIGTERM), 143) << command[0];
    start(command);
    ::usleep(200000);
    EXPECT_EQ(end_with(SIGHUP), 129) << command[0];
  }
}

TEST_F(Stops, ASignalLeavesTheRunsOfAStudyThatAreDone) {
  start({"converge", "two_blocks", "--threads", "1", "--out", out_, "--meshes", "1/4,1/2,8"});
  while (content(out_ + "/mesh_8/history.csv").empty() && ::waitpid(process_, nullptr, WNOHANG) == 0) ::usleep(1000);
  EXPECT_EQ(end_with(SIGINT), 130);
  EXPECT_THAT(content(log_), HasSubstr("stopped; what is done stays in " + out_));
  EXPECT_EQ(Json::parse(content(out_ + "/mesh_8/summary.json"))["status"], "stopped");
  const Finished f = run("converge two_blocks --threads 1 --meshes 1/4,1/2,1 --out " + out_);
  EXPECT_EQ(f.status, 0);
  EXPECT_THAT(f.text, HasSubstr("is there: mesh 2 of 3"));
}

/// A search goes on where it was, too.
TEST_F(Stops, ASignalLeavesTheRunsOfASearch) {
  const std::string options =
      "--threads 1 --only mesh --of energy.kinetic --budget 5min --meshes 1/4,1/2,1 --out " + out_;
  for (const int signal : {SIGTERM, SIGUSR1}) {
    start({"converge", "two_blocks", "--threads", "1", "--only", "mesh", "--of", "energy.kinetic", "--budget", "5min",
           "--meshes", "1/4,1/2,1", "--out", out_});
    while (content(out_ + "/mesh_8/history.csv").empty() && ::waitpid(process_, nullptr, WNOHANG) == 0) ::usleep(1000);
    EXPECT_EQ(end_with(signal), 128 + signal);
    EXPECT_EQ(Json::parse(content(out_ + "/mesh_8/summary.json"))["status"], "stopped");
    EXPECT_EQ(Json::parse(content(out_ + "/mesh_4/summary.json"))["status"], "done");
    EXPECT_THAT(content(log_), HasSubstr("the same command goes on"));
    std::filesystem::remove_all(out_ + "/mesh_8");
  }
  EXPECT_THAT(content(log_), HasSubstr("is there: one more mesh, elements 4 times"));
}

TEST_F(Stops, ASecondRunInTheFolderIsRefused) {
  start_long_run();
  const Finished f = run("run two_blocks --out " + out_);
  EXPECT_EQ(f.status, 2);
  EXPECT_THAT(f.text, HasSubstr("--out " + out_ + ": process " + std::to_string(process_) + " on "));
  EXPECT_EQ(summary()["scene"], "rod_plate");
}

TEST_F(Stops, ProgressGoesIntoNoFileWhereStderrIsClosed) {
  for (const char* closed : {"2>&-", "2>&- >&-", "2>&- >&- <&-"}) {
    EXPECT_EQ(in_shell("run two_blocks --set time.steps=20 --out " + out_ + " >/dev/null " + closed), 0);
    EXPECT_THAT(content(out_ + "/history.csv"), Not(HasSubstr("energy error"))) << closed;
  }
}

TEST_F(Stops, AFullStdoutIsAnError) {
  for (const char* command : {"--version", "--help", "info two_blocks", "verify patch_test",
                              "compare two_blocks --repeat 1 --quiet", "run two_blocks --quiet"}) {
    const std::string out = std::string(command).starts_with("run") ? " --out " + out_ : "";
    EXPECT_EQ(in_shell(command + out + " >/dev/full 2>" + log_), 1) << command;
    EXPECT_THAT(content(log_), HasSubstr("pinball: error: ")) << command;
  }
  EXPECT_EQ(summary()["status"], "done");
}

TEST_F(Stops, AFullStderrEndsNoRun) {
  // Progress, and a warning at the end: springs so soft let the bodies into each other.
  EXPECT_EQ(
      in_shell("run rod_plate --set contact.enforcement=penalty --set contact.beta=0.001 --set time.end=1e-5 --out " +
               out_ + " >/dev/null 2>/dev/full"),
      0);
  EXPECT_EQ(in_shell("run no_such 2>/dev/full"), 2);
}

TEST_F(Stops, AFileForTheTableThatCannotBeWrittenIsToldBeforeTheRuns) {
  for (const char* command :
       {"compare rod_plate --refine 100", "converge rod_plate --refine 100", "verify"}) {  // neither would end soon
    for (const std::string& path : {folder_ / "none/table.json", folder_.path.string(), std::string("''")}) {
      test::expect_bad_input(std::string(command) + " --json " + path, "--json");
    }
  }
}

}  // namespace
}  // namespace pinball::stop_test
