#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <random>
#include <sstream>

#include <solver/base/faces.hpp>
#include <solver/formats/gmsh/gmsh_reader.hpp>
#include <solver/formats/mesh_reader.hpp>
#include <solver/mesh/generators.hpp>
#include <solver/mesh/quality.hpp>
#include <solver/model/model.hpp>
#include <tests/support/error_of.hpp>
#include <tests/support/scene_fixture.hpp>
#include <tests/support/scene_text.hpp>

/// tests/data/two_volumes_*.msh: "left part", two hexahedra in x = 0 ... 2, and "right", two prisms in x = 2 ... 3;
/// with a point and a surface, numbers with gaps and, in format 4.1, nodes with parametric coordinates.
namespace pinball::gmsh_test {
namespace {

using namespace test;

std::string text_of(const std::string& version) {
  std::ifstream file(PINBALL_SOURCE_DIR "/tests/data/two_volumes_" + version + ".msh");
  std::ostringstream text;
  text << file.rdbuf();
  EXPECT_FALSE(text.str().empty());
  return text.str();
}

std::vector<std::string> physicals_of(const std::string& physical) {
  return physical.empty() ? std::vector<std::string>{} : std::vector{physical};
}

std::string error_of(const std::string& text, const std::string& physical = "") {
  return test::error_of([&] { parse_gmsh(text, "a.msh", physicals_of(physical)); });
}

class Gmsh : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Formats, Gmsh, testing::Values("22", "41"),
                         [](const auto& format) { return "Format" + format.param; });

TEST_P(Gmsh, ReadsHexahedraAndPrisms) {
  const Mesh mesh = parse_gmsh(text_of(GetParam()), "a.msh", {}).mesh;
  EXPECT_EQ(mesh.hexahedra.size(), 4u);
  EXPECT_EQ(mesh.nodes.size(), 16u);
  const MeshQuality quality = measure_quality(mesh);
  EXPECT_NEAR(quality.volume, 1.5, 1e-14);
  EXPECT_EQ(quality.inverted, 0);
  const auto neighbours = face_neighbours(mesh.hexahedra);
  int exposed = 0;
  for (const auto& element : neighbours) exposed += static_cast<int>(std::count(element.begin(), element.end(), -1));
  EXPECT_EQ(exposed, 5 + 4 + (5 - 2) + (5 - 1));
}

TEST_P(Gmsh, TakesThePhysicalVolumeAsked) {
  const Mesh left = parse_gmsh(text_of(GetParam()), "a.msh", {"left part"}).mesh;
  EXPECT_EQ(left.hexahedra.size(), 2u);
  EXPECT_EQ(left.nodes.size(), 12u);
  EXPECT_NEAR(measure_quality(left).volume, 1.0, 1e-14);
  const Mesh right = parse_gmsh(text_of(GetParam()), "a.msh", {"right"}).mesh;
  EXPECT_EQ(right.hexahedra.size(), 2u);
  EXPECT_EQ(right.nodes.size(), 8u);
  EXPECT_NEAR(measure_quality(right).volume, 0.5, 1e-14);
  for (const auto& prism : right.hexahedra) {
    EXPECT_EQ(prism[2], prism[3]);
    EXPECT_EQ(prism[6], prism[7]);
  }
}

TEST_P(Gmsh, BothFormatsHoldTheSamePoints) {
  const Mesh mesh = parse_gmsh(text_of(GetParam()), "a.msh", {}).mesh,
             other = parse_gmsh(text_of("22"), "a.msh", {}).mesh;
  for (std::size_t e = 0; e < 4; ++e)
    for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(mesh.nodes[mesh.hexahedra[e][i]], other.nodes[other.hexahedra[e][i]]);
}

std::vector<std::int32_t> members(const MeshFile& file, const std::string& set) {
  const MeshSet* found = find_set(file.node_sets, set);
  return found == nullptr ? std::vector<std::int32_t>{-1} : found->members;
}

TEST_P(Gmsh, GroupsArePartsAndSets) {
  const MeshFile file = parse_gmsh(text_of(GetParam()), "a.msh", {});
  EXPECT_EQ(elements_of_part(file, "left part"), (std::vector<std::int32_t>{0, 1}));
  EXPECT_EQ(elements_of_part(file, "2"), (std::vector<std::int32_t>{2, 3}));
  EXPECT_EQ(parse_gmsh(text_of(GetParam()), "a.msh", {"2"}).mesh.hexahedra.size(), 2u) << "by number";
  const std::vector<std::int32_t> end = members(file, "clamped end");
  ASSERT_EQ(end.size(), 4u);
  for (const std::int32_t node : end) EXPECT_EQ(file.mesh.nodes[node][0], 0);
  EXPECT_EQ(members(file, "3"), end) << "by number";
  ASSERT_EQ(file.face_sets.size(), 1u);
  EXPECT_EQ(file.face_sets[0].name, "clamped end");
  EXPECT_EQ(nodes_of_faces(file.face_sets[0].faces), end);
  for (const std::int64_t number : {1, 8}) EXPECT_EQ(std::ranges::count(file.node_ids, number), 1) << number;
  // Of the other part alone: none of its nodes is at the clamped end.
  const MeshFile right = parse_gmsh(text_of(GetParam()), "a.msh", {"right"});
  EXPECT_TRUE(members(right, "clamped end").empty());
  EXPECT_EQ(right.face_sets.at(0).faces, (std::vector<std::array<std::int32_t, 4>>{{-1, -1, -1, -1}}));
}

TEST_P(Gmsh, EveryFileCutShortIsAnError) {
  const std::string text = text_of(GetParam());
  const std::size_t whole = text.find_last_not_of('\n') + 1;
  for (std::size_t length = 0; length < whole; ++length)
    EXPECT_NE(error_of(text.substr(0, length)), "no error") << length;
  EXPECT_EQ(error_of(text.substr(0, whole)), "no error");
}

TEST_P(Gmsh, DamagedFilesNeverCrash) {
  const std::string text = text_of(GetParam());
  std::mt19937 random(3);
  const std::string alphabet = "0123456789 -.e$\"\nEN\xff";
  int rejected = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    std::string damaged = text;
    for (unsigned k = random() % 3 + 1; k > 0; --k)
      damaged[random() % text.size()] = alphabet[random() % alphabet.size()];
    if (trial % 3 == 0) damaged.erase(random() % text.size(), random() % 20);
    rejected += error_of(damaged, trial % 2 ? "right" : "") != "no error";
  }
  EXPECT_GT(rejected, 10000);
}

TEST_P(Gmsh, NamesAreNamedWhereTheyAreNotFound) {
  const std::string text = text_of(GetParam());
  EXPECT_EQ(error_of(text, "lefd part"), "a.msh: no physical volume is named \"lefd part\": nearest is \"left part\"");
  EXPECT_EQ(error_of(text, "clamped end"),
            "a.msh: no physical volume is named \"clamped end\": it is a group of surfaces, curves or points; nearest "
            "is \"left part\"");
  EXPECT_EQ(error_of(replaced(replaced(text, "3 1 \"left", "2 1 \"left"), "3 2 \"right", "2 2 \"right"), "left"),
            "a.msh: no physical volume is named \"left\": it has none with a name");
}

TEST_P(Gmsh, ANameOfSeveralVolumesIsOfNone) {
  const std::string text = replaced(text_of(GetParam()), "\"right\"", "\"left part\"");
  EXPECT_EQ(error_of(text, "left part"),
            "a.msh: the physical volumes 1, 2 have the name \"left part\": ask for them by their numbers");
  EXPECT_EQ(error_of(text, "2"), "no error");
  EXPECT_EQ(error_of(text), "no error");
}

TEST_P(Gmsh, OtherVersionsAreRejected) {
  const std::string text = text_of(GetParam()), version = GetParam() == "22" ? "2.2" : "4.1";
  EXPECT_EQ(error_of(replaced(text, version + " 0", "4 0")),
            "a.msh:2: expected format 2.2 or 4.1 (gmsh -format msh41 or msh22 writes them), got \"4\"");
  EXPECT_EQ(error_of(replaced(text, " 0 8", " 2 8")),
            "a.msh:2: expected 0 for a text file, 1 for a binary one, got \"2\"");
  EXPECT_THAT(error_of(replaced(text, " 0 8", " 1 8")), testing::HasSubstr("expected the number 1 in four bytes, got"));
  EXPECT_EQ(error_of("solid x\n"), "a.msh:1: expected $MeshFormat, got \"solid\"");
  EXPECT_EQ(error_of(""), "a.msh:1: expected $MeshFormat, got the end of the file");
}

TEST_P(Gmsh, LineEndsOfWindowsAndOtherSectionsDoNotMatter) {
  std::string text = text_of(GetParam()), windows;
  text += "$Periodic\n0\n$EndPeriodic\n";
  for (const char c : text) windows += c == '\n' ? "\r\n" : std::string(1, c);
  EXPECT_EQ(parse_gmsh(windows, "a.msh", {"right"}).mesh.nodes,
            parse_gmsh(text_of(GetParam()), "a.msh", {"right"}).mesh.nodes);
  EXPECT_EQ(error_of(text_of(GetParam()) + "$Periodic\n0\n"),
            "a.msh:" + std::to_string(std::count(text.begin(), text.end(), '\n')) +
                ": expected $EndPeriodic, got the end of the file");
}

TEST_P(Gmsh, ReadsWhatGmshWrites) {  // see tests/data/wedge.geo
  const Mesh mesh = read_gmsh(PINBALL_SOURCE_DIR "/tests/data/wedge_" + GetParam() + ".msh", {"wedge"}).mesh;
  EXPECT_EQ(mesh.hexahedra.size(), 12u);
  EXPECT_EQ(mesh.nodes.size(), 36u);
  const MeshQuality quality = measure_quality(mesh);
  EXPECT_NEAR(quality.volume, 1.0, 1e-12);  // half of 2 x 2 sin(30 degrees), times a height of 1
  EXPECT_EQ(quality.inverted, 0);
  int prisms = 0;
  for (const auto& element : face_neighbours(mesh.hexahedra))
    prisms += static_cast<int>(std::count(element.begin(), element.end(), collapsed_face));
  EXPECT_EQ(prisms, 3);
}

TEST(GmshFormat22, NamesTheLineOfABadElement) {
  const std::string text = text_of("22");
  EXPECT_EQ(error_of(replaced(text, "5 6 2 2 2 90 ", "5 6 2 2 2 33 ")),
            "a.msh:35: expected nodes of the file, got 33, which is not there");
  EXPECT_EQ(error_of(replaced(text, "6 6 2 2 2", "6 12 2 2 2")),
            "a.msh:36: expected types of hexahedra (5), wedges (6), pyramids (7) or tetrahedra (4, 11), got 27-node "
            "hexahedra (type 12)");
  EXPECT_EQ(error_of(replaced(text, "6 6 2 2 2", "6 12 2 2 2"), "left part"), "no error");  // not of this volume
  EXPECT_EQ(error_of(replaced(text, "\n2 1 0 0\n", "\n2 1 nan 0\n")),
            "a.msh:13: expected a coordinate of a node, got \"nan\"");
  EXPECT_EQ(error_of(replaced(text, "\n3 1 1 0\n", "\n2 1 1 0\n")),
            "a.msh:14: expected a node of its own, got \"2 again\"");
}

TEST(GmshFormat22, ElementsOfSeveralGroupsAreTakenOnce) {
  std::string text = replaced(text_of("22"), "$Elements\n6", "$Elements\n7");
  const auto begin = text.find("\n4 5 2 1 1 ") + 1;
  std::string twice = text.substr(begin, text.find('\n', begin) + 1 - begin);
  twice = replaced(twice, "4 5 2 1 1 ", "7 5 2 2 1 ");
  text.insert(text.find("$EndElements"), twice);
  EXPECT_EQ(parse_gmsh(text, "a.msh", {}).mesh.hexahedra.size(), 4u);
  EXPECT_EQ(parse_gmsh(text, "a.msh", {"left part"}).mesh.hexahedra.size(), 2u);
  EXPECT_EQ(parse_gmsh(text, "a.msh", {"right"}).mesh.hexahedra.size(), 3u);
}

TEST(GmshFormat41, CountsMustAgree) {
  EXPECT_THAT(error_of(replaced(text_of("41"), "4 16 1", "4 17 1")),
              testing::HasSubstr("expected 17 nodes in the blocks, got \"16\""));
  EXPECT_THAT(error_of(replaced(text_of("41"), "4 6 1 6\n0 1 15 1", "3 6 1 6\n0 1 15 1")),
              testing::HasSubstr("expected $EndElements, got \"3\""));
}

TEST(GmshMesh, WithoutVolumesIsAnError) {
  const std::string head = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
  EXPECT_EQ(error_of(head), "a.msh:4: expected a section $Nodes, got the end of the file");
  EXPECT_EQ(error_of(head + "$Nodes\n0\n$EndNodes\n"),
            "a.msh:7: expected a section $Elements, got the end of the file");
  EXPECT_EQ(error_of(head + "$Nodes\n0\n$EndNodes\n$Elements\n0\n$EndElements"),
            "a.msh: expected hexahedra, wedges, pyramids or tetrahedra, got none");
}

TEST(GmshFormat22, SaysWhatAFileThatEndsLacks) {
  const std::string head = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
  EXPECT_EQ(error_of(head + "$ParametricNodes\n1\n1 0 0 0"),
            "a.msh:6: expected the entity of a node, got the end of the file");
  EXPECT_EQ(error_of(head + "$Nodes\n1\n1 0 0 0\n$EndNodes\n$Elements\n1\n1 15 2 0 1"),
            "a.msh:10: expected the nodes of an element, got the end of the file");
}

class GmshScene : public SceneTest {
 protected:
  void write(const std::string& text) { std::ofstream(folder_ / "part.msh") << text; }
  std::vector<std::string> scene(const std::string& more = "") {
    return with(14, "mesh = { type = \"gmsh\", file = \"part.msh\"" + more + " }");
  }
};

TEST_F(GmshScene, FindsTheFileBesideTheScene) {
  write(text_of("41"));
  const Scene scene = read(this->scene(", physical = \"right\", scale = 2"));
  const auto& file = std::get<FileMesh>(scene.bodies[0].mesh);
  EXPECT_NEAR(measure_quality(read_mesh_file(file, {file.part}).mesh).volume, 4.0, 1e-13);
  EXPECT_EQ(build_mesh(scene).hexahedra.size(), 2u);
}

TEST_F(GmshScene, SaysWhatIsWrong) {
  EXPECT_EQ(error(scene()),
            "14:32: body.bar.mesh.file: expected a mesh file, there is no " + (folder_ / "part.msh").string());
  write(text_of("41"));
  EXPECT_THAT(error(scene(), {.refine = 2}), testing::HasSubstr("--refine 2: expected 1, a mesh from a file"));
  EXPECT_THAT(error(scene(", scale = 0")), testing::HasSubstr("mesh.scale: expected a number > 0, got 0"));
}

TEST_F(GmshScene, AFlatOrInvertedElementIsRejected) {
  const auto build_error = [this](const std::string& text) -> std::string {
    write(text);
    return test::error_of([&] { build_mesh(read(scene(", physical = \"right\""))); });
  };
  const std::string text = text_of("22");
  EXPECT_EQ(build_error(text), "no error");
  // The last prism is from (3, 0), (3, 1), (2, 1): with (3, 1) moved onto the line of the others it is flat.
  std::string flat = replaced(text, " 3 1 0\n", " 2.5 0.5 0\n");
  EXPECT_THAT(build_error(replaced(flat, " 3 1 0.5\n", " 2.5 0.5 0.5\n")),
              testing::HasSubstr("part.msh) is inverted or flat: its volume is"));
  flat = replaced(text, " 3 1 0\n", " 2.2 0.2 0\n");
  EXPECT_THAT(build_error(replaced(flat, " 3 1 0.5\n", " 2.2 0.2 0.5\n")),
              testing::HasSubstr("part.msh) is inverted or flat: its volume is -"));
}

}  // namespace
}  // namespace pinball::gmsh_test
