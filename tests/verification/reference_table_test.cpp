#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include <solver/base/error.hpp>
#include <solver/verification/reference_table.hpp>
#include <tests/support/error_of.hpp>
#include <tests/support/output_case.hpp>

namespace pinball::reference_table_test {
namespace {

/// A file of the folder "reference" beside the scenes of a temporary folder.
ReferenceTable table_of(const test::TemporaryFolder& folder, const std::string& text) {
  std::filesystem::create_directories(folder.path / "scenes");
  std::filesystem::create_directories(folder.path / "reference");
  std::ofstream(folder / "reference/curve.csv") << text;
  return {folder / "scenes/x.toml", "curve.csv"};
}

std::string error(const test::TemporaryFolder& folder, const std::string& text) {
  return test::error_of([&] { table_of(folder, text).column("x"); });
}

TEST(ReferenceTable, ReadsNamedColumns) {
  const test::TemporaryFolder folder("reference");
  const ReferenceTable table = table_of(folder, "t,x y\n0,1\n0.5,-2e3\n");
  EXPECT_EQ(table.rows(), 2u);
  EXPECT_EQ(table.column("t"), (std::vector<double>{0, 0.5}));
  EXPECT_EQ(table.column("x y"), (std::vector<double>{1, -2000}));
}

TEST(ReferenceTable, ErrorsNameFileAndLine) {
  const test::TemporaryFolder folder("reference_errors");
  EXPECT_THAT(error(folder, "t,y\n0,1\n"), testing::EndsWith("reference/curve.csv: expected a column x"));
  EXPECT_THAT(error(folder, "t,x\n0,1\n2,word\n"), testing::EndsWith("curve.csv:3: expected 2 numbers"));
  EXPECT_THAT(error(folder, "t,x\n0\n"), testing::EndsWith("curve.csv:2: expected 2 numbers"));
  EXPECT_THAT(error(folder, ""), testing::EndsWith("curve.csv: no such file, or it is empty"));
}

}  // namespace
}  // namespace pinball::reference_table_test
