#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include <solver/base/error.hpp>
#include <solver/formats/lsdyna/mesh/keyword_mesh.hpp>
#include <solver/mesh/quality.hpp>
#include <solver/mesh/tetrahedra.hpp>
#include <tests/formats/ten_nodes_case.hpp>
#include <tests/support/error_of.hpp>
#include <tests/support/folder_case.hpp>

namespace pinball::test::keyword_mesh_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string nodes = R"(*NODE
      11             0.0             0.0             0.0
      12             1.0             0.0             0.0
      13             1.0             1.0             0.0
      14             0.0             1.0             0.0
      15             0.0             0.0             1.0
      16             1.0             0.0             1.0
      17             1.0             1.0             1.0
      18             0.0             1.0             1.0
)";
const std::string one_line =
    "*ELEMENT_SOLID\n       7       3      11      12      13      14      15      16      17      18\n";

MeshFile read(const std::string& text) { return keyword_mesh(parse_keyword_deck(text, "a.k")); }

std::string error_of(const std::string& text) {
  return test::error_of([&] { read(text); });
}

TEST(KeywordMesh, ReadsBothLayoutsOfSolids) {
  const MeshFile a = read(nodes + one_line);
  EXPECT_EQ(a.mesh.hexahedra.size(), 1u);
  EXPECT_THAT(a.mesh.hexahedra[0], ElementsAre(0, 1, 2, 3, 4, 5, 6, 7));
  EXPECT_EQ(a.element_ids[0], 7);
  EXPECT_EQ(a.parts[a.part[0]].id, 3);
  EXPECT_DOUBLE_EQ(measure_quality(a.mesh).volume, 1.0);
  const MeshFile b = read(nodes + "*ELEMENT_SOLID\n7,3\n11,12,13,14,15,16,17,18,0,0\n");
  EXPECT_EQ(b.mesh.hexahedra, a.mesh.hexahedra);
  EXPECT_EQ(b.line[0], 11);
}

TEST(KeywordMesh, KeywordsMayComeInAnyOrder) {
  EXPECT_EQ(read(one_line + nodes).mesh.hexahedra, read(nodes + one_line).mesh.hexahedra);
}

TEST(KeywordMesh, AWedgeIsACollapsedHexahedron) {
  const MeshFile wedge = read(nodes + "*ELEMENT_SOLID\n1,1,11,12,16,15,14,13,13,14\n");
  EXPECT_DOUBLE_EQ(std::abs(measure_quality(wedge.mesh).volume), 0.5);
}

TEST(KeywordMesh, ATetrahedronHasFourNodesHoweverTheyAreRepeated) {
  for (const char* rest : {"14,15,15,15,15", "14,14,15,15,15", "15,15,15,15,15", "15,0,0,0,0"}) {
    const std::string line = std::string("7,3,11,12,14,") + rest;
    const MeshFile found = read(nodes + "*ELEMENT_SOLID\n" + line + "\n");
    EXPECT_EQ(found.mesh.hexahedra.at(0), tetrahedron(0, 1, 3, 4)) << line;
    EXPECT_DOUBLE_EQ(measure_quality(found.mesh).volume, 1.0 / 6);
  }
}

TEST(KeywordMesh, WhatIsWrongIsNamedByItsNumberAndLine) {
  EXPECT_EQ(error_of(nodes + "*ELEMENT_SOLID\n7,3,11,12,13,14,15,16,17,99\n"),
            "a.k:11: *ELEMENT_SOLID: element 7 has node 99, which is not there");
  EXPECT_EQ(error_of(nodes + "*ELEMENT_SOLID\n7,3,11,12,13,14,11,12,13,14\n"),
            "a.k:11: *ELEMENT_SOLID: element 7 has four nodes or less, and fills no tetrahedron: expected n1 n2 n3 n4 "
            "n4 n4 n4 n4");
  for (const char* line : {"7,3,11,12,13,14,15", "7,3,11,12,14,15,16,18,0,0", "7,3\n11,12,13,14,15,0,0,0"})
    EXPECT_THAT(error_of(nodes + "*ELEMENT_SOLID\n" + line + "\n"),
                HasSubstr("*ELEMENT_SOLID: element 7 has seven nodes or less: expected eight, of a wedge"))
        << line;
  EXPECT_EQ(error_of(nodes + one_line + one_line), "a.k:13: element 7 is given twice, first in a.k:11");
  EXPECT_EQ(error_of(nodes + nodes), "a.k:11: node 11 is given twice, first in a.k:2");
  EXPECT_EQ(error_of(nodes + "*NODE\n$\n19,0,0,0\n\n12,0,0,0\n"), "a.k:14: node 12 is given twice, first in a.k:3");
  EXPECT_EQ(error_of(nodes + "*PART\na\n1\n\n\nb\n1\n"), "a.k:16: part 1 is given twice, first in a.k:12");
  EXPECT_EQ(error_of(nodes + "*ELEMENT_SOLID_ORTHO\n"), "a.k:10: *ELEMENT_SOLID_ORTHO is not read");
  EXPECT_EQ(error_of(nodes + "*ELEMENT_SOLID\n7,3\n11,12,13,14,15,16,17,18,11,0\n"),
            "a.k:12: *ELEMENT_SOLID: element 7 has nine nodes or less: expected eight, or ten of a tetrahedron");
  EXPECT_THAT(
      error_of(nodes + "*ELEMENT_SOLID\n7,3\n11,12,13,14,15,16,17,18,11,12\n"),
      HasSubstr("a.k:11: element 7 (line 11 of a.k): node 15 is not near the middle of its edge, from node 11"));
}

std::vector<std::int32_t> members(const MeshFile& file, const std::string& set) {
  const MeshSet* found = find_set(file.node_sets, set);
  return found == nullptr ? std::vector<std::int32_t>{-1} : found->members;
}

TEST(KeywordMesh, HasTheSetsOfTheDeck) {
  const MeshFile file =
      read(nodes + one_line +
           "*SET_NODE_LIST_TITLE\nbottom\n1\n11,12,13,14\n*SET_NODE_LIST_GENERATE\n2\n13,15\n"
           "*SET_NODE_GENERAL\n3\nPART,3\nDNODE,11\n*DEFINE_BOX\n5,-1,2,-1,2,0.5,2\n*SET_NODE_GENERAL\n4\nBOX,5\n"
           "*SET_NODE_ADD\n6\n1,4\n*SET_SOLID\n1\n7\n*SET_SEGMENT\n9\n11,12,13,14\n");
  EXPECT_THAT(members(file, "bottom"), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(members(file, "1"), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(members(file, "2"), ElementsAre(2, 3, 4));
  EXPECT_THAT(members(file, "3"), ElementsAre(1, 2, 3, 4, 5, 6, 7));
  EXPECT_THAT(members(file, "4"), ElementsAre(4, 5, 6, 7));
  EXPECT_EQ(members(file, "6").size(), 8u);
  EXPECT_THAT(elements_of_part(file, "1"), ElementsAre(0));
  EXPECT_THAT(file.face_sets[0].faces[0], ElementsAre(0, 1, 2, 3));
}

/// Of two cubes, of which the second is part 4.
TEST(KeywordMesh, PartsOfSegmentsAreThreeAndThenAttributes) {
  const std::string second =
      "*NODE\n21,5,0,0\n22,6,0,0\n23,6,1,0\n24,5,1,0\n25,5,0,1\n26,6,0,1\n27,6,1,1\n28,5,1,1\n"
      "*ELEMENT_SOLID\n8,4,21,22,23,24,25,26,27,28\n";
  const auto faces = [&](const std::string& lines) {
    const MeshFile file = read(nodes + one_line + second + "*SET_SEGMENT_GENERAL\n9\n" + lines);
    EXPECT_EQ(file.face_sets[0].problem, "");
    return std::pair(file.face_sets[0].faces.size(), file.notes.size());
  };
  EXPECT_EQ(faces("PART,3\n"), std::pair(6UL, 0UL));
  EXPECT_EQ(faces("PART,3,4\n"), std::pair(12UL, 0UL));
  EXPECT_EQ(faces("PART,3,0,0,4.,0.5\n"), std::pair(6UL, 1UL));
  EXPECT_EQ(faces("ALL\nDPART,0,0,0,4\n"), std::pair(6UL, 0UL));
}

TEST(KeywordMesh, SetsHaveAllForms) {
  const MeshFile file = read(nodes + one_line +
                             "*SET_NODE_LIST_GENERATE_INCREMENT\n1\n11,18,3\n*SET_NODE_COLUMN\n2\n13,0.5\n14,0.5\n"
                             "*SET_NODE_LIST_COLLECT\n3\n11\n*SET_NODE_LIST_COLLECT_TITLE\nmore\n3\n12\n"
                             "*SET_NODE_GENERAL\n4\nALL\nDBOX,5\n*DEFINE_BOX\n5,-1,2,-1,2,0.5,2\n"
                             "*SET_NODE_GENERAL\n6\nPART,3\nDPART,3\nNODE,11,12\n*SET_NODE_LIST_SMOOTH\n7\n11\n");
  EXPECT_THAT(members(file, "1"), ElementsAre(0, 3, 6));
  EXPECT_THAT(members(file, "2"), ElementsAre(2, 3));
  EXPECT_THAT(members(file, "3"), ElementsAre(0, 1));
  EXPECT_THAT(members(file, "4"), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(members(file, "6"), ElementsAre(0, 1));
  EXPECT_THAT(find_set(file.node_sets, "7")->problem, HasSubstr("*SET_NODE_LIST_SMOOTH is not read"));
}

TEST(KeywordMesh, SegmentsOfPartsAndBoxesAreFacesOfTheSurface) {
  const MeshFile file =
      read(nodes + "*NODE\n21,2,0,0\n22,2,1,0\n23,2,0,1\n24,2,1,1\n" + one_line +
           "*ELEMENT_SOLID\n8,4,12,21,22,13,16,23,24,17\n*DEFINE_BOX\n5,-1,3,-1,2,0.5,2\n"
           "*SET_SEGMENT_GENERAL\n1\nPART,3\n*SET_SEGMENT_GENERAL\n2\nALL\n*SET_SEGMENT_GENERAL\n3\nBOX,5\n"
           "*SET_SEGMENT_GENERAL\n4\nPART,3\nDSEG,14,13,12,11\n*SET_SEGMENT_COLLECT\n1\n11,12,13\n");
  ASSERT_EQ(file.face_sets.size(), 4u);
  EXPECT_EQ(file.face_sets[0].faces.size(), 5u + 1) << "the face between both parts is inside";
  EXPECT_THAT(file.face_sets[0].faces[5], ElementsAre(0, 1, 2, 2));
  EXPECT_EQ(file.face_sets[1].faces.size(), 10u);
  EXPECT_EQ(file.face_sets[2].faces.size(), 2u);
  EXPECT_EQ(file.face_sets[3].faces.size(), 4u);
}

class IncludedMesh : public test::FolderTest {};

TEST_F(IncludedMesh, LinesOfElementsAreThoseOfTheirFile) {
  std::ofstream(folder_ / "inner.k") << "*KEYWORD\n" << nodes << one_line;
  std::ofstream(folder_ / "outer.k") << "*KEYWORD\n*INCLUDE\ninner.k\n*ELEMENT_SOLID\n8,3,11,12,13,14,15,16,17,18\n";
  const MeshFile file = keyword_mesh(read_keyword_deck((folder_ / "outer.k").string()));
  EXPECT_EQ(place_of_element(file, 0), (folder_ / "inner.k").string() + ":12");
  EXPECT_EQ(place_of_element(file, 1), (folder_ / "outer.k").string() + ":5");
}

TEST(KeywordMesh, HoldsWhatTcSays) {
  EXPECT_THAT(read("*NODE\n1,0,0,0\n2,0,0,0,4\n3,0,0,0,7\n4,0,0,0\n").held, ElementsAre(0, 3, 7, 0));
  EXPECT_TRUE(read(nodes).held.empty());
  EXPECT_EQ(error_of("*NODE\n1,0,0,0,8\n"), "a.k:2: *NODE: TC: expected 0 to 7, got 8");
}

TEST(KeywordMesh, ASetWithMembersThatAreNotThereIsAnErrorForItsUser) {
  const MeshFile file = read(nodes + one_line + "*SET_NODE\n1\n11,99\n");
  EXPECT_EQ(find_set(file.node_sets, "1")->problem, "a.k:14: *SET_NODE: node 99 is not there");
}

TEST_F(IncludedMesh, AnIncludedFileIsMovedAndNumberedAnew) {
  std::ofstream(folder_ / "part.k") << "*KEYWORD\n" << nodes << one_line;
  std::ofstream(folder_ / "main.k") << "*KEYWORD\n*INCLUDE\npart.k\n*INCLUDE_TRANSFORM\npart.k\n100,200,300\n\n\n4\n"
                                       "*DEFINE_TRANSFORMATION\n4\nSCALE,2,2,2\nROTATE,0,0,1,0,0,0,90\nTRANSL,10,0,0\n";
  const MeshFile file = keyword_mesh(read_keyword_deck((folder_ / "main.k").string()));
  ASSERT_EQ(file.mesh.hexahedra.size(), 2u);
  EXPECT_EQ(file.node_ids[8], 111);
  EXPECT_EQ(file.element_ids[1], 207);
  EXPECT_EQ(file.parts[file.part[1]].id, 303);
  EXPECT_NEAR(file.mesh.nodes[9][0], 10, 1e-15);
  EXPECT_NEAR(file.mesh.nodes[9][1], 2, 1e-15);
  EXPECT_NEAR(measure_quality(file.mesh).volume, 1 + 8, 1e-12);
}

/// Lengths first, and then the transformation, which is in the units of the deck.
TEST_F(IncludedMesh, AnIncludedFileMayHaveAnotherUnitOfLength) {
  std::ofstream(folder_ / "part.k") << "*KEYWORD\n"
                                    << nodes << one_line
                                    << "*DEFINE_BOX\n5,-0.1,1.1,-0.1,1.1,0.9,1.1\n"
                                       "*SET_SEGMENT_GENERAL\n6\nBOX,5\n";
  const auto read_with = [&](const std::string& transformation) {
    std::ofstream(folder_ / "main.k") << "*KEYWORD\n*INCLUDE_TRANSFORM\npart.k\n\n\n1,1,1000\n" << transformation;
    return keyword_mesh(read_keyword_deck((folder_ / "main.k").string()));
  };
  const MeshFile scaled = read_with("");
  EXPECT_NEAR(measure_quality(scaled.mesh).volume, 1e9, 1);
  EXPECT_EQ(find_set(scaled.face_sets, "6")->faces.size(), 1u) << "boxes, too";
  const MeshFile moved = read_with("4\n*DEFINE_TRANSFORMATION\n4\nTRANSL,10,0,0\n");
  for (std::size_t n = 0; n < moved.mesh.nodes.size(); ++n)
    EXPECT_EQ(moved.mesh.nodes[n][0], scaled.mesh.nodes[n][0] + 10) << n;
}

TEST_F(IncludedMesh, AMirroredFileHasItsElementsTurned) {
  std::ofstream(folder_ / "part.k") << "*KEYWORD\n" << nodes << one_line;
  std::ofstream(folder_ / "mirrored.k")
      << "*KEYWORD\n*DEFINE_TRANSFORMATION\n4\nMIRROR,0,0,0,1,0,0\n*INCLUDE_TRANSFORM\npart.k\n0,0\n\n\n4\n";
  const MeshFile file = keyword_mesh(read_keyword_deck((folder_ / "mirrored.k").string()));
  EXPECT_NEAR(measure_quality(file.mesh).volume, 1, 1e-15);
  EXPECT_EQ(file.mesh.nodes[1][0], -1);
}

/// In the order of other formats the node of the edge 1-4 stands where that of 2-4 is expected.
TEST(KeywordMesh, TheLastOfTenNodesIsThatOfTheFirstAndTheFourth) {
  const std::string ten = "*NODE\n" + ten_nodes_lines(",") + "*ELEMENT_SOLID\n1,1\n";
  EXPECT_THAT(error_of(ten + joined(ten_nodes_elements[0], ",") + "\n"),
              HasSubstr("node 34 is not near the middle of its edge, from node 1 to 4"));
  EXPECT_EQ(read(ten + joined(keyword_ten_nodes[0], ",") + "\n").mesh.hexahedra.size(), 8u);
}

TEST_F(IncludedMesh, AMirroredFileHasItsTenNodesTurned) {
  std::ofstream(folder_ / "part.k") << "*KEYWORD\n*NODE\n"
                                    << ten_nodes_lines(",") << "*ELEMENT_SOLID\n1,1\n"
                                    << joined(keyword_ten_nodes[0], ",") << "\n2,1\n"
                                    << joined(keyword_ten_nodes[1], ",") << "\n";
  std::ofstream(folder_ / "mirrored.k")
      << "*KEYWORD\n*DEFINE_TRANSFORMATION\n4\nMIRROR,0,0,0,1,0,0\n*INCLUDE_TRANSFORM\npart.k\n0,0\n\n\n4\n";
  const MeshFile file = keyword_mesh(read_keyword_deck((folder_ / "mirrored.k").string()));
  const MeshQuality quality = measure_quality(file.mesh);
  EXPECT_EQ(file.mesh.hexahedra.size(), 16u);
  EXPECT_NEAR(quality.volume, 0.5, 1e-15);
  EXPECT_EQ(quality.inverted, 0);
}

}  // namespace
}  // namespace pinball::test::keyword_mesh_test
