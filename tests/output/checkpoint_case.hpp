#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include <tests/support/output_case.hpp>
#include <tests/support/program.hpp>

namespace pinball::test {

/// Runs of the program, and what they leave to go on from.
class Checkpoints : public testing::Test {
 protected:
  /// Runs and expects it to end well.
  static void expect_done(const std::string& arguments) {
    const Finished f = run("run --quiet " + arguments);
    EXPECT_EQ(f.status, 0) << arguments << '\n' << f.text;
  }
  static void expect_input_error(const std::string& arguments, const std::string& message) {
    expect_bad_input("run --quiet " + arguments, message);
  }
  /// summary.json but for times, threads and the memory that arrays happened to take.
  static std::string result(const std::string& folder) {
    auto json = nlohmann::json::parse(content(folder + "/summary.json"));
    for (const char* key : {"wall_seconds", "phase_seconds", "element_steps_per_second", "skipped_seconds", "threads",
                            "bytes_per_element", "started"}) {
      json.erase(key);
    }
    return json.dump(1);
  }
  static void expect_same_results(const std::string& folder, const std::string& other) {
    EXPECT_EQ(result(folder), result(other));
    for (const char* name : {"/history.csv", "/fields.pvd"}) EXPECT_EQ(content(folder + name), content(other + name));
  }
  static bool exists(const std::string& path) { return std::filesystem::exists(path); }
  /// The same scene stopped early: a checkpoint of its middle.
  void leave_checkpoint(const std::string& scene, int steps) {
    expect_done(scene + " --checkpoint-every 1000000 --set time.steps=" + std::to_string(steps) + " --out " + half_);
  }

  TemporaryFolder folder_{testing::UnitTest::GetInstance()->current_test_info()->name()};
  std::string whole_ = folder_ / "whole", half_ = folder_ / "half", other_ = folder_ / "other";
  std::string file_ = half_ + "/checkpoint.pinball";
};

}  // namespace pinball::test
