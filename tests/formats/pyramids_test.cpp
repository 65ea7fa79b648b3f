#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <set>

#include <solver/base/faces.hpp>
#include <solver/formats/mesh_reader.hpp>
#include <solver/mesh/quality.hpp>
#include <solver/mesh/tetrahedra.hpp>
#include <tests/support/folder_case.hpp>

/// Pyramids and wedges become collapsed hexahedra, in the files of all formats alike.
namespace pinball::test::pyramids_test {
namespace {

/// A pyramid of the nodes 1 to 5, and the wedge 1, 6, 4, 2, 7, 3 on its base.
const std::vector<Point> nodes{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}, {0, 0.5, -1}, {1, 0.5, -1}};

std::string node_lines(const std::string& separator) {
  std::string lines;
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const Point& x = nodes[n];
    lines += fmt::format("{1}{0}{2}{0}{3}{0}{4}\n", separator, n + 1, x[0], x[1], x[2]);
  }
  return lines;
}

/// faces: of the pyramid, the sets that look along -z, -y, x, y and -x; may be none.
struct Form {
  const char* name;
  MeshFormat format;
  const char* ending;
  std::vector<std::string> faces;
  std::function<std::string()> text;
};

std::string abaqus() {
  std::string text = "*NODE\n" + node_lines(", ") + "*ELEMENT, TYPE=C3D5\n1, 1, 2, 3, 4, 5\n" +
                     "*ELEMENT, TYPE=C3D6\n2, 1, 6, 4, 2, 7, 3\n";
  for (int s = 1; s <= 5; ++s) text += fmt::format("*SURFACE, NAME=s{}\n1, S{}\n", s, s);
  return text;
}

std::string keyword() {
  return "*KEYWORD\n*NODE\n" + node_lines(",") +
         "*ELEMENT_SOLID\n1,1\n1,2,3,4,5,5,5,5\n2,1\n1,6,4,4,2,7,3,3\n*SET_SEGMENT\n1\n1,4,3,2\n*SET_SEGMENT\n2\n1,2,"
         "5\n" +
         "*SET_SEGMENT\n3\n2,3,5,5\n*SET_SEGMENT\n4\n3,4,5,5\n*SET_SEGMENT\n5\n4,1,5,5\n*END\n";
}

std::string radioss() {
  const auto ten = [](const std::vector<int>& numbers) {
    std::string line;
    for (const int number : numbers) line += fmt::format("{:>10}", number);
    return line + "\n";
  };
  std::string text =
      "#RADIOSS STARTER\n/BEGIN\ncube\n      2022         0\n                  Mg                  mm" +
      std::string("                   s\n                  Mg                  mm                   s\n") + "/NODE\n";
  for (std::size_t n = 0; n < nodes.size(); ++n)
    text += fmt::format("{:>10}{:>20}{:>20}{:>20}\n", n + 1, nodes[n][0], nodes[n][1], nodes[n][2]);
  return text + "/BRICK/1\n" + ten({1, 1, 2, 3, 4, 5, 5, 5, 5}) + "/PENTA6/1\n" + ten({2, 1, 6, 4, 2, 7, 3}) + "/END\n";
}

std::string gmsh() {
  return fmt::format("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{}\n{}$EndNodes\n$Elements\n2\n", nodes.size(),
                     node_lines(" ")) +
         "1 7 2 1 1 1 2 3 4 5\n2 6 2 1 1 1 6 4 2 7 3\n$EndElements\n";
}

/// Here the base of the pyramid is seen from outside.
std::string vtk() {
  std::string text = "# vtk DataFile Version 3.0\npyramid\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 7 double\n";
  for (const Point& x : nodes) text += fmt::format("{} {} {}\n", x[0], x[1], x[2]);
  return text + "CELLS 2 13\n5 3 2 1 0 4\n6 0 5 3 1 6 2\nCELL_TYPES 2\n14\n13\n";
}

std::string exodus() {
  std::ifstream file(PINBALL_SOURCE_DIR "/tests/data/exodus/pyramid.g", std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

const std::vector<Form> forms{{"Abaqus", MeshFormat::abaqus, ".inp", {"s1", "s2", "s3", "s4", "s5"}, abaqus},
                              {"Keyword", MeshFormat::keyword, ".k", {"1", "2", "3", "4", "5"}, keyword},
                              {"Radioss", MeshFormat::radioss, "_0000.rad", {}, radioss},
                              {"Gmsh", MeshFormat::gmsh, ".msh", {}, gmsh},
                              {"Vtk", MeshFormat::vtk, ".vtk", {}, vtk},
                              {"Exodus", MeshFormat::exodus, ".g", {"5", "1", "2", "3", "4"}, exodus}};

class Pyramids : public FolderTest, public testing::WithParamInterface<Form> {
 protected:
  MeshFile read() const {
    const std::string path = (folder_ / (std::string("pyramid") + GetParam().ending)).string();
    std::ofstream(path, std::ios::binary) << GetParam().text();
    return read_mesh_file({.format = GetParam().format, .file = path, .part = ""}, {});
  }
};
INSTANTIATE_TEST_SUITE_P(Files, Pyramids, testing::ValuesIn(forms), [](const auto& form) { return form.param.name; });

TEST_P(Pyramids, AreCollapsedHexahedraThatFitToOthers) {
  const MeshFile file = read();
  ASSERT_EQ(file.mesh.hexahedra.size(), 2u);
  for (std::size_t e = 0; e < 2; ++e) {
    const Corners8& corners = file.mesh.hexahedra[e];
    EXPECT_EQ(std::set<std::int32_t>(corners.begin(), corners.end()).size(), 5 + e);
    EXPECT_EQ(worked_as(corners) == WorkedShape::wedge, e == 1);
  }
  const MeshQuality quality = measure_quality(file.mesh);
  EXPECT_DOUBLE_EQ(quality.volume, 1.0 / 3 + 1.0 / 2);
  EXPECT_EQ(quality.inverted, 0);
  const auto neighbours = face_neighbours(file.mesh.hexahedra);
  for (int e = 0; e < 2; ++e) {
    EXPECT_EQ(std::ranges::count(neighbours[e], 1 - e), 1);
    EXPECT_EQ(std::ranges::count(neighbours[e], -1), 4);
  }
}

TEST_P(Pyramids, HaveTheirFacesInSets) {
  const MeshFile file = read();
  const Point areas[5] = {{0, 0, -1}, {0, -0.5, 0.25}, {0.5, 0, 0.25}, {0, 0.5, 0.25}, {-0.5, 0, 0.25}};
  for (std::size_t s = 0; s < GetParam().faces.size(); ++s) {
    const FaceSet* set = find_set(file.face_sets, GetParam().faces[s]);
    ASSERT_NE(set, nullptr);
    ASSERT_EQ(set->faces.size(), 1u);
    const std::array<std::int32_t, 4>& face = set->faces[0];
    const auto along = [&](int from, int to, std::size_t k) {
      return file.mesh.nodes[face[to]][k] - file.mesh.nodes[face[from]][k];
    };
    for (std::size_t k = 0; k < 3; ++k) {  // of the diagonals
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      const double area = 0.5 * (along(0, 2, i) * along(1, 3, j) - along(0, 2, j) * along(1, 3, i));
      EXPECT_DOUBLE_EQ(area, areas[s][k]) << GetParam().faces[s] << " " << k;
    }
  }
}

}  // namespace
}  // namespace pinball::test::pyramids_test
