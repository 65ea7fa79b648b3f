#include <gmock/gmock.h>

#include <fstream>

#include <solver/model/model.hpp>
#include <tests/support/cube_text.hpp>
#include <tests/support/error_of.hpp>
#include <tests/support/scene_fixture.hpp>
#include <tests/support/scene_text.hpp>

/// What is told of the mesh of a file, by its own numbers.
namespace pinball::test::file_checks_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Two unit cubes, parts 1 and 2, one on the other, each with nodes of its own at z = 1.
const std::string apart = "*NODE\n" + cube_lines(10, 10) +
                          replaced(square_lines(150, 1, 10), "150,0,0,1\n", "150,0,0,1.00001\n") +
                          square_lines(90, 2, 10) + R"(*ELEMENT_SOLID
1,1,10,20,30,40,50,60,70,80
2,2,150,160,170,180,90,100,110,120
)";

class FileChecks : public SceneTest {
 protected:
  /// Of one body, or of a second one, "upper", with more lines of the scene behind it.
  ModelMesh mesh_of(const std::string& deck, bool two = false, const std::string& more = "") {
    std::ofstream(folder_ / "cubes.k") << "*KEYWORD\n" << deck << "*END\n";
    std::vector<std::string> lines = with(14, two ? R"(mesh = { type = "keyword", file = "cubes.k", part = "1" })"
                                                  : R"(mesh = { type = "keyword", file = "cubes.k" })");
    if (two) {
      for (const char* line : {"[[body]]", "name = \"upper\"", "material = \"copper\"",
                               R"(mesh = { type = "file", file = "cubes.k", part = "2" })"}) {
        lines.emplace_back(line);
      }
    }
    lines.push_back(more);
    return build_mesh(read(lines));
  }
  std::string problem(const std::string& deck) {
    return error_of([&] { mesh_of(deck); });
  }
};

TEST_F(FileChecks, NodesOnEachOtherAreTold) {
  EXPECT_THAT(mesh_of(apart).warnings,
              ElementsAre(HasSubstr(
                  "cubes.k: body bar: 4 pairs of nodes lie on each other and are not joined, such as 50 and 150 "
                  "at (0, 0, 1): it comes apart there")));
  EXPECT_THAT(mesh_of(apart, true).warnings,
              ElementsAre(HasSubstr(
                  "bodies bar and upper: 4 pairs of nodes lie on each other and are not joined, such as 50 and "
                  "150 at (0, 0, 1): the bodies come apart there")));
}

TEST_F(FileChecks, NodesThatATieJoinsAreNotTold) {
  const std::string sets = "*SET_SEGMENT\n8\n50,60,70,80\n*SET_NODE_LIST\n9\n150,160\n";
  const auto told = [&](const std::string& first, const std::string& second) {
    return mesh_of(apart + sets, true, "[[contact.tied]]\nfirst = " + first + "\nsecond = " + second).warnings;
  };
  EXPECT_THAT(told("\"upper\"", "\"bar\""), IsEmpty());
  EXPECT_THAT(told("\"bar\"", "\"upper\""), IsEmpty());
  EXPECT_THAT(told("\"upper\"", "{ faces = \"8\" }"), IsEmpty());
  EXPECT_THAT(told("{ nodes = \"9\" }", "{ elements = \"1\" }"),
              ElementsAre(HasSubstr("2 pairs of nodes lie on each other and are not joined, such as 70 and 170")));
  EXPECT_THAT(told("\"upper\"", "\"upper\""), ElementsAre(HasSubstr("4 pairs of nodes")));
}

/// Surfaces that the scene lets meet are apart on purpose; where a body only meets itself nobody has said so.
TEST_F(FileChecks, NodesOfTheTwoSidesOfAContactPairAreNotTold) {
  const std::string sets = "*SET_SEGMENT\n8\n50,60,70,80\n*SET_SEGMENT\n9\n150,160,170,180\n";
  const auto told = [&](bool two, const std::string& sides) {
    return mesh_of(apart + sets, two, "[[contact.pair]]\n" + sides).warnings;
  };
  EXPECT_THAT(told(true, "first = \"upper\"\nsecond = \"bar\""), IsEmpty());
  EXPECT_THAT(told(false, "first = { faces = \"8\" }\nsecond = { faces = \"9\" }"), IsEmpty());
  EXPECT_THAT(told(false, "first = \"bar\""), ElementsAre(HasSubstr("4 pairs of nodes")));
}

TEST_F(FileChecks, NothingIsToldOfASoundMesh) {
  EXPECT_THAT(mesh_of(replaced(apart, "2,2,150,160,170,180", "2,2,50,60,70,80")).warnings, IsEmpty())
      << "nodes 150 to 180 are free";
}

TEST_F(FileChecks, FoldedElementsAreToldAndInvertedOnesRefused) {
  const std::string one = replaced(apart, "2,2,150,160,170,180,90,100,110,120\n", "");
  EXPECT_THAT(mesh_of(one).warnings, IsEmpty());
  EXPECT_THAT(
      mesh_of(replaced(one, "10,0,0,0", "10,.6,.6,0")).warnings,
      ElementsAre(HasSubstr("1 element is folded: the Jacobian of a corner or of a Gauss point is negative, such as of "
                            "element 1 (line 20 of")));
  EXPECT_THAT(problem(replaced(one, "10,20,30,40,50,60,70,80", "50,60,70,80,10,20,30,40")),
              HasSubstr("element 1 (line 20 of "));
}

TEST_F(FileChecks, AnElementThatIsThereTwiceIsRefused) {
  EXPECT_THAT(problem(replaced(apart, "2,2,150,160,170,180,90,100,110,120", "7,2,50,60,70,80,10,20,30,40")),
              HasSubstr("7"));
  EXPECT_THAT(problem(replaced(apart, "2,2,150,160,170,180,90,100,110,120", "7,1,10,20,30,40,50,60,70,80")),
              HasSubstr("cubes.k) and element 7 (line 21 of"));
  EXPECT_THAT(problem(replaced(apart, "2,2,150,160,170,180,90,100,110,120", "7,1,10,20,30,40,50,60,70,80")),
              HasSubstr("have the same nodes, as 1 pair of elements: expected each of them once"));
}

TEST_F(FileChecks, ListTheGroupsOfTheFile) {
  const ModelMesh mesh = mesh_of(apart + "*SET_NODE_LIST_TITLE\ntop\n7\n90,100,110,120\n");
  ASSERT_EQ(mesh.files.size(), 1u);
  std::vector<std::string> groups;
  for (const MeshGroup& group : mesh.files[0].groups)
    groups.push_back(fmt::format("{} {} {}", group.id, group.name, group.members));
  EXPECT_THAT(groups, ElementsAre("1  1", "2  1", "7 top 4"));
}

}  // namespace
}  // namespace pinball::test::file_checks_test
