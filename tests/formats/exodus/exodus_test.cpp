#include <gmock/gmock.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <future>
#include <set>
#include <vector>

#include <solver/base/point.hpp>
#include <solver/formats/exodus/exodus_reader.hpp>
#include <solver/mesh/quality.hpp>
#include <solver/mesh/tetrahedra.hpp>
#include <tests/mesh/damaged_files.hpp>
#include <tests/support/scene_text.hpp>

/// tests/data/exodus/two_blocks.cdl says what there is in the two files made of it.
namespace pinball::test::exodus_test {
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
              ElementsAre(HasSubstr("block 15 (skin) has 1 element of type SHELL4 with 4 nodes: left out")));
}

/// Hosts read scenes in several threads; libnetcdf by itself knows of none.
TEST_P(Exodus, IsReadInSeveralThreadsAtOnce) {
  const MeshFile alone = read_exodus(folder + GetParam(), {});
  std::vector<std::future<int>> readers;
  for (int thread = 0; thread < 4; ++thread) {
    readers.push_back(std::async(std::launch::async, [&] {
      int same = 0;
      for (int k = 0; k < 50; ++k) {
        const MeshFile file = read_exodus(folder + GetParam(), {});
        same += file.mesh.nodes == alone.mesh.nodes && file.mesh.hexahedra == alone.mesh.hexahedra;
      }
      return same;
    }));
  }
  for (std::future<int>& reader : readers) EXPECT_EQ(reader.get(), 50);
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

/// The file with another side in the set "roof" in place of side 2 of element 4.
MeshFile with_roof(char element, char side) {
  const auto changed = std::filesystem::temp_directory_path() / ("pinball_exodus_" + std::to_string(::getpid()) + ".g");
  const auto sides = [](char e, char s) { return std::string{0, 0, 0, 4, 0, 0, 0, 2, 0, 0, 0, e, 0, 0, 0, s}; };
  std::ofstream(changed, std::ios::binary)
      << replaced(bytes_of("exodus/two_blocks.g"), sides(4, 2), sides(element, side));
  const MeshFile file = read_exodus(changed.string(), {});
  std::filesystem::remove(changed);
  return file;
}

/// Of element 3, the shell.
TEST(ExodusClassic, SidesOfWhatIsLeftOutAreFacesOfNoHexahedron) {
  const MeshFile file = with_roof(3, 2);
  EXPECT_THAT(file.face_sets.at(1).faces, ElementsAre(ElementsAre(-1, -1, -1, -1)));
  EXPECT_TRUE(find_set(file.node_sets, "roof")->members.empty());
}

/// The area of a face along its outward normal, from its diagonals.
Point area_of(const Mesh& mesh, const std::array<std::int32_t, 4>& face) {
  const auto between = [&](std::size_t from, std::size_t to) {
    return minus(mesh.nodes[static_cast<std::size_t>(face[to])], mesh.nodes[static_cast<std::size_t>(face[from])]);
  };
  Point area = cross(between(0, 2), between(1, 3));
  for (double& component : area) component /= 2;
  return area;
}

/// By the nodes that the format gives each side (SAND92-2137, figures of HEX and WEDGE), as nodes of the element from 1
/// on, and the areas of the sides seen from outside.
struct ExodusSide {
  char element, side;
  std::vector<std::int32_t> nodes;
  Point area;
};

TEST(ExodusClassic, SidesHaveTheNodesOfTheFormatAndLookOut) {
  const std::vector<std::int32_t> cube{1, 2, 3, 4, 5, 6, 7, 8}, wedge{7, 12, 14, 6, 11, 13};
  const ExodusSide sides[] = {
      {1, 1, {1, 2, 6, 5}, {0, -1, 0}}, {1, 2, {2, 3, 7, 6}, {1, 0, 0}},   {1, 3, {3, 4, 8, 7}, {0, 1, 0}},
      {1, 4, {1, 5, 8, 4}, {-1, 0, 0}}, {1, 5, {1, 4, 3, 2}, {0, 0, -1}},  {1, 6, {5, 6, 7, 8}, {0, 0, 1}},
      {4, 1, {1, 2, 5, 4}, {0, 0, -1}}, {4, 2, {2, 3, 6, 5}, {1, 0, 0.5}}, {4, 3, {1, 4, 6, 3}, {-1, 0, 0.5}},
      {4, 4, {1, 3, 2}, {0, 0.5, 0}},   {4, 5, {4, 5, 6}, {0, -0.5, 0}}};
  for (const ExodusSide& given : sides) {
    SCOPED_TRACE(testing::Message() << "element " << int{given.element} << ", side " << int{given.side});
    const MeshFile file = with_roof(given.element, given.side);
    const std::array<std::int32_t, 4> face = file.face_sets.at(1).faces.at(0);
    std::vector<std::int32_t> expected;
    for (const std::int32_t node : given.nodes) {
      expected.push_back((given.element == 1 ? cube : wedge)[static_cast<std::size_t>(node - 1)] - 1);
    }
    EXPECT_EQ(std::set<std::int32_t>(face.begin(), face.end()),
              std::set<std::int32_t>(expected.begin(), expected.end()));
    const Point area = area_of(file.mesh, face);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_DOUBLE_EQ(area[k], given.area[k]);
  }
}

/// tetrahedra.g: the tetrahedron of the nodes 1 to 4, and one on its face 2, 3, 4. Side sets 1 to 4 have its sides.
TEST(ExodusClassic, SidesOfTetrahedraHaveTheNodesOfTheFormatAndLookOut) {
  const MeshFile file = read_exodus(folder + "tetrahedra.g", {});
  ASSERT_EQ(file.mesh.hexahedra.size(), 2u);
  EXPECT_EQ(file.mesh.hexahedra[0], tetrahedron(0, 1, 2, 3));
  EXPECT_NEAR(measure_quality(file.mesh).volume, 1.0 / 6 + 1.0 / 3, 1e-15);
  const std::set<std::int32_t> nodes[4] = {{0, 1, 3}, {1, 2, 3}, {0, 2, 3}, {0, 1, 2}};
  const Point areas[4] = {{0, -0.5, 0}, {0.5, 0.5, 0.5}, {-0.5, 0, 0}, {0, 0, -0.5}};
  for (std::size_t s = 0; s < 4; ++s) {
    const std::array<std::int32_t, 4> face = file.face_sets.at(s).faces.at(0);
    EXPECT_EQ(std::set<std::int32_t>(face.begin(), face.end()), nodes[s]);
    const Point area = area_of(file.mesh, face);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_DOUBLE_EQ(area[k], areas[s][k]) << s;
  }
}

TEST(ExodusClassic, SaysWhatIsWrong) {
  EXPECT_EQ(error_of([] { read_exodus(folder + "none.g", {}); }),
            folder + "none.g: no such file, or it cannot be read");
  EXPECT_THAT(error_of([] { read_exodus(folder + "two_blocks.cdl", {}); }), HasSubstr("not a netCDF file"));
  EXPECT_THAT(error_of([] { read_exodus(folder + "two_blocks.g", {"skin"}); }),
              HasSubstr("block 15 (skin) has 1 element of type SHELL4 with 4 nodes: expected HEX8, WEDGE6, PYRAMID5, "
                        "TET4 or TET10"));
}

}  // namespace
}  // namespace pinball::test::exodus_test
