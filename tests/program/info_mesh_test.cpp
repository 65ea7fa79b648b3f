#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <string>

#include <solver/base/error.hpp>
#include <solver/formats/mesh_reader.hpp>
#include <solver/program/commands.hpp>
#include <tests/support/error_of.hpp>
#include <tests/support/folder_case.hpp>

namespace pinball::info_mesh_test {
namespace {

using testing::HasSubstr;

class InfoMesh : public test::FolderTest {
 protected:
  static std::string info(const std::string& path) {
    InfoOptions options;
    options.scene = path;
    testing::internal::CaptureStdout();
    info_command(options);
    return testing::internal::GetCapturedStdout();
  }
  std::string written(const std::string& name, const std::string& text) {
    const std::string path = folder_ / name;
    std::ofstream(path) << text;
    return path;
  }
};

/// A cube, part "case", and a tetrahedron, part "foam".
const std::string cube_and_tetrahedron =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n3 1 \"case\"\n3 2 \"foam\"\n$EndPhysicalNames\n"
    "$Nodes\n12\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 0 0 1\n6 1 0 1\n7 1 1 1\n8 0 1 1\n"
    "9 4 0 0\n10 5 0 0\n11 4 1 0\n12 4 0 1\n$EndNodes\n"
    "$Elements\n2\n1 5 2 1 1 1 2 3 4 5 6 7 8\n2 4 2 2 2 9 10 11 12\n$EndElements\n";

TEST_F(InfoMesh, ListsWhatAMeshFileHolds) {
  InfoOptions options;
  options.scene = PINBALL_SOURCE_DIR "/data/scenes/crushed_tube.msh";
  testing::internal::CaptureStdout();
  info_command(options);
  const std::string text = testing::internal::GetCapturedStdout();
  const MeshFile file = read_mesh_file(
      [&] {
        FileMesh settings;
        settings.file = options.scene;
        return settings;
      }(),
      {});
  EXPECT_THAT(text, HasSubstr(fmt::format("a mesh (gmsh) of {} elements and {} nodes", file.mesh.hexahedra.size(),
                                          file.mesh.nodes.size())));
  for (const MeshGroup& group : groups_of(file)) EXPECT_THAT(text, HasSubstr(group.name)) << text;
}

TEST_F(InfoMesh, ListsADeckThatIsAMeshAlone) {
  InfoOptions options;
  options.scene = PINBALL_SOURCE_DIR "/data/decks/parts/solids.k";
  testing::internal::CaptureStdout();
  info_command(options);
  EXPECT_THAT(testing::internal::GetCapturedStdout(), HasSubstr("a mesh (keyword) of "));
}

TEST_F(InfoMesh, SaysWhatElementsAFileHasAndWhatIsOfNoBody) {
  const std::string mesh = written("two.msh", cube_and_tetrahedron);
  EXPECT_THAT(info(mesh), HasSubstr("a mesh (gmsh) of 2 elements (1 of them tetrahedra) and 12 nodes"));
  const auto scene = [&](const std::string& bodies) {
    return info(written("two.toml",
                        "[time]\nend = 0.001\n[[material]]\nname = \"m\"\nmodel = \"elastic\"\ndensity = 1\n"
                        "young_modulus = 100\npoisson_ratio = 0.3\n" +
                            bodies));
  };
  const auto body = [](const std::string& name) {
    return "[[body]]\nname = \"" + name +
           "\"\nmaterial = \"m\"\nmesh = { type = \"file\", file = \"two.msh\", part = \"" + name + "\" }\n";
  };
  EXPECT_THAT(scene(body("case")), HasSubstr("no body has parts foam (2)\n"));
  EXPECT_THAT(scene(body("case") + body("foam")), testing::Not(HasSubstr("no body has")));
}

/// A deck of the program's own, by its name: what is wrong is not that the name is no file here.
TEST_F(InfoMesh, ADeckThatCannotBeRunSaysWhy) {
  InfoOptions options;
  options.scene = "cases.k";
  options.chosen_case = 99;
  EXPECT_THAT(test::error_of([&] { info_command(options); }), HasSubstr("--case 99: it has "));
}

TEST_F(InfoMesh, NoFormatsOfOthersAreTakenForScenes) {
  for (const char* ending : {"bdf", "cdb", "unv", "med", "gz"}) {
    const std::string path = folder_ / (std::string("some.") + ending);
    std::FILE* file = std::fopen(path.c_str(), "wb");
    std::fputs("SOME BULK\n", file);
    std::fclose(file);
    InfoOptions options;
    options.scene = path;
    try {
      info_command(options);
      ADD_FAILURE() << path;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(),
                  HasSubstr("expected a scene (.toml), an LS-DYNA keyword file (.k, .key, .dyn), Abaqus"));
      EXPECT_THAT(error.what(), HasSubstr(".msh, .k, .key, .dyn, .g, .e, .exo, .ex2, .gen, .vtk, .vtu, .inp, .rad"));
    }
  }
}

}  // namespace
}  // namespace pinball::info_mesh_test
