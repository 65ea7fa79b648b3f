#include <gmock/gmock.h>

#include <solver/mesh/mesh_file.hpp>
#include <tests/support/error_of.hpp>

namespace pinball::test::mesh_file_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(MeshFile, ANameOfSeveralSetsIsOfNone) {
  const std::vector<MeshSet> sets{{3, "top", {1}}, {7, "top", {2}}, {8, "base", {3}}, {9, "3", {5}}};
  EXPECT_THAT(error_of([&] { find_set(sets, "top"); }), HasSubstr("\"top\" is the name of several parts or sets"));
  EXPECT_THAT(find_set(sets, "7")->members, ElementsAre(2));
  EXPECT_THAT(find_set(sets, "base")->members, ElementsAre(3));
  EXPECT_THAT(find_set(sets, "3")->members, ElementsAre(5)) << "names count before numbers";
  EXPECT_EQ(find_set(sets, "x"), nullptr);
  EXPECT_EQ(find_set(sets, "8x"), nullptr);
  EXPECT_EQ(find_set(sets, ""), nullptr);
}

TEST(MeshFile, APartOfWhichThereAreSeveralIsOfNone) {
  MeshFile file;
  file.parts = {{1, "rod"}, {2, "rod"}};
  file.part = {0, 1};
  file.mesh.hexahedra.resize(2);
  EXPECT_THAT(error_of([&] { elements_of_part(file, "rod"); }), HasSubstr("\"rod\" is the name of several"));
  EXPECT_THAT(elements_of_part(file, "2"), ElementsAre(1));
}

}  // namespace
}  // namespace pinball::test::mesh_file_test
