#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <solver/output/field_output.hpp>
#include <solver/output/history.hpp>
#include <tests/support/output_case.hpp>
#include <tests/support/program.hpp>

// pinball view: what it needs VTK for is tested in tests/view.
namespace pinball::view_test {
namespace {

void write_case(const test::TemporaryFolder& folder) {
  FieldWriter fields(folder.path.string(), "fields", {}, "in-lbf-s", {}, {"rod", "plate"});
  HistoryWriter history(folder.path.string(), {"rod", "plate"});
  for (int i = 0; i < 2; ++i) {
    fields.write(test::two_blocks(2.5e-5 * i, 0.1 * i));
    history.write(test::history_row(i, 2.5e-5 * i));
  }
}

TEST(View, DrawsTheHistory) {
  const test::TemporaryFolder folder("view");
  write_case(folder);
  const test::Finished view = test::run("view '" + folder.path.string() + "' --history");
  EXPECT_EQ(view.status, 0) << view.text;
  EXPECT_EQ(view.text, folder / "history.png\n");
  EXPECT_EQ(test::content(folder / "history.png").substr(1, 3), "PNG");
}

TEST(View, ReadsWhatWasWritten) {
  const test::TemporaryFolder folder("view_check");
  write_case(folder);
  std::ofstream(folder / "summary.json") << R"({"unit_names": {"energy": "lbf in"}})";
  const std::string check = "/usr/bin/python3 -B '" PINBALL_SOURCE_DIR "/tests/view/written_check.py' ";
  EXPECT_EQ(std::system((check + folder.path.string()).c_str()), 0);
}

TEST(View, HasItsOwnHelp) {
  const test::Finished view = test::run("view --help");
  EXPECT_EQ(view.status, 0);
  EXPECT_NE(view.text.find("usage: pinball view"), std::string::npos) << view.text;
}

TEST(View, EndsWithStatus2OnBadInput) {
  const test::TemporaryFolder folder("view_bad");
  const auto says = [](const std::string& arguments, const std::string& expected) {
    const test::Finished view = test::run("view " + arguments);
    EXPECT_EQ(view.status, 2) << arguments;
    EXPECT_NE(view.text.find(expected), std::string::npos) << view.text;
  };
  const std::string out = folder.path.string();
  says("", "OUT");
  says(folder / "nowhere", "no such folder");
  says(out, "no fields.pvd; run the scene with --set output.field_interval");
  says(out + " --history", "history.csv: cannot be read");
  write_case(folder);
  says(out + " --field strain", "no field strain in the output; there are: velocity");
  says(out + " --hide roof", "no body roof; there are: rod, plate");
  says(out + " --hide rod --hide plate", "no body is left");
  says(out + " --cut x", "expected a plane such as x=0.5");
  says(out + " --view above", "expected iso, side");
  says(out + " --mirror yy", "expected y for a body cut at y = 0");
  says(out + " --colours jetsam", "no colour map jetsam");
  says(out + " --range 2,1", "LOW < HIGH");
  says(out + " --out picture.xyz", "expected a file that ends in .png");
  says(out + " --animation film.avi", "expected a file that ends in .gif");
  says(out + " --cut z=1e6", "no element is left to draw");
  std::filesystem::remove(folder / "fields_0001.vtu");
  says(out, "fields_0001.vtu: cannot be read");
}

TEST(View, SaysWhichPackageIsMissing) {
  const test::TemporaryFolder folder("view_python");
  ::setenv("PINBALL_PYTHON", (folder / "none").c_str(), 1);
  const test::Finished view = test::run("view " + folder.path.string());
  ::unsetenv("PINBALL_PYTHON");
  EXPECT_EQ(view.status, 2);
  EXPECT_NE(view.text.find("python3-vtk9"), std::string::npos) << view.text;
}

}  // namespace
}  // namespace pinball::view_test
