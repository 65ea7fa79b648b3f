#include <gmock/gmock.h>

#include <sstream>

#include <solver/formats/vtk/vtk_reader.hpp>
#include <solver/mesh/quality.hpp>
#include <tests/mesh/damaged_files.hpp>
#include <tests/support/scene_text.hpp>

/// tests/data/vtk: two cubes, parts 3 of the array "material", joined at x = 1, and a wedge on the second, part 4; a
/// quadrangle at x = 0, 8. The array "chosen" has the first cube and the wedge, "held" points of 1 and 2.
namespace pinball::test::vtk_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

MeshFile read(const std::string& bytes, const std::string& array = "", const std::vector<std::string>& parts = {}) {
  return parse_vtk(bytes, "a.vtk", array, parts);
}
std::string reading_error(const std::string& bytes, const std::string& array = "",
                          const std::vector<std::string>& parts = {}) {
  return error_of([&] { read(bytes, array, parts); });
}
/// With one place of a file that is text replaced.
auto reading_error_of(const std::string& name) {
  return [text = bytes_of("vtk/" + name)](const std::string& what, const std::string& instead,
                                          const std::vector<std::string>& parts = {}) {
    return reading_error(replaced(text, what, instead), "", parts);
  };
}

class Vtk : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Files, Vtk,
                         testing::Values("ascii.vtk", "binary.vtk", "ascii_51.vtk", "binary_51.vtk", "ascii.vtu",
                                         "inline.vtu", "inline_64.vtu", "inline_zlib.vtu", "raw.vtu", "raw_zlib.vtu",
                                         "base64.vtu", "base64_zlib.vtu"),
                         [](const auto& file) {
                           std::string name = file.param;
                           std::replace(name.begin(), name.end(), '.', '_');
                           return name;
                         });

TEST_P(Vtk, HasTheMeshPartsAndSets) {
  const MeshFile file = read(bytes_of("vtk/grid_" + GetParam()));
  ASSERT_EQ(file.mesh.hexahedra.size(), 3u);
  EXPECT_EQ(file.mesh.nodes.size(), 14u);
  EXPECT_THAT(file.mesh.hexahedra[0], ElementsAre(0, 1, 3, 2, 4, 5, 7, 6)) << "a voxel";
  EXPECT_THAT(file.mesh.hexahedra[1], ElementsAre(1, 8, 9, 3, 5, 10, 11, 7));
  EXPECT_EQ(file.mesh.nodes[12], (Point{1.5, 0, 2}));
  const MeshQuality quality = measure_quality(file.mesh);
  EXPECT_DOUBLE_EQ(quality.volume, 2.5);
  EXPECT_EQ(quality.inverted, 0);
  EXPECT_THAT(file.element_ids, ElementsAre(0, 2, 3));
  EXPECT_THAT(elements_of_part(file, "3"), ElementsAre(0, 1));
  EXPECT_THAT(elements_of_part(file, "4"), ElementsAre(2));
  EXPECT_THAT(elements_of_part(file, "chosen"), ElementsAre(0, 2));
  EXPECT_THAT(find_set(file.node_sets, "held:1")->members, ElementsAre(0, 2, 4, 6));
  EXPECT_THAT(find_set(file.node_sets, "held:2")->members, ElementsAre(12, 13));
  EXPECT_THAT(find_set(file.node_sets, "8")->members, ElementsAre(0, 2, 4, 6));
  EXPECT_THAT(file.face_sets[0].faces[0], ElementsAre(0, 4, 6, 2));
}

TEST_P(Vtk, PartsAreNumberedByTheArrayThatIsNamed) {
  const std::string bytes = bytes_of("vtk/grid_" + GetParam());
  const MeshFile file = read(bytes, "chosen");
  EXPECT_THAT(elements_of_part(file, "1"), ElementsAre(0, 2));
  EXPECT_THAT(elements_of_part(file, "0"), ElementsAre(1));
  EXPECT_THAT(elements_of_part(file, "material:4"), ElementsAre(2));
  EXPECT_EQ(reading_error(bytes, "chose"),
            "a.vtk: no array of integers of the cells is named \"chose\": nearest is \"chosen\"");
}

TEST_P(Vtk, FilesThatAreCutShortAreErrors) {
  const std::string bytes = bytes_of("vtk/grid_" + GetParam());
  // What comes last is the end of the XML, or an array of a legacy file that is then left out.
  const std::size_t spare = GetParam().ends_with("vtk") ? 300 : 40;
  expect_errors_where_cut(bytes, 1, spare, [](const std::string& part) { read(part); });
}

TEST_P(Vtk, FilesWithOtherBytesAreReadOrErrors) {
  EXPECT_GT(
      errors_where_changed(bytes_of("vtk/grid_" + GetParam()), 4000, [](const std::string& bytes) { read(bytes); }),
      500);
}

/// None of them 0, which is what a number has that was not read.
TEST(VtkLegacy, EveryCoordinateOfEveryPointIsRead) {
  const std::string text = bytes_of("vtk/grid_ascii.vtk");
  const std::size_t begin = text.find("\n0 0 0 1 0 0") + 1, end = text.find("CELLS 4");
  std::istringstream given(text.substr(begin, end - begin));
  std::string moved;
  std::vector<Point> expected(14);
  for (Point& point : expected) {
    for (std::size_t k = 0; k < 3; ++k) {
      given >> point[k];
      point[k] += 10.0 + static_cast<double>(k);
      moved += std::to_string(point[k]) + ' ';
    }
  }
  EXPECT_EQ(read(text.substr(0, begin) + moved + '\n' + text.substr(end)).mesh.nodes, expected);
}

TEST(VtkLegacy, NamesTheLineOfWhatIsWrong) {
  const auto error = reading_error_of("grid_ascii.vtk");
  EXPECT_EQ(error("DATASET UNSTRUCTURED_GRID", "DATASET POLYDATA"),
            "a.vtk:4: expected UNSTRUCTURED_GRID, got \"POLYDATA\"");
  EXPECT_EQ(error("POINTS 14", "POINTS -14"), "a.vtk:5: expected the number of points, got \"-14\"");
  EXPECT_EQ(error("POINTS 14", "POINTS 200000000"),
            "a.vtk:5: expected as many numbers (a coordinate of a point) that the rest of the file can hold, got "
            "\"600000000\"");
  EXPECT_EQ(error("1 1 0 0 0 1 1 0 1", "1 1 0 0 nan 1 1 0 1"),
            "a.vtk:7: expected a coordinate of a point, got \"nan\"");
  EXPECT_EQ(error("6 5 10 12", "6 5 10 14"), "a.vtk: cell 3: expected points from 0 to 13, got 14");
  EXPECT_EQ(error("\n12\n13\n", "\n12\n25\n"),
            "a.vtk: cell 3: expected types of hexahedra (12, 11), wedges (13), pyramids (14) or tetrahedra (10, 24), "
            "got quadratic hexahedra (type 25)");
  EXPECT_EQ(error("\n12\n13\n", "\n12\n25\n", {"3"}), "no error") << "not of that part";
  EXPECT_EQ(error("CELL_DATA 4", "CELL_DATA 5"), "a.vtk:23: expected data of 4 cells, got \"5\"");
}

TEST(VtkXml, NamesTheLineOfWhatIsWrong) {
  const auto error = reading_error_of("grid_ascii.vtu");
  EXPECT_EQ(error("type=\"UnstructuredGrid\"", "type=\"PolyData\""),
            "a.vtk:2: expected type UnstructuredGrid, got \"PolyData\"");
  EXPECT_EQ(error("LittleEndian", "BigEndian"),
            "a.vtk:2: expected numbers in the byte order of this machine, got BigEndian");
  EXPECT_EQ(error("<Cells>", "<Cell>"), "a.vtk:56: not well-formed XML: Start-end tags mismatch");
  EXPECT_THAT(error("header_type=\"UInt32\"", "compressor=\"vtkLZ4DataCompressor\""),
              HasSubstr("expected no compressor, or vtkZLibDataCompressor, got vtkLZ4DataCompressor"));
  EXPECT_EQ(error("NumberOfPoints=\"14\"", "NumberOfPoints=\"15\""),
            "a.vtk:24: array Points: expected 45 numbers, number 42 is none, or out of range");
  EXPECT_THAT(error("NumberOfCells=\"4\"", "NumberOfCells=\"99999999\""),
              HasSubstr("array offsets: expected 99999999 numbers, got no more than"));
  EXPECT_THAT(error("3 8 3 4", "3 8 3"), HasSubstr(":13: array material: expected 4 numbers"));
}

TEST(VtkXml, PiecesAreOneMesh) {
  const std::string text = bytes_of("vtk/grid_ascii.vtu");
  const std::size_t begin = text.find("    <Piece"), end = text.find("  </UnstructuredGrid>");
  const MeshFile file = read(text.substr(0, end) + text.substr(begin, end - begin) + text.substr(end));
  EXPECT_EQ(file.mesh.hexahedra.size(), 6u);
  EXPECT_EQ(file.mesh.nodes.size(), 28u);
  EXPECT_DOUBLE_EQ(measure_quality(file.mesh).volume, 5.0);
  EXPECT_THAT(elements_of_part(file, "4"), ElementsAre(2, 5));
}

TEST(VtkXml, WhatIsNoFileOfVtkIsSaid) {
  EXPECT_EQ(reading_error("solid a\n"), "a.vtk:1: expected \"# vtk DataFile\" or <VTKFile ...>");
  EXPECT_EQ(reading_error(""), "a.vtk:1: expected \"# vtk DataFile\" or <VTKFile ...>");
}

}  // namespace
}  // namespace pinball::test::vtk_test
