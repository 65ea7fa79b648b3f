#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include <solver/base/error.hpp>
#include <solver/formats/mesh_reader.hpp>
#include <solver/program/commands.hpp>
#include <tests/support/error_of.hpp>
#include <tests/support/folder_case.hpp>

namespace pinball::info_mesh_test {
namespace {

using testing::HasSubstr;

class InfoMesh : public test::FolderTest {};

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
  EXPECT_THAT(text, HasSubstr(fmt::format("a mesh (gmsh) of {} hexahedra and {} nodes", file.mesh.hexahedra.size(),
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
