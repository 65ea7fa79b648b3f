#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <string>

#include <tests/support/output_case.hpp>
#include <tests/support/program.hpp>

/// The memory of the program, from outside.
namespace pinball::program_memory_test {
namespace {

using test::Finished;
using test::run;

struct ProgramMemory : testing::Test {
  test::TemporaryFolder folder_{testing::UnitTest::GetInstance()->current_test_info()->name()};
};

/// Largest memory in kB of a run that keeps a copy of its state, as all do that take long enough.
long peak_memory(const std::string& folder, const char* refine, const std::string& scene = "rod_plate") {
  const pid_t child = ::fork();
  if (child == 0) {
    ::execl(PINBALL_PROGRAM, "pinball", "run", scene.c_str(), "--quiet", "--threads", "1", "--set", "time.steps=3",
            "--checkpoint-every", "2", "--refine", refine, "--out", folder.c_str(), nullptr);
    ::_exit(127);
  }
  int status = 0;
  rusage usage{};
  ::wait4(child, &status, 0, &usage);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  return usage.ru_maxrss;
}

TEST_F(ProgramMemory, PerElementIsBounded) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer keeps what is freed, and has memory of its own";
#endif
  // The program and its libraries are in both; the difference is the stores, the mesh while it is made, and the last
  // state.
  const double kilobytes = static_cast<double>(peak_memory(folder_ / "out", "3") - peak_memory(folder_ / "out", "1"));
  EXPECT_LT(kilobytes * 1024 / (26 * (414 + 1428)), 2000);
}

/// What is refused beforehand is what would not fit, and no less: a cube with little to store, and with contact.
TEST_F(ProgramMemory, AskedForBeforehandIsThatOfARun) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer keeps what is freed, and has memory of its own";
#endif
  const std::string cube = R"(
units = "kg-m-s"
time = { end = 1 }
[[material]]
name = "steel"
model = "elastic"
density = 7850
young_modulus = 2e11
poisson_ratio = 0.3
[[body]]
name = "cube"
material = "steel"
mesh = { type = "block", size = [1, 1, 1], elements = [10, 10, 10] }
)";
  const std::string path = folder_ / "cube.toml";
  for (const char* settings :
       {"precision = \"float\"\nelement = { hourglass = \"viscous\" }\n", "contact = { method = \"pinball\" }\n"}) {
    std::ofstream(path) << settings << cube;
    const Finished f = run("run --refine 79 " + path + " --out " + (folder_ / "out"));
    const std::size_t said = f.text.find("expected at most");
    if (f.status == 0 || said == std::string::npos) GTEST_SKIP() << "this machine holds any mesh: " << f.text;
    double most = 0, gibibytes = 0;
    ASSERT_EQ(std::sscanf(f.text.c_str() + said, "expected at most %lg for %lg", &most, &gibibytes), 2) << f.text;
    const auto kilobytes =
        static_cast<double>(peak_memory(folder_ / "out", "8", path) - peak_memory(folder_ / "out", "1", path));
    const double measured = kilobytes * 1024 / (80 * 80 * 80 - 10 * 10 * 10);
    const double assumed = gibibytes * 1073741824 / most;
    EXPECT_LT(assumed, 1.05 * measured) << settings;
    EXPECT_GT(assumed, 0.7 * measured) << settings;
  }
}

}  // namespace
}  // namespace pinball::program_memory_test
