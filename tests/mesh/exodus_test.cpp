#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>

#include <solver/mesh/exodus/exodus_reader.hpp>
#include <solver/mesh/quality.hpp>
#include <tests/support/scene_text.hpp>

#include "damaged_files.hpp"

/// tests/data/exodus/two_blocks.cdl says what there is in the two files made of it.
namespace pinball::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string folder = PINBALL_SOURCE_DIR "/tests/data/exodus/";

class Exodus : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Forms, Exodus, testing::Values("two_blocks.g", "two_blocks_hdf5.g"),
                         [](const auto& file) { return file.param == "two_blocks.g" ? "Classic" : "Hdf5"; });

TEST_P(Exodus, HasTheBlocksAndSets) {
  const MeshFile file = read_exodus(folder + GetParam(), {});
  ASSERT_EQ(file.mesh.hexahedra.size(), 3u);
  EXPECT_THAT(file.mesh.hexahedra[1], ElementsAre(1, 8, 9, 2, 5, 10, 11, 6));
  EXPECT_THAT(file.mesh.hexahedra[2], ElementsAre(6, 11, 13, 13, 5, 10, 12, 12));
  const MeshQuality quality = measure_quality(file.mesh);
  EXPECT_DOUBLE_EQ(quality.volume, 2.5);
  EXPECT_EQ(quality.inverted, 0);
  EXPECT_THAT(file.element_ids, ElementsAre(101, 102, 104));
  EXPECT_EQ(file.node_ids[0], 11);
  EXPECT_THAT(elements_of_part(file, "left"), ElementsAre(0, 1));
  EXPECT_THAT(elements_of_part(file, "20"), ElementsAre(2));
  EXPECT_THAT(find_set(file.node_sets, "bottom")->members, ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(find_set(file.node_sets, "2")->members, ElementsAre(8));
  EXPECT_THAT(find_set(file.node_sets, "ends")->members, ElementsAre(0, 3, 4, 7, 8, 9, 10, 11)) << "of a side set";
  EXPECT_THAT(find_set(file.node_sets, "1")->members, ElementsAre(0, 1, 2, 3)) << "the node set, not the side set";
  EXPECT_THAT(file.face_sets[0].faces, ElementsAre(ElementsAre(0, 4, 7, 3), ElementsAre(8, 9, 11, 10)));
  EXPECT_THAT(file.face_sets[1].faces, ElementsAre(ElementsAre(11, 13, 12, 10)));
  EXPECT_THAT(file.notes,
              ElementsAre(HasSubstr("block 15 (skin) has 1 elements of type SHELL4 with 4 nodes, which are left out")));
}

TEST_P(Exodus, FilesThatAreCutShortAreErrors) {
  const auto cut =
      std::filesystem::temp_directory_path() / ("pinball_exodus_" + std::to_string(::getpid()) + GetParam());
  const bool classic = GetParam() == "two_blocks.g";
  expect_errors_where_cut(bytes_of("exodus/" + GetParam()), classic ? 1 : 97, 0, [&](const std::string& part) {
    std::ofstream(cut, std::ios::binary) << part;
    read_exodus(cut.string(), {});
  });
  std::filesystem::remove(cut);
}

/// Of the classic form alone: what HDF5's own library makes of damaged files is not this program's.
TEST(ExodusClassic, FilesWithOtherBytesAreReadOrErrors) {
  const auto changed = std::filesystem::temp_directory_path() / ("pinball_exodus_" + std::to_string(::getpid()) + ".g");
  const int errors = errors_where_changed(bytes_of("exodus/two_blocks.g"), 4000, [&](const std::string& bytes) {
    std::ofstream(changed, std::ios::binary) << bytes;
    read_exodus(changed.string(), {});
  });
  EXPECT_GT(errors, 1000);
  std::filesystem::remove(changed);
}

/// The side set "roof", element 4 and its side 2, becomes one of element 3, the shell.
TEST(ExodusClassic, SidesOfWhatIsLeftOutAreFacesOfNoHexahedron) {
  const auto changed = std::filesystem::temp_directory_path() / ("pinball_exodus_" + std::to_string(::getpid()) + ".g");
  const auto sides = [](char element) { return std::string{0, 0, 0, 4, 0, 0, 0, 2, 0, 0, 0, element, 0, 0, 0, 2}; };
  std::ofstream(changed, std::ios::binary) << replaced(bytes_of("exodus/two_blocks.g"), sides(4), sides(3));
  const MeshFile file = read_exodus(changed.string(), {});
  EXPECT_THAT(file.face_sets.at(1).faces, ElementsAre(ElementsAre(-1, -1, -1, -1)));
  EXPECT_TRUE(find_set(file.node_sets, "roof")->members.empty());
  std::filesystem::remove(changed);
}

TEST(ExodusClassic, SaysWhatIsWrong) {
  EXPECT_EQ(error_of([] { read_exodus(folder + "none.g", {}); }),
            folder + "none.g: no such file, or it cannot be read");
  EXPECT_THAT(error_of([] { read_exodus(folder + "two_blocks.cdl", {}); }), HasSubstr("not a netCDF file"));
  EXPECT_THAT(error_of([] { read_exodus(folder + "two_blocks.g", {"skin"}); }),
              HasSubstr("block 15 (skin) has 1 elements of type SHELL4 with 4 nodes: expected HEX8 or WEDGE6"));
}

}  // namespace
}  // namespace pinball::test
