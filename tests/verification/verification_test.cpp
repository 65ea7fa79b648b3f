#include <gtest/gtest.h>

#include <algorithm>

#include <solver/verification/verification.hpp>
#include <tests/support/solver_case.hpp>  // one thread

/// Every row of `pinball verify` passes.
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
  const auto& all = verification_cases();
  const auto found =
      std::find_if(all.begin(), all.end(), [](const VerificationCase& c) { return c.scene == GetParam(); });
  for (const VerificationRow& row : verify_scene(*found)) {
    EXPECT_TRUE(row.pass) << row.quantity << ": " << row.value << ", expected " << row.reference << " within "
                          << row.tolerance;
  }
}

}  // namespace
}  // namespace pinball::verification_test
