#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <string>

#include <tests/support/output_case.hpp>
#include <tests/support/program.hpp>
#include <tests/support/scene_text.hpp>

/// --device, from outside.
namespace pinball::device_option_test {
namespace {

using test::Finished;
using test::run;

/// What `info --device` says of a device.
std::string said_of(const std::string& device) {
  const Finished info = run("info --device");
  EXPECT_EQ(info.status, 0) << info.text;
  std::smatch match;
  return std::regex_search(info.text, match, std::regex("\n  " + device + ": ([^\n]*)")) ? match[1].str() : "";
}

TEST(DeviceOption, SaysWhichDevicesThereAre) {
  EXPECT_EQ(said_of("none"), "threads of the host");
  EXPECT_THAT(said_of("mock"), testing::MatchesRegex("threads of the host, on memory that .* closes to it"));
  EXPECT_EQ(run("info").status, 2);
}

TEST(DeviceOption, ThatNamesWhatIsNotThereIsBadInput) {
  const test::TemporaryFolder folder("device_option");
  const std::string file = folder / "scene.toml", out = folder / "out";
  std::ofstream(file) << test::cube_scene;
  int missing = 0;
  for (const std::string device : {"cuda", "hip"}) {
    const std::string said = said_of(device), head = "not there: ";
    if (!said.starts_with(head)) continue;
    ++missing;
    for (const std::string& command : {"run " + file + " --quiet --out " + out, std::string("verify block"),
                                       "compare " + file, "run --restart " + file}) {
      const Finished f = run(command + " --device " + device);
      EXPECT_EQ(f.status, 2) << f.text;
      EXPECT_EQ(f.text, "pinball: error: device " + device + ": " + said.substr(head.size()) + "\n");
    }
  }
  EXPECT_GE(missing, 1) << "no program is built for both";
  EXPECT_FALSE(std::filesystem::exists(out));
  EXPECT_EQ(run("run " + file + " --device gpu").status, 2);
}

TEST(DeviceOption, IsInTheSummary) {
  const test::TemporaryFolder folder("device_summary");
  const std::string file = folder / "scene.toml", out = folder / "out";
  std::ofstream(file) << test::cube_scene;
  ASSERT_EQ(run("run " + file + " --quiet --device none --out " + out).status, 0);
  EXPECT_THAT(test::content(out + "/summary.json"), testing::HasSubstr("\"device\": \"none\""));
}

}  // namespace
}  // namespace pinball::device_option_test
