#include <gmock/gmock.h>
#include <sys/stat.h>

#include <fstream>

#include <solver/formats/mesh_reader.hpp>
#include <solver/mesh/file/input_file.hpp>
#include <solver/scene.hpp>
#include <tests/support/error_of.hpp>
#include <tests/support/folder_case.hpp>

namespace pinball::test::input_file_test {
namespace {

using testing::HasSubstr;

class InputFile : public FolderTest {
 protected:
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
};

TEST_F(InputFile, IsReadAsItIs) {
  const std::string bytes("a\0\r\n\xff", 5);
  std::ofstream(path("some"), std::ios::binary) << bytes;
  EXPECT_EQ(bytes_of_file(path("some")), bytes);
  std::filesystem::create_symlink("some", path("link"));
  EXPECT_EQ(bytes_of_file(path("link")), bytes);
}

TEST_F(InputFile, LargerThanTheMemoryIsRefused) {
  std::ofstream(path("hole")) << 'x';
  std::error_code none;
  std::filesystem::resize_file(path("hole"), 1ULL << 43, none);
  if (none) GTEST_SKIP() << "no file of such a size here";
  EXPECT_THAT(error_of([&] { bytes_of_file(path("hole")); }), HasSubstr("memory can hold"));
}

/// Whoever reads a file that a user names.
TEST_F(InputFile, WhatIsNoFileIsToldByEveryReader) {
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  for (const std::string& name : {path("pipe"), std::string("/dev/zero"), std::string("/dev/null")}) {
    EXPECT_THAT(error_of([&] { read_scene(name); }), HasSubstr("expected a file, got a pipe or a device"));
    for (const MeshFormat format : {MeshFormat::gmsh, MeshFormat::keyword, MeshFormat::exodus, MeshFormat::vtk,
                                    MeshFormat::abaqus, MeshFormat::radioss}) {
      FileMesh mesh;
      mesh.format = format;
      mesh.file = name;
      EXPECT_THAT(error_of([&] { read_mesh_file(mesh, {}); }), HasSubstr("expected a file, got a pipe or a device"));
    }
  }
  EXPECT_THAT(error_of([&] { bytes_of_file(path("none")); }), HasSubstr("none: no such file, or it cannot be read"));
  EXPECT_THAT(error_of([&] { bytes_of_file(path(".")); }), HasSubstr("expected a file, got a folder"));
}

}  // namespace
}  // namespace pinball::test::input_file_test
