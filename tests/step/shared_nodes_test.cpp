#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include <solver/model/body_parts.hpp>
#include <solver/simulation.hpp>
#include <tests/support/cube_text.hpp>
#include <tests/support/folder_case.hpp>

/// What is told of bodies of one file that share nodes.
namespace pinball::test::shared_nodes_test {
namespace {

/// Two cubes side by side, parts 1 and 2, with a common face.
const std::string pair_of_cubes = "*KEYWORD\n*NODE\n" + cube_lines(1) +
                                  "9,2,0,0\n10,2,1,0\n11,2,0,1\n12,2,1,1\n"
                                  "*ELEMENT_SOLID\n1,1,1,2,3,4,5,6,7,8\n2,2,2,9,10,3,6,11,12,7\n*END\n";

class SharedNodes : public FolderTest {
 protected:
  /// A block falls on both cubes; the right one has so many times the density of the left one.
  Scene scene(double density_of_right = 1, const std::string& more = "") const {
    std::ofstream(folder_ / "cubes.k") << pair_of_cubes;
    std::string text = "time.end = 2e-3\ncontact.method = \"pinball\"\n";
    for (const auto& [name, density] : {std::pair("left", 2.7e-3), {"right", 2.7e-3 * density_of_right}}) {
      text += fmt::format("[[material]]\nname = \"{}\"\nmodel = \"elastic\"\ndensity = {}\n", name, density) +
              "young_modulus = 7e4\npoisson_ratio = 0.3\n";
    }
    for (const auto& [name, part] : {std::pair("left", 1), {"right", 2}}) {
      text += fmt::format("[[body]]\nname = \"{0}\"\nmaterial = \"{0}\"\n", name) +
              fmt::format("mesh = {{ type = \"keyword\", file = \"cubes.k\", part = \"{}\" }}\n", part);
    }
    text +=
        "[[body]]\nname = \"hit\"\nmaterial = \"left\"\nvelocity = [0, 0, -10]\nposition = [0, 0, 1]\n"
        "mesh = { type = \"block\", size = [2, 1, 1], elements = [2, 1, 1] }\n";
    return read_scene(SceneSource{folder_ / "scene.toml", text + more, {}});
  }
};

TEST_F(SharedNodes, OfTheForceOfContactEachBodyHasItsPart) {
  Simulation simulation(scene());
  const std::vector<std::string> columns = simulation.history_columns();
  double largest = 0;
  while (simulation.step()) {
    const HistoryRow row = simulation.history_row();
    const auto force = [&](const std::string& body) {
      return row.more[std::ranges::find(columns, body + "_contact_force_z") - columns.begin()];
    };
    largest = std::max(largest, force("hit"));
    EXPECT_NEAR(force("left"), force("right"), 1e-9 * largest) << "at step " << row.step << ": all is symmetric";
    EXPECT_NEAR(force("left") + force("right"), -force("hit"), 1e-9 * largest);
  }
  EXPECT_GT(largest, 100);
}

TEST_F(SharedNodes, PartsAreThoseOfTheMasses) {
  const Model<double> model = build_model<double>(scene(3));
  const std::vector<std::vector<BodyPart>> parts = parts_of_bodies(model, {0, 1, 8});
  ASSERT_EQ(parts.size(), 3U);
  ASSERT_EQ(parts[0].size(), 1U);
  EXPECT_EQ(parts[0][0].share, 1);
  ASSERT_EQ(parts[1].size(), 2U);
  EXPECT_EQ(parts[1][0].body, 0);
  EXPECT_DOUBLE_EQ(parts[1][0].share, 0.25);
  EXPECT_EQ(parts[1][1].body, 1);
  EXPECT_DOUBLE_EQ(parts[1][1].share, 0.75);
  ASSERT_EQ(parts[2].size(), 1U);
  EXPECT_EQ(parts[2][0].body, 1);
}

TEST_F(SharedNodes, AreWatchedByProbesOfEachBody) {
  const std::string probe = "[[probe]]\nname = \"seam\"\npoint = [1, 1, 1]\nbody = ";
  for (const std::string body : {"left", "right"}) {
    const RunSummary summary = Simulation(scene(1, probe + '"' + body + "\"\n")).summary();
    EXPECT_EQ(summary.probes.at(0).number, 6) << body << ": node 7 of the file";
    EXPECT_EQ(summary.probes.at(0).body, body);
  }
}

}  // namespace
}  // namespace pinball::test::shared_nodes_test
