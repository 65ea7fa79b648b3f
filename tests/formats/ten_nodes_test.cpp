#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <map>
#include <set>

#include <solver/formats/mesh_reader.hpp>
#include <solver/mesh/tetrahedra.hpp>
#include <tests/support/error_of.hpp>
#include <tests/support/folder_case.hpp>

#include "ten_nodes_case.hpp"

/// Tetrahedra of ten nodes become eight of four, in the files of all formats alike.
namespace pinball::test::ten_nodes_test {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;

/// A file with the two tetrahedra, elements 1 and 2 where elements have numbers, a set or surface of the face 1, 2, 3
/// and a set of the nodes 1, 2, 12.
struct Form {
  const char* name;
  MeshFormat format;
  const char* ending;
  std::string faces, nodes;  ///< names of the sets; "": it has none
  std::function<std::string()> text;
};

std::string abaqus() {
  return "*NODE\n" + ten_nodes_lines() + "*ELEMENT, TYPE=C3D10M, ELSET=both\n1, " + joined(ten_nodes_elements[0]) +
         "\n2, " + joined(ten_nodes_elements[1]) +
         "\n*NSET, NSET=some\n1, 2, 12\n*ELSET, ELSET=second\n2\n*SURFACE, NAME=side\n1, S1\n";
}

std::string keyword() {
  return "*KEYWORD\n*NODE\n" + ten_nodes_lines(",") + "*ELEMENT_SOLID\n1,1\n" + joined(keyword_ten_nodes[0], ",") +
         "\n2,1\n" + joined(keyword_ten_nodes[1], ",") +
         "\n*SET_NODE_LIST_TITLE\nsome\n3\n1,2,12\n*SET_SEGMENT_TITLE\nside\n9\n1,3,2,2\n*END\n";
}

std::string radioss() {
  const auto ten = [](const auto& numbers) {
    std::string line;
    for (const int number : numbers) line += fmt::format("{:>10}", number);
    return line + "\n";
  };
  std::string text =
      "#RADIOSS STARTER\n/BEGIN\ncube\n      2022         0\n                  Mg                  mm" +
      std::string("                   s\n                  Mg                  mm                   s\n") + "/NODE\n";
  for (const auto& [number, x] : ten_nodes_nodes)
    text += fmt::format("{:>10}{:>20}{:>20}{:>20}\n", number, x[0], x[1], x[2]);
  text += "/TETRA10/1\n         1\n" + ten(ten_nodes_elements[0]) + "         2\n" + ten(ten_nodes_elements[1]);
  return text + "/GRNOD/NODE/3\nsome\n         1         2        12\n/SURF/SEG/9\nside\n" +
         ten(std::array{0, 1, 3, 2, 2}) + "/END\n";
}

/// The last two nodes change their places.
std::string gmsh() {
  std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n2 9 \"side\"\n3 1 \"both\"\n";
  text += fmt::format("$EndPhysicalNames\n$Nodes\n{}\n{}$EndNodes\n$Elements\n3\n", ten_nodes_nodes.size(),
                      ten_nodes_lines(" "));
  for (int e = 0; e < 2; ++e) {
    std::array<int, 10> nodes = ten_nodes_elements[e];
    std::swap(nodes[8], nodes[9]);
    text += fmt::format("{} 11 2 1 1 {}\n", e + 1, joined(nodes, " "));
  }
  return text + "3 9 2 9 9 1 3 2 13 23 12\n$EndElements\n";
}

/// Points count from 0, and cells have parts: 1, and 9 of the triangle.
std::string vtk() {
  const auto place = [](int number) {
    return std::ranges::find(ten_nodes_nodes, number, &std::pair<int, Point>::first) - ten_nodes_nodes.begin();
  };
  std::string text = "# vtk DataFile Version 3.0\nten nodes\nASCII\nDATASET UNSTRUCTURED_GRID\n";
  text += fmt::format("POINTS {} double\n", ten_nodes_nodes.size());
  for (const auto& [number, x] : ten_nodes_nodes) text += fmt::format("{} {} {}\n", x[0], x[1], x[2]);
  text += "CELLS 3 29\n";
  for (const auto& element : ten_nodes_elements) {
    text += "10";
    for (const int number : element) text += fmt::format(" {}", place(number));
    text += '\n';
  }
  text += "6";
  for (const int number : {1, 3, 2, 13, 23, 12}) text += fmt::format(" {}", place(number));
  return text + "\nCELL_TYPES 3\n24\n24\n22\nCELL_DATA 3\nSCALARS part int 1\nLOOKUP_TABLE default\n1\n1\n9\n";
}

std::string exodus() {
  std::ifstream file(PINBALL_SOURCE_DIR "/tests/data/exodus/ten_nodes.g", std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

const std::vector<Form> forms{{"Abaqus", MeshFormat::abaqus, ".inp", "side", "some", abaqus},
                              {"Keyword", MeshFormat::keyword, ".k", "side", "some", keyword},
                              {"Radioss", MeshFormat::radioss, "_0000.rad", "9", "3", radioss},
                              {"Gmsh", MeshFormat::gmsh, ".msh", "side", "", gmsh},
                              {"Vtk", MeshFormat::vtk, ".vtk", "9", "", vtk},
                              {"Exodus", MeshFormat::exodus, ".g", "side", "some", exodus}};

class TenNodes : public FolderTest, public testing::WithParamInterface<Form> {
 protected:
  MeshFile read() const {
    const std::string path = (folder_ / (std::string("two") + GetParam().ending)).string();
    std::ofstream(path, std::ios::binary) << GetParam().text();
    return read_mesh_file({.format = GetParam().format, .file = path, .part = ""}, {});
  }
};
INSTANTIATE_TEST_SUITE_P(Files, TenNodes, testing::ValuesIn(forms), [](const auto& form) { return form.param.name; });

Point operator-(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Point half_cross(const Point& a, const Point& b) {
  return {(a[1] * b[2] - a[2] * b[1]) / 2, (a[2] * b[0] - a[0] * b[2]) / 2, (a[0] * b[1] - a[1] * b[0]) / 2};
}
double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

TEST_P(TenNodes, BecomeEightThatFillThem) {
  const MeshFile file = read();
  ASSERT_EQ(file.mesh.hexahedra.size(), 16u);
  std::array<double, 2> volume{0, 0};
  std::map<std::set<std::int32_t>, int> faces;
  for (std::size_t e = 0; e < 16; ++e) {
    ASSERT_TRUE(is_tetrahedron(file.mesh.hexahedra[e]));
    const auto& c = file.mesh.hexahedra[e];
    const std::array<std::int32_t, 4> n{c[0], c[2], c[4], c[5]};
    const Point a = file.mesh.nodes[n[0]];
    const double of_this =
        dot(file.mesh.nodes[n[3]] - a, half_cross(file.mesh.nodes[n[1]] - a, file.mesh.nodes[n[2]] - a)) / 3;
    EXPECT_GT(of_this, 0.5 * (e < 8 ? 1.0 / 48 : 1.0 / 24)) << e;
    volume[e / 8] += of_this;
    for (std::size_t i = 0; i < 4; ++i) {
      std::set<std::int32_t> face(n.begin(), n.end());
      face.erase(n[i]);
      ++faces[face];
    }
  }
  EXPECT_DOUBLE_EQ(volume[0], 1.0 / 6);
  EXPECT_DOUBLE_EQ(volume[1], 1.0 / 3);
  const auto count = [&](int elements) {
    return std::ranges::count_if(faces, [&](const auto& face) { return face.second == elements; });
  };
  EXPECT_EQ(count(1), 6 * 4);                 // outside: four of each face of the two
  EXPECT_EQ(count(2), (16 * 4 - 6 * 4) / 2);  // all others fit
}

TEST_P(TenNodes, KeepNumbersSetsAndParts) {
  const MeshFile file = read();
  EXPECT_EQ(file.mesh.nodes.size(), 14u);
  const std::vector<std::int64_t>& ids = file.element_ids;
  ASSERT_EQ(ids.size(), 16u);
  EXPECT_THAT(std::vector(ids.begin(), ids.begin() + 8), Each(ids.front()));
  EXPECT_THAT(std::vector(ids.begin() + 8, ids.end()), Each(ids.front() + 1));
  if (!file.line.empty()) {
    EXPECT_EQ(file.line[7], file.line[0]);
  }
  EXPECT_EQ(file.part.size(), 16u);
  EXPECT_EQ(file.parts.at(file.part[15]).ten_nodes, 2u);
  ASSERT_EQ(file.notes.size(), 1u);
  EXPECT_THAT(file.notes[0], HasSubstr("2 tetrahedra of ten nodes, each as eight of four nodes"));
  if (GetParam().format != MeshFormat::vtk) {
    for (std::size_t n = 0; n < 14; ++n) {
      const auto node = std::ranges::find(ten_nodes_nodes, file.node_ids[n], &std::pair<int, Point>::first);
      ASSERT_NE(node, ten_nodes_nodes.end());
      EXPECT_EQ(file.mesh.nodes[n], node->second);
    }
  }
  if (GetParam().nodes.empty()) return;
  std::set<std::int64_t> some;
  const MeshSet* set = find_set(file.node_sets, GetParam().nodes);
  ASSERT_NE(set, nullptr);
  for (const std::int32_t n : set->members) some.insert(file.node_ids[n]);
  EXPECT_EQ(some, (std::set<std::int64_t>{1, 2, 12}));
}

/// The side looks down, as it does before: 1, 3, 2.
TEST_P(TenNodes, HaveFourFacesForEachOfTheirs) {
  const MeshFile file = read();
  const FaceSet* side = find_set(file.face_sets, GetParam().faces);
  ASSERT_NE(side, nullptr);
  ASSERT_EQ(side->faces.size(), 4u);
  std::set<std::int32_t> nodes;
  for (const auto& face : side->faces) {
    EXPECT_EQ(face[2], face[3]);
    const Point& a = file.mesh.nodes[face[0]];
    const Point area = half_cross(file.mesh.nodes[face[1]] - a, file.mesh.nodes[face[2]] - a);
    EXPECT_EQ(area, (Point{0, 0, -0.125}));
    nodes.insert(face.begin(), face.end());
  }
  EXPECT_EQ(nodes.size(), 6u);
}

class TenNodesOfOneFormat : public FolderTest {};

TEST_F(TenNodesOfOneFormat, HaveSetsOfEight) {
  const std::string path = (folder_ / "two.inp").string();
  std::ofstream(path) << abaqus();
  const MeshFile file = read_mesh_file({.format = MeshFormat::abaqus, .file = path, .part = ""}, {});
  EXPECT_THAT(find_set(file.element_sets, "second")->members, ElementsAre(8, 9, 10, 11, 12, 13, 14, 15));
}

/// A sixth of a cube: two of the ways through its middle are as long, but for rounding.
TEST_F(TenNodesOfOneFormat, AreCutAlikeInAnyUnitsWhereTwoWaysThroughThemAreAsLong) {
  const auto cut = [&](double unit, double angle) {
    std::vector<Point> x{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}};
    for (const auto& [i, j] : {std::pair(0, 1), {1, 2}, {0, 2}, {0, 3}, {1, 3}, {2, 3}})
      x.push_back({(x[i][0] + x[j][0]) / 2, (x[i][1] + x[j][1]) / 2, (x[i][2] + x[j][2]) / 2});
    std::string text = "*NODE\n";
    for (std::size_t n = 0; n < x.size(); ++n) {
      const double cosine = std::cos(angle), sine = std::sin(angle);  // about two axes, one after the other
      const Point about_z{cosine * x[n][0] - sine * x[n][1], sine * x[n][0] + cosine * x[n][1], x[n][2]};
      const double y = cosine * about_z[1] - sine * about_z[2], z = sine * about_z[1] + cosine * about_z[2];
      text += fmt::format("{}, {}, {}, {}\n", n + 1, unit * (about_z[0] + 10), unit * (y + 10), unit * (z + 10));
    }
    const std::string path = (folder_ / "one.inp").string();
    std::ofstream(path) << text << "*ELEMENT, TYPE=C3D10, ELSET=all\n1, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10\n";
    return read_mesh_file({.format = MeshFormat::abaqus, .file = path, .part = ""}, {}).mesh.hexahedra;
  };
  const auto first = cut(1, 0);
  for (int k = 1; k < 20; ++k) {
    EXPECT_EQ(cut(1 + 0.1 * k, 0.4), first) << k;
    EXPECT_EQ(cut(1, 0.3 * k), first) << k;
  }
}

std::set<std::int64_t> numbers_of(const MeshFile& file, const std::string& name) {
  std::set<std::int64_t> numbers;
  const MeshSet* set = find_set(file.node_sets, name);
  if (set == nullptr) return numbers;
  EXPECT_EQ(set->problem, "");
  for (const std::int32_t n : set->members) numbers.insert(file.node_ids[n]);
  return numbers;
}

/// Of elements and parts, and of faces: those on edges, too.
TEST_F(TenNodesOfOneFormat, AreAllInSetsOfNodesOfElements) {
  const std::set<std::int64_t> of_second(ten_nodes_elements[1].begin(), ten_nodes_elements[1].end());
  const auto read = [&](MeshFormat format, const char* name, const std::string& text) {
    const std::string path = (folder_ / name).string();
    std::ofstream(path, std::ios::binary) << text;
    return read_mesh_file({.format = format, .file = path, .part = ""}, {});
  };
  const MeshFile of_abaqus = read(MeshFormat::abaqus, "a.inp", abaqus() + "*NSET, NSET=all, ELSET=second\n");
  EXPECT_EQ(numbers_of(of_abaqus, "all"), of_second);
  std::string parts = keyword();
  const std::size_t at = parts.find("\n2,1\n");
  ASSERT_NE(at, std::string::npos);
  parts.replace(at, 5, "\n2,2\n");
  const std::string boxes = "*DEFINE_BOX\n8,-1,2,-1,2,-1,2\n";
  const MeshFile of_keyword = read(MeshFormat::keyword, "k.k",
                                   parts.replace(parts.find("*END"), 4,
                                                 "*SET_NODE_GENERAL\n4\nPART,2\n*SET_NODE_GENERAL\n5\nALL\nDPART,1,2\n"
                                                 "*SET_SOLID_GENERAL\n6\nBOX,8\n" +
                                                     boxes + "*END"));
  EXPECT_EQ(numbers_of(of_keyword, "4"), of_second);
  EXPECT_TRUE(numbers_of(of_keyword, "5").empty());
  EXPECT_EQ(find_set(of_keyword.element_sets, "6")->members.size(), 16u);
  std::string groups = radioss();
  groups.insert(groups.find("/END"),
                "/GRBRIC/BRIC/5\ng\n         2\n/GRNOD/GRBRIC/6\ng\n         5\n"
                "/SURF/GRBRIC/EXT/7\ns\n         5\n/SURF/SURF/8\ns\n         7\n"
                "/GRNOD/SURF/8\ng\n         8\n/GRNOD/SURF/9\ng\n         9\n");
  const MeshFile of_radioss = read(MeshFormat::radioss, "r_0000.rad", groups);
  EXPECT_EQ(numbers_of(of_radioss, "6"), of_second);
  EXPECT_EQ(numbers_of(of_radioss, "8"), of_second);
  EXPECT_EQ(numbers_of(of_radioss, "9"), (std::set<std::int64_t>{1, 2, 3})) << "of a segment those that it names";
  const MeshFile of_exodus = read(MeshFormat::exodus, "e.g", exodus());
  EXPECT_EQ(numbers_of(of_exodus, "side"), (std::set<std::int64_t>{1, 2, 3, 12, 23, 13}));
}

/// Each format says which node is on which edge in its own order: those of another one are not in the middles.
TEST_F(TenNodesOfOneFormat, AreRefusedInTheOrderOfOtherFormats) {
  const std::string path = (folder_ / "two.msh").string();
  std::string text = gmsh();
  const auto at = text.find(" 34 24\n");
  ASSERT_NE(at, std::string::npos);
  std::ofstream(path) << text.replace(at, 7, " 24 34\n");
  EXPECT_EQ(error_of([&] { read_mesh_file({.format = MeshFormat::gmsh, .file = path, .part = ""}, {}); }),
            path + ":28: element 1 (line 28 of " + path +
                "): node 34 is not near the middle of its edge, from node 2 to 4: expected four corners, then the "
                "nodes of the edges");
}

}  // namespace
}  // namespace pinball::test::ten_nodes_test
