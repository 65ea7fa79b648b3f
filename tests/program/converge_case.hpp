#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include <tests/support/folder_case.hpp>
#include <tests/support/program.hpp>

namespace pinball::test {

using Json = nlohmann::json;

/// The command from outside, with a block of a few elements that meets a wall.
class Converge : public FolderTest {
 protected:
  void SetUp() override {
    FolderTest::SetUp();
    write_scene("type = \"block\", size = [1, 1, 2], elements = [2, 2, 4]");
  }
  void write_scene(const std::string& mesh, const std::string& more = "") const {
    std::ofstream(scene()) << "units = \"g-mm-ms\"\n"
                              "[time]\nend = 4e-3\n"
                              "[[material]]\nname = \"m\"\nmodel = \"elastic\"\ndensity = 1e-3\n"
                              "young_modulus = 1e3\npoisson_ratio = 0.25\n"
                              "[[body]]\nname = \"bar\"\nmaterial = \"m\"\nvelocity = [0, 0, -10]\nmesh = { "
                           << mesh
                           << " }\n"
                              "[[rigid_wall]]\nname = \"wall\"\nnormal = [0, 0, 1]\n"
                              "[[probe]]\nname = \"tail\"\npoint = [0, 0, 2]\nquantities = [\"displacement\"]\n"
                           << more;
  }
  std::string scene() const { return (folder_ / "bar.toml").string(); }
  std::string out() const { return (folder_ / "out").string(); }
  std::string json_file() const { return (folder_ / "table.json").string(); }
  std::string command(const std::string& options) const {
    return fmt::format("converge {} --threads 1 --out {} --json {} {}", scene(), out(), json_file(), options);
  }
  Finished converge(const std::string& options) const { return run(command(options)); }
  Json json() const { return Json::parse(content(json_file())); }
  static Json of(const Json& table, const std::string& name) {
    for (const Json& quantity : table["quantities"]) {
      if (quantity["name"] == name) return quantity;
    }
    return nullptr;
  }

  static std::string hash(const std::string& folder) {
    return Json::parse(content(folder + "/summary.json"))["state_hash"];
  }

  static constexpr const char* coarse = " --quiet --only mesh --meshes 1/2,1,3/2 ";
};

}  // namespace pinball::test
