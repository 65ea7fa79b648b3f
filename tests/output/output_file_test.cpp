#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include <solver/base/error.hpp>
#include <solver/output/history.hpp>
#include <solver/output/output_file.hpp>
#include <tests/support/error_of.hpp>
#include <tests/support/output_case.hpp>

/// Files that are written, and what is refused before.
namespace pinball::output_file_test {
namespace {

using test::error_of;
using test::TemporaryFolder;

TEST(OutputFile, ADeviceIsWrittenAndStays) {
  const TemporaryFolder folder("device");
  std::filesystem::create_symlink("/dev/null", folder / "null");
  OutputFile file(folder / "null");
  file.write("text");
  file.commit();
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "null"));
  EXPECT_FALSE(std::filesystem::exists(folder / "null.part"));
}

TEST(History, TwoColumnsOfOneNameAreRefused) {
  EXPECT_THAT(error_of<InputError>([] { history_column_names({"bar"}, {"bar_max_plastic_strain"}); }),
              testing::HasSubstr("two columns of history.csv would have the name bar_max_plastic_strain"));
}

}  // namespace
}  // namespace pinball::output_file_test
