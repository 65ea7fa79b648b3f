#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <string>

#include <solver/output/field_output.hpp>
#include <solver/output/history.hpp>
#include <tests/support/output_case.hpp>

// bench/picture on a small case; it needs Debian's python3-matplotlib.
namespace pinball {
namespace {

const std::string bench = PINBALL_SOURCE_DIR "/bench";

int run(const std::string& command) {
  const int status = std::system(("PYTHONDONTWRITEBYTECODE=1 " + command).c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

int picture(const std::string& arguments) { return run("'" + bench + "/picture' " + arguments); }

bool is_png(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string head(4, ' ');
  file.read(head.data(), 4);
  return file && head == "\x89PNG";
}

void write_case(const test::TemporaryFolder& folder) {
  FieldWriter fields(folder.path.string(), "fields", {}, "in-lbf-s");
  HistoryWriter history(folder.path.string(), {"rod", "plate"}, "in-lbf-s");
  for (int i = 0; i < 2; ++i) {
    fields.write(test::two_blocks(2.5e-5 * i, 0.1 * i));
    history.write(test::history_row(i, 2.5e-5 * i));
  }
}

TEST(picture, DrawsFieldsAndHistory) {
  const test::TemporaryFolder folder("picture");
  write_case(folder);
  EXPECT_EQ(picture(folder.path.string()), 0);
  EXPECT_TRUE(is_png(folder / "fields.png"));
  EXPECT_TRUE(is_png(folder / "history.png"));
  EXPECT_EQ(picture(folder.path.string() + " --field stress_xy --view iso --mirror --times 2e-5 --out " +
                    (folder / "one.png")),
            0);
  EXPECT_TRUE(is_png(folder / "one.png"));
}

TEST(picture, ReadsWhatWasWritten) {
  const test::TemporaryFolder folder("picture_check");
  write_case(folder);
  EXPECT_EQ(run("/usr/bin/python3 '" PINBALL_SOURCE_DIR "/tests/output/picture_check.py' '" + bench + "' " +
                folder.path.string()),
            0);
}

TEST(picture, EndsWithStatus2OnBadInput) {
  const test::TemporaryFolder folder("picture_bad");
  EXPECT_EQ(picture(folder / "nowhere"), 2);
  EXPECT_EQ(picture(folder.path.string()), 2) << "no fields.pvd";
  write_case(folder);
  EXPECT_EQ(picture(folder.path.string() + " --field strain"), 2);
  std::filesystem::remove(folder / "fields_0001.vtu");
  EXPECT_EQ(picture(folder.path.string()), 2);
}

}  // namespace
}  // namespace pinball
