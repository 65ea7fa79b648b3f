#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>
#include <string>

#include <tests/support/scene_fixture.hpp>

/// Scenes with very many tables, very long names and very deep keys.
namespace pinball::scene_size_test {
namespace {

using test::minimal;
using test::SceneTest;
using testing::HasSubstr;

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

class SceneSizeTest : public SceneTest {
 protected:
  std::vector<std::string> many(int count, const std::string& before, const std::string& after) {
    std::vector<std::string> lines = minimal;
    for (int i = 0; i < count; ++i) lines.push_back(before + fmt::format("n{}", i) + after);
    return lines;
  }
  /// How many times longer it takes to read four times as many tables: 4 to 5, or 16 if each is compared with all
  /// others. The least of some: other work on the machine may take part of one.
  double growth(const std::string& before, const std::string& after) {
    const auto seconds = [&](int count) {
      double least = 1e9;
      for (int turn = 0; turn < 2; ++turn) {
        const double start = processor_seconds();
        EXPECT_EQ(error(many(count, before, after)), "no error");
        least = std::min(least, processor_seconds() - start);
      }
      return least;
    };
    double least = 1e9;
    for (int turn = 0; turn < 4 && !(least < 8); ++turn) least = std::min(least, seconds(16000) / seconds(4000));
    return least;
  }
  static std::string dots(int parts) {
    std::string key = "a";
    for (int i = 1; i < parts; ++i) key += ".a";
    return key;
  }
};

TEST_F(SceneSizeTest, TimeToReadGrowsWithTheNumberOfTables) {
  EXPECT_LT(growth("[[probe]]\npoint = [0, 0, 0]\nbody = \"bar\"\nname = \"", "\""), 8);
  EXPECT_LT(growth("[[rigid_wall]]\nnormal = [0, 0, 1]\nname = \"", "\""), 8);
  EXPECT_LT(
      growth("[[material]]\nmodel = \"elastic\"\ndensity = 1\nbulk_modulus = 1\nshear_modulus = 1\nname = \"", "\""),
      8);
  EXPECT_LT(growth("[[body]]\nmaterial = \"copper\"\nmesh = { type = \"block\", size = [1, 1, 1], elements = [1, 1, 1] "
                   "}\nname = \"",
                   "\""),
            8);
}

TEST_F(SceneSizeTest, NamesAreFoundAmongMany) {
  auto lines = many(2000, "[[probe]]\npoint = [0, 0, 0]\nname = \"", "\"");
  lines.insert(lines.end(), {"[[probe]]", "point = [0, 0, 0]", "name = \"n1234\""});
  EXPECT_THAT(error(lines), HasSubstr("probe.n1234.name: expected a name of its own, got \"n1234\" a second time"));
}

TEST_F(SceneSizeTest, LongNamesAreComparedByTheirBeginning) {
  const std::string name(1'000'000, 'b');
  auto lines = minimal;
  lines[11] = "name = \"" + name + "\"";
  lines.insert(lines.end(), {"[[load]]", "force = [0, 0, 1]", "body = \"" + std::string(1'000'000, 'c') + "\""});
  EXPECT_THAT(error(lines), HasSubstr("nearest is"));
  lines = minimal;
  lines.insert(lines.begin(), name + " = 1");
  EXPECT_THAT(error(lines), HasSubstr("unknown key"));
}

TEST_F(SceneSizeTest, KeysOfManyPartsAreRefused) {
  const std::string expected = ": expected a key of at most 32 parts, got more";
  for (const int parts : {33, 50'000, 1'000'000}) {
    EXPECT_EQ(error(with({dots(parts) + " = 1"})), "15:64" + expected);
    EXPECT_EQ(error(with({"[" + dots(parts) + "]"})), "15:65" + expected);
    EXPECT_EQ(error(with({"x = { y = 1, " + dots(parts) + " = 1 }"})), "15:77" + expected);
    EXPECT_THAT(set_error("title={ " + dots(parts) + " = 1 }"), HasSubstr(expected));
  }
  EXPECT_THAT(error(with({dots(32) + " = 1"})), HasSubstr("unknown key"));
  EXPECT_THAT(set_error(dots(100'000) + "=1"), HasSubstr("expected a key of at most 32 parts"));
}

TEST_F(SceneSizeTest, DotsOfTextsAndCommentsAreNoKeys) {
  const std::string many_dots(100, '.');
  EXPECT_EQ(error(with(1, "title = \"" + many_dots + "\\\"" + many_dots + "\"  # " + many_dots)), "no error");
  EXPECT_EQ(error(with(1, "title = '" + many_dots + "'")), "no error");
  EXPECT_EQ(error(with(1, "title = \"\"\"\n" + many_dots + "\"\n" + many_dots + "\"\"\"")), "no error");
  EXPECT_EQ(error(with(1, "title = '''\n" + many_dots + "'\n'''")), "no error");
}

/// As deep as the parser goes, with keys as long as may be.
TEST_F(SceneSizeTest, TablesAreReadToABoundedDepth) {
  const auto nested = [](int depth, int parts) {
    std::string text = "x = ";
    for (int i = 0; i < depth; ++i) text += "{ " + dots(parts) + " = ";
    text += "1";
    for (int i = 0; i < depth; ++i) text += " }";
    return text;
  };
  EXPECT_THAT(error(with(1, nested(250, 1))), HasSubstr("x: unknown key"));
  EXPECT_THAT(error(with(1, nested(8, 32))), HasSubstr("x: unknown key"));
  const std::string expected = "1:551: expected at most 256 tables and arrays, one in another, got more";
  EXPECT_THAT(error(with(1, nested(9, 32))), HasSubstr(expected));
  EXPECT_THAT(error(with(1, nested(250, 32))), HasSubstr(expected));
}

}  // namespace
}  // namespace pinball::scene_size_test
