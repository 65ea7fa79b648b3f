#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include <solver/scene.hpp>
#include <tests/support/output_case.hpp>
#include <tests/support/program.hpp>

/// `pinball new`, and what --help tells.
namespace pinball::new_test {
namespace {

using test::content;
using test::Finished;
using test::run;
using testing::AllOf;
using testing::HasSubstr;

class New : public testing::Test {
 protected:
  Finished create(const std::string& arguments) {
    return run("new " + arguments + " --out " + std::string(folder_ / ""));
  }
  test::TemporaryFolder folder_{testing::UnitTest::GetInstance()->current_test_info()->name()};
};

TEST_F(New, WritesASceneThatRunsSoundly) {
  const Finished made = create("impact");
  ASSERT_EQ(made.status, 0) << made.text;
  const std::string path = folder_ / "impact.toml";
  EXPECT_THAT(made.text, AllOf(HasSubstr("pinball info " + path), HasSubstr("pinball run " + path)));
  EXPECT_THAT(content(path), testing::Not(HasSubstr("NAME")));
  EXPECT_EQ(read_scene(path).bodies.size(), 2);  // every key is known

  const std::string out = folder_ / "out";
  const Finished ran = run("run " + path + " --quiet --out " + out);
  ASSERT_EQ(ran.status, 0) << ran.text;
  const auto summary = nlohmann::json::parse(content(out + "/summary.json"));
  for (const auto& warning : summary["warnings"]) {  // that of iterations which do not converge is true
    EXPECT_THAT(warning.get<std::string>(), HasSubstr("impulses of contact did not converge"));
  }
  EXPECT_LT(summary["energy"]["balance_error_max"].get<double>(), 1e-3);
  EXPECT_GT(summary["contact"]["pairs_max"].get<int>(), 0);
  EXPECT_TRUE(std::filesystem::exists(out + "/fields.pvd"));
}

TEST_F(New, KeepsWhatIsThere) {
  const std::string path = folder_ / "mine.toml";
  std::ofstream(path) << "mine";
  const Finished refused = create("mine.toml");
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.text, AllOf(HasSubstr(path), HasSubstr("--force")));
  EXPECT_EQ(content(path), "mine");
  EXPECT_EQ(create("mine --force").status, 0);
  EXPECT_THAT(content(path), HasSubstr("out/mine"));
}

TEST_F(New, RefusesWhatIsNoName) {
  for (const char* name : {"''", "a/b", "../x", "'a b'", "x.toml.toml"}) EXPECT_EQ(create(name).status, 2) << name;
  EXPECT_EQ(run("new").status, 2);
  const Finished nowhere = run("new x --out /nowhere/at/all");
  EXPECT_EQ(nowhere.status, 2);
  EXPECT_THAT(nowhere.text, HasSubstr("/nowhere/at/all/x.toml: cannot be written"));
}

TEST(Help, HasTwoExamplesAndSaysWhereKeysAre) {
  for (const std::string verb : {"run", "info", "compare", "verify", "new"}) {
    const Finished help = run(verb + " --help");
    EXPECT_EQ(help.status, 0);
    const std::size_t examples = help.text.find("Examples:");
    ASSERT_NE(examples, std::string::npos) << help.text;
    const std::string command = "\n    pinball " + verb + " ";
    const std::size_t first = help.text.find(command, examples);
    ASSERT_NE(first, std::string::npos) << help.text;
    EXPECT_NE(help.text.find(command, first + 1), std::string::npos) << help.text;
    EXPECT_THAT(help.text, HasSubstr("share/pinball/data/scenes/README.md"));
  }
}

}  // namespace
}  // namespace pinball::new_test
