#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include <tests/program/converge_case.hpp>

namespace pinball::settings_search_test {
namespace {

using test::Converge;
using test::Json;
using testing::Contains;
using testing::ElementsAre;
using testing::Not;

/// Runs that are there take what is written into them, so that a search goes the same way on any machine.
class SearchOfSettings : public Converge {
 protected:
  void set_seconds(const std::map<std::string, double>& seconds) const {
    for (const auto& [run, value] : seconds) {
      const std::string path = out() + "/" + run + "/summary.json";
      Json summary = Json::parse(test::content(path));
      summary["wall_seconds"] = value;
      summary["phase_seconds"]["output"] = 0;
      std::ofstream(path) << summary;
    }
  }
  std::set<std::string> factors() const {
    std::set<std::string> found;
    const Json table = json();
    for (const Json& mesh : table["meshes"]) found.insert(mesh["factor"]);
    return found;
  }
  /// Settings of the runs with other settings than the scene has that the search has made.
  std::vector<std::string> trials() const {
    std::vector<std::string> found;
    const Json table = json();
    for (const Json& point : table["points"]) {
      if (!point["variation"].is_null() && point["factor"] != table["sources_mesh"]) found.push_back(point["settings"]);
    }
    return found;
  }

  static constexpr const char* search = " --quiet --ensemble 1 --meshes 1,2,3 --of bar_velocity_z ";
  static constexpr const char* meshes = " --only mesh --meshes 1,2,3 --of bar_velocity_z --quiet ";
};

/// Mesh 1 errs by 7.5 %, mesh 2 by 2.5 %: with each of the settings mesh 2 should reach 3 %, in as many times the time
/// of mesh 2 as they take of that of mesh 1.
TEST_F(SearchOfSettings, TriesThoseThatAreExpectedToReachTheErrorForLess) {
  ASSERT_EQ(converge(search).status, 0);
  set_seconds({{"mesh_1", 10}, {"mesh_2", 80}, {"mesh_3", 300}});
  set_seconds({{"mesh_1_half_step", 20}, {"mesh_1_float", 5}, {"mesh_1_mixed", 9.5}});
  set_seconds({{"mesh_1_hourglass_viscous", 9.5}, {"mesh_1_hourglass_stiffness", 9.5}});
  ASSERT_EQ(converge(std::string(search) + "--error 3%").status, 0);
  EXPECT_THAT(trials(), ElementsAre("mesh 2, float"));  // which then is the fastest of all

  std::filesystem::remove_all(out() + "/mesh_2_float");
  set_seconds({{"mesh_1_float", 9.2}, {"mesh_1_hourglass_stiffness", 8.8}});
  ASSERT_EQ(converge(std::string(search) + "--error 3%").status, 0);
  EXPECT_THAT(trials(), ElementsAre("mesh 2, hourglass stiffness"));  // the other one would save less than a tenth
}

/// What settings err by themselves says on which mesh they are tried: stiffness, 7.1 % on mesh 1, on mesh 3/2 for 3.8
/// %.
TEST_F(SearchOfSettings, TriesEachOnTheMeshThatItsOwnErrorAsksFor) {
  ASSERT_EQ(converge(search).status, 0);
  set_seconds({{"mesh_1", 10}, {"mesh_2", 80}, {"mesh_3", 300}, {"mesh_1_hourglass_stiffness", 5}});
  set_seconds({{"mesh_1_half_step", 40}, {"mesh_1_float", 40}, {"mesh_1_mixed", 40}, {"mesh_1_hourglass_viscous", 40}});
  ASSERT_EQ(converge(std::string(search) + "--error 3.8%").status, 0);
  EXPECT_THAT(trials(), Contains("mesh 3/2, hourglass stiffness"));
}

/// Mesh 2 errs by 2.5 % and is the first that reaches 4 %: a mesh between 1 and 2 should do. What finer meshes say is
/// known to 2.6 %: for 1.8 % and 1 % one more is needed, as much finer as that has to fall.
TEST_F(SearchOfSettings, LooksForMeshesWhereTheErrorIsExpected) {
  ASSERT_EQ(converge(meshes).status, 0);
  set_seconds({{"mesh_1", 0.01}, {"mesh_2", 0.08}, {"mesh_3", 0.3}});
  ASSERT_EQ(converge(std::string(meshes) + "--error 4%").status, 0);
  EXPECT_THAT(factors(), Contains("3/2"));

  const auto search_anew = [&](const char* error) {
    for (const char* made : {"/mesh_3_2", "/mesh_4", "/mesh_5_2"}) std::filesystem::remove_all(out() + made);
    ASSERT_EQ(converge(std::string(meshes) + "--error " + error).status, 0);
  };
  search_anew("1.8%");  // a mesh at least 1.3 times finer
  EXPECT_THAT(factors(), Contains("4"));
  EXPECT_THAT(factors(), Not(Contains("9/2")));

  search_anew("1%");
  EXPECT_THAT(factors(), Contains("11/2"));
  EXPECT_THAT(factors(), Not(Contains("8")));
}

/// A mesh that comes before the one of the sources takes nothing from these.
TEST_F(SearchOfSettings, LeavesTheSourcesOnTheirMesh) {
  const std::string options = " --quiet --only step --meshes 2,3,4 --of bar_velocity_z ";
  ASSERT_EQ(converge(options).status, 0);
  const Json before = json();
  ASSERT_EQ(before["sources_mesh"], "2");
  ASSERT_EQ(converge(options + "--error 10%").status, 0);
  const Json after = json();
  ASSERT_NE(after["meshes"][0]["factor"], "2") << "no coarser one reaches the error";
  EXPECT_EQ(after["sources_mesh"], "2");
  EXPECT_EQ(of(after, "bar_velocity_z")["moved_by"]["time step"],
            of(before, "bar_velocity_z")["moved_by"]["time step"]);
}

/// So does what all sources come to where the mesh is the only one, and what is kept of it.
TEST_F(SearchOfSettings, LeavesTheErrorBarOnItsMesh) {
  const std::string options = " --quiet --only mesh --meshes 2,3,4 --of bar_velocity_z ";
  ASSERT_EQ(converge(options + "--error 10%").status, 0);
  const Json table = json(), bar = of(table, "bar_velocity_z");
  ASSERT_NE(table["meshes"][0]["factor"], "2") << "no coarser one reaches the error";
  ASSERT_EQ(table["sources_mesh"], "2");
  const double value = bar["values"][1], low = bar["band"][0], high = bar["band"][1];
  ASSERT_EQ(table["meshes"][1]["factor"], "2");
  EXPECT_DOUBLE_EQ(bar["together"], std::max(std::abs(value - low), std::abs(value - high)));
}

}  // namespace
}  // namespace pinball::settings_search_test
