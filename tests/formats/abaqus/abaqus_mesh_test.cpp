#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include <solver/base/error.hpp>
#include <solver/formats/abaqus/mesh/abaqus_mesh.hpp>
#include <solver/mesh/quality.hpp>

namespace pinball::test::abaqus_mesh_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Two cubes above each other.
const std::string nodes = R"(*NODE, NSET=ALL
1, 0., 0., 0.
2, 1., 0., 0.
3, 1., 1., 0.
4, 0., 1., 0.
11, 0., 0., 1.
12, 1., 0., 1.
13, 1., 1., 1.
14, 0., 1., 1.
21, 0., 0., 2.
22, 1., 0., 2.
23, 1., 1., 2.
24, 0., 1., 2.
)";
const std::string cubes =
    "*ELEMENT, TYPE=C3D8R, ELSET=Cubes\n7, 1, 2, 3, 4, 11, 12, 13, 14\n8, 11, 12, 13, 14,\n 21, 22, 23, 24\n";

MeshFile read(const std::string& text) { return abaqus_mesh(parse_abaqus_deck(text, "a.inp")).file; }

std::string error_of(const std::string& text) {
  try {
    read(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

std::vector<std::int64_t> ids(const MeshFile& file, const std::string& set) {
  const MeshSet* found = find_set(file.node_sets, set);
  std::vector<std::int64_t> numbers;
  if (found == nullptr) return {-1};
  if (!found->problem.empty()) return {-2};
  for (const std::int32_t n : found->members) numbers.push_back(file.node_ids[n]);
  return numbers;
}

TEST(AbaqusMesh, ReadsNodesAndElements) {
  const MeshFile file = read(nodes + cubes);
  EXPECT_THAT(file.element_ids, ElementsAre(7, 8));
  EXPECT_THAT(file.mesh.hexahedra[1], ElementsAre(4, 5, 6, 7, 8, 9, 10, 11));
  EXPECT_THAT(file.line, ElementsAre(15, 16));
  EXPECT_DOUBLE_EQ(measure_quality(file.mesh).volume, 2.0);
  EXPECT_EQ(ids(file, "ALL").size(), 12u);
  EXPECT_THAT(elements_of_part(file, "Cubes"), ElementsAre(0, 1));
  EXPECT_THAT(elements_of_part(file, ""), ElementsAre(0, 1));
}

TEST(AbaqusMesh, KeywordsMayComeInAnyOrder) {
  const std::string set = "*NSET, NSET=low, ELSET=first\n*ELSET, ELSET=first\n7\n";
  EXPECT_EQ(read(set + cubes + nodes).mesh.hexahedra, read(nodes + cubes).mesh.hexahedra);
  EXPECT_THAT(ids(read(set + cubes + nodes), "low"), ElementsAre(1, 2, 3, 4, 11, 12, 13, 14));
}

TEST(AbaqusMesh, AWedgeIsACollapsedHexahedron) {
  const MeshFile wedge = read(nodes + "*ELEMENT, TYPE=C3D6\n1, 1, 2, 3, 11, 12, 13\n*SURFACE, NAME=s\n1, S1\n1, S5\n");
  EXPECT_DOUBLE_EQ(measure_quality(wedge.mesh).volume, 0.5);
  ASSERT_EQ(wedge.face_sets.size(), 1u);
  EXPECT_EQ(wedge.face_sets[0].problem, "");
  auto triangle = wedge.face_sets[0].faces.at(0);
  EXPECT_EQ(triangle[2], triangle[3]);
  auto side = wedge.face_sets[0].faces.at(1);
  std::sort(side.begin(), side.end());
  EXPECT_THAT(side, ElementsAre(0, 2, 4, 6)) << "between nodes 3, 6, 4 and 1 of the element";
}

/// Faces of C3D4: S1 = 1-2-3, S2 = 1-4-2, S3 = 2-4-3, S4 = 3-4-1.
TEST(AbaqusMesh, ATetrahedronHasFourFaces) {
  const std::string text = nodes + "*ELEMENT, TYPE=C3D4\n1, 1, 2, 4, 11\n";
  const MeshFile file = read(text + "*SURFACE, NAME=s\n1, S1\n1, S2\n1, S3\n1, S4\n");
  EXPECT_DOUBLE_EQ(measure_quality(file.mesh).volume, 1.0 / 6);
  const std::set<std::int32_t> expected[4] = {{0, 1, 3}, {0, 1, 4}, {1, 3, 4}, {0, 3, 4}};
  for (std::size_t s = 0; s < 4; ++s) {
    const auto face = file.face_sets.at(0).faces.at(s);
    EXPECT_EQ(std::set<std::int32_t>(face.begin(), face.end()), expected[s]);
    EXPECT_EQ(face[2], face[3]);
  }
  EXPECT_THAT(read(text + "*SURFACE, NAME=s\n1, S5\n").face_sets.at(0).problem, HasSubstr("got \"S5\""));
}

TEST(AbaqusMesh, ReadsSets) {
  const MeshFile file = read(nodes + cubes +
                             "*NSET, NSET=a, GENERATE\n1, 4, 1\n21, 24, 3\n*NSET, NSET=b, UNSORTED\n 14, 3, 13,\n A, \n"
                             "*nset, nset=A, internal\n12\n*ELSET, ELSET=top\n8\n*NSET, ELSET=top, NSET=c\n");
  EXPECT_THAT(ids(file, "a"), ElementsAre(1, 2, 3, 4, 12, 21, 24)) << "a set may have several keywords";
  EXPECT_THAT(ids(file, "b"), ElementsAre(1, 2, 3, 4, 12, 13, 14, 21, 24));
  EXPECT_THAT(ids(file, "c"), ElementsAre(11, 12, 13, 14, 21, 22, 23, 24));
}

TEST(AbaqusMesh, SetsInQuotesHaveACase) {
  const MeshFile file = read(nodes + cubes +
                             "*NSET, NSET=\"Top\"\n21\n*NSET, NSET=Top\n22\n*NSET, NSET=\"TOP\"\n23\n"
                             "*NSET, NSET=both\n\"Top\", top\n*NSET, NSET=\"all\"\n1\n");
  EXPECT_THAT(ids(file, "Top"), ElementsAre(21));
  EXPECT_THAT(ids(file, "TOP"), ElementsAre(22, 23));
  EXPECT_THAT(ids(file, "both"), ElementsAre(21, 22, 23));
  EXPECT_THAT(ids(file, "all"), ElementsAre(1)) << "and ALL is another one, of all nodes";
  EXPECT_EQ(ids(file, "ALL").size(), 12u);
}

TEST(AbaqusMesh, SetsThatNothingUsesMayBeWrong) {
  const MeshFile file = read(nodes + cubes + "*NSET, NSET=a\n99\n*NSET, NSET=b\nnothing\n*NSET, NSET=c\nc\n");
  EXPECT_THAT(find_set(file.node_sets, "a")->problem, HasSubstr("a.inp:19: node 99 is not there"));
  EXPECT_THAT(find_set(file.node_sets, "b")->problem, HasSubstr("a.inp:21: there is no set of nodes nothing"));
  EXPECT_THAT(find_set(file.node_sets, "c")->problem, HasSubstr("the set c has itself as a member"));
}

/// The faces as the manual numbers them, by their nodes 1 to 8.
TEST(AbaqusMesh, FacesAreThoseOfAbaqus) {
  static const int corners[6][4] = {{1, 2, 3, 4}, {5, 8, 7, 6}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 8, 4}, {4, 8, 5, 1}};
  const std::array<std::int32_t, 8> hexahedron{1, 2, 3, 4, 5, 6, 7, 8};
  for (int s = 1; s <= 6; ++s) {
    auto found = corners_of_face(hexahedron, abaqus_face(hexahedron, SolidShape::hexahedron, s));
    std::array<std::int32_t, 4> expected{};
    std::copy_n(corners[s - 1], 4, expected.begin());
    std::sort(found.begin(), found.end());
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(found, expected) << s;
  }
  EXPECT_EQ(abaqus_face(hexahedron, SolidShape::hexahedron, 7), -1);
}

TEST(AbaqusMesh, ASurfaceIsOfFacesOrOfNodes) {
  const MeshFile file =
      read(nodes + cubes +
           "*SURFACE, NAME=top\ncubes, S2\n*SURFACE, NAME=skin, TYPE=ELEMENT\nCUBES,\n*SURFACE, NAME=all\n,\n" +
           "*SURFACE, NAME=n, TYPE=NODE\nset, 1.\n*NSET, NSET=set\n3, 4\n");
  ASSERT_EQ(file.face_sets.size(), 3u);
  EXPECT_EQ(file.face_sets[0].faces.size(), 2u) << "face S2 of both";
  EXPECT_THAT(file.face_sets[0].faces[1], ElementsAre(8, 9, 10, 11)) << "counterclockwise from outside";
  EXPECT_EQ(file.face_sets[1].faces.size(), 10u) << "without the two between the cubes";
  EXPECT_EQ(file.face_sets[2].faces.size(), 10u);
  EXPECT_THAT(ids(file, "n"), ElementsAre(3, 4));
}

const std::string part = "*PART, NAME=Block\n" + nodes + cubes +
                         "*NSET, NSET=base, GENERATE\n1, 4, 1\n*ELSET, ELSET=low\n7\n*ELSET, ELSET=high\n8\n"
                         "*SOLID SECTION, ELSET=low, MATERIAL=a\n*SOLID SECTION, ELSET=high, MATERIAL=b\n*END PART\n";

TEST(AbaqusMesh, InstancesAreMovedAndThenTurned) {
  const MeshFile file =
      read(part +
           "*ASSEMBLY, NAME=A\n*INSTANCE, NAME=One, PART=block\n*END INSTANCE\n"
           "*INSTANCE, NAME=Two, PART=BLOCK\n 10., 0., 0.\n 10., 0., 0., 10., 0., 1., 90.\n*END INSTANCE\n"
           "*NODE\n1, 5., 5., 5.\n*NSET, NSET=tips, INSTANCE=Two\n 22,\n*NSET, NSET=both\nOne.base, Two.21\n"
           "*NSET, NSET=ref\n1\n*END ASSEMBLY\n");
  EXPECT_EQ(file.mesh.hexahedra.size(), 4u);
  EXPECT_EQ(file.node_ids[0], 1);
  EXPECT_EQ(file.node_ids[12], 101) << "numbers of the second one begin behind 100";
  EXPECT_EQ(file.node_ids[24], 201);
  const Point moved = file.mesh.nodes[13];  // (1, 0, 0) goes to (11, 0, 0), and turns about the vertical axis in x = 10
  EXPECT_NEAR(moved[0], 10.0, 1e-14);
  EXPECT_NEAR(moved[1], 1.0, 1e-14);
  EXPECT_THAT(ids(file, "tips"), ElementsAre(122));
  EXPECT_THAT(ids(file, "both"), ElementsAre(1, 2, 3, 4, 121));
  EXPECT_THAT(ids(file, "ref"), ElementsAre(201));
  EXPECT_THAT(ids(file, "Two.base"), ElementsAre(101, 102, 103, 104));
  EXPECT_THAT(ids(file, "base"), ElementsAre(-1)) << "two instances have it";
  EXPECT_THAT(elements_of_part(file, "Two.high"), ElementsAre(3));
  EXPECT_EQ(file.parts[file.part[3]].name, "Two.high");
}

TEST(AbaqusMesh, NamesThatAreAloneNeedNoInstance) {
  const MeshFile file =
      read(part + "*ASSEMBLY, NAME=A\n*INSTANCE, NAME=One, PART=block\n*END INSTANCE\n*END ASSEMBLY\n");
  EXPECT_EQ(ids(file, "base"), ids(file, "One.base"));
  EXPECT_EQ(file.element_ids[1], 8);
  EXPECT_EQ(read(part).parts[0].name, "Block.low") << "a part without an assembly is an instance of itself";
}

TEST(AbaqusMesh, WhatIsWrongIsToldWithItsPlace) {
  EXPECT_EQ(error_of(nodes + "*ELEMENT, TYPE=C3D8\n1, 1, 2, 3, 4, 11, 12, 13, 99\n"),
            "a.inp:15: element 1 has node 99, which is not there");
  EXPECT_EQ(error_of(nodes + "*ELEMENT, TYPE=C3D8\n1, 1, 2, 3\n"), "a.inp:15: element 1: expected 8 nodes, got 3");
  EXPECT_EQ(error_of(nodes + "*ELEMENT, TYPE=C3D8\n, 1, 2, 3\n"),
            "a.inp:15: expected the number of an element and its 8 nodes");
  EXPECT_EQ(error_of(nodes + "*ELEMENT, TYPE=C3D6\n1, 1, 2, 3, 4, 11, 12, 13, 14\n"),
            "a.inp:15: element 1: expected 6 nodes, got more");
  EXPECT_EQ(error_of(nodes + "*ELEMENT, TYPE=C3D10\n1, 1, 2, 3\n"), "a.inp:15: element 1: expected 10 nodes, got 3");
  EXPECT_EQ(error_of(nodes + "*ELEMENT, TYPE=C3D27R\n1, 1, 2, 3\n"),
            "a.inp:14: *ELEMENT, TYPE=C3D27R is not read: expected C3D8, C3D20, C3D6, C3D5, C3D4, C3D10, R3D4, R3D3, "
            "MASS, ROTARYI");
  EXPECT_EQ(error_of(nodes + "*NODE\n3, 0.\n"), "a.inp:15: node 3 is given twice, first in a.inp:4");
  EXPECT_EQ(error_of(nodes + cubes + "*ELEMENT, TYPE=C3D8\n7, 1, 2, 3, 4, 11, 12, 13, 14\n"),
            "a.inp:19: element 7 is given twice, first in a.inp:15");
  EXPECT_EQ(error_of(nodes + "*NGEN\n1, 4, 1\n"), "a.inp:14: *NGEN is not read");
  EXPECT_EQ(error_of("*NODE\n1, x\n"), "a.inp:2: x (field 2): expected a number, got \"x\"");
  EXPECT_EQ(error_of(nodes + cubes + "*SOLID SECTION, ELSET=none\n"), "a.inp:18: there is no set of elements none");
  EXPECT_EQ(error_of(part + "*ASSEMBLY\n*INSTANCE, NAME=i, PART=q\n*END INSTANCE\n*END ASSEMBLY\n"),
            "a.inp:29: *INSTANCE: there is no *PART q");
}

TEST(AbaqusMesh, SetsOfSetsMayBeAnyDepth) {
  constexpr int depth = 20000;
  for (const bool forward : {true, false}) {  // each set before, or behind, the one that it is made of
    std::string sets = "*NSET, NSET=s0\n1, 2\n", inverse;
    for (int i = 1; i <= depth; ++i) {
      const std::string one = "*NSET, NSET=s" + std::to_string(i) + "\ns" + std::to_string(i - 1) + "\n";
      forward ? sets += one : inverse = one + inverse;
    }
    const MeshFile file = read(nodes + cubes + inverse + sets);
    EXPECT_THAT(find_set(file.node_sets, "s" + std::to_string(depth))->members, ElementsAre(0, 1));
  }
}

TEST(AbaqusMesh, ALabelOfManyPointsIsOfNoInstance) {
  std::string label = "x";
  for (int i = 0; i < 100000; ++i) label = (i % 2 == 0 ? "p." : "q.") + label;
  const std::string two = part +
                          "*ASSEMBLY\n*INSTANCE, NAME=p, PART=Block\n*END INSTANCE\n*INSTANCE, NAME=q, PART=Block\n"
                          "*END INSTANCE\n*NSET, NSET=deep\n" +
                          label + "\n*END ASSEMBLY\n";
  EXPECT_THAT(find_set(read(two).node_sets, "deep")->problem.substr(0, 60), HasSubstr("there is no set of nodes q.p."));
}

}  // namespace
}  // namespace pinball::test::abaqus_mesh_test
