#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include <solver/base/error.hpp>
#include <solver/mesh/keyword_mesh.hpp>
#include <solver/mesh/quality.hpp>

namespace pinball::test {
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
  try {
    read(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
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

TEST(KeywordMesh, WhatIsWrongIsNamedByItsNumberAndLine) {
  EXPECT_EQ(error_of(nodes + "*ELEMENT_SOLID\n7,3,11,12,13,14,15,16,17,99\n"),
            "a.k:11: *ELEMENT_SOLID: element 7 has node 99, which is not there");
  EXPECT_EQ(error_of(nodes + "*ELEMENT_SOLID\n7,3,11,12,13,14,14,14,14,14\n"),
            "a.k:11: *ELEMENT_SOLID: element 7 is a tetrahedron, which is not read yet");
  EXPECT_EQ(error_of(nodes + one_line + one_line), "a.k:12: element 7 is given twice");
  EXPECT_EQ(error_of(nodes + nodes), "a.k:10: node 11 is given twice");
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

TEST(KeywordMesh, ASetWithMembersThatAreNotThereIsAnErrorForItsUser) {
  const MeshFile file = read(nodes + one_line + "*SET_NODE\n1\n11,99\n");
  EXPECT_EQ(find_set(file.node_sets, "1")->problem, "a.k:14: *SET_NODE: node 99 is not there");
}

TEST(KeywordMesh, AnIncludedFileIsMovedAndNumberedAnew) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "keyword_mesh";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "part.k") << "*KEYWORD\n" << nodes << one_line;
  std::ofstream(folder / "main.k") << "*KEYWORD\n*INCLUDE\npart.k\n*INCLUDE_TRANSFORM\npart.k\n100,200,300\n\n\n4\n"
                                      "*DEFINE_TRANSFORMATION\n4\nSCALE,2,2,2\nROTATE,0,0,1,0,0,0,90\nTRANSL,10,0,0\n";
  const MeshFile file = keyword_mesh(read_keyword_deck((folder / "main.k").string()));
  ASSERT_EQ(file.mesh.hexahedra.size(), 2u);
  EXPECT_EQ(file.node_ids[8], 111);
  EXPECT_EQ(file.element_ids[1], 207);
  EXPECT_EQ(file.parts[file.part[1]].id, 303);
  EXPECT_NEAR(file.mesh.nodes[9][0], 10, 1e-15);
  EXPECT_NEAR(file.mesh.nodes[9][1], 2, 1e-15);
  EXPECT_NEAR(measure_quality(file.mesh).volume, 1 + 8, 1e-12);
}

TEST(KeywordMesh, AMirroredFileHasItsElementsTurned) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "keyword_mesh";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "part.k") << "*KEYWORD\n" << nodes << one_line;
  std::ofstream(folder / "mirrored.k")
      << "*KEYWORD\n*DEFINE_TRANSFORMATION\n4\nMIRROR,0,0,0,1,0,0\n*INCLUDE_TRANSFORM\npart.k\n0,0\n\n\n4\n";
  const MeshFile file = keyword_mesh(read_keyword_deck((folder / "mirrored.k").string()));
  EXPECT_NEAR(measure_quality(file.mesh).volume, 1, 1e-15);
  EXPECT_EQ(file.mesh.nodes[1][0], -1);
}

}  // namespace
}  // namespace pinball::test
