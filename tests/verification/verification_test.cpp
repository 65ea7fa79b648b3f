#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include <solver/program/commands.hpp>
#include <solver/verification/verification.hpp>
#include <tests/support/solver_case.hpp>  // one thread

/// Every row of `pinball verify` passes. Where PINBALL_VERIFIED names a folder, the rows of a scene are left there in
/// SCENE.json, for the test that compares them with docs/verification.md: no scene runs twice for it.
namespace pinball::verification_test {
namespace {

std::vector<std::string> scenes() {
  std::vector<std::string> names;
  for (const VerificationCase& verification : verification_cases()) names.emplace_back(verification.scene);
  return names;
}

class Verification : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Scenes, Verification, testing::ValuesIn(scenes()),
                         [](const auto& scene) { return scene.param; });

TEST_P(Verification, Passes) {
#ifndef NDEBUG
  GTEST_SKIP() << "takes minutes without optimisation";
#endif
  VerifyOptions options;
  options.scenes = {GetParam()};
  if (const char* folder = std::getenv("PINBALL_VERIFIED")) {
    std::filesystem::create_directories(folder);
    options.json = (std::filesystem::path(folder) / (GetParam() + ".json")).string();
  }
  EXPECT_EQ(verify_command(options), 0) << "the rows that fail stand in the table above";
}

}  // namespace
}  // namespace pinball::verification_test
