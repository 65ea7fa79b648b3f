#include <gmock/gmock.h>

#include <cstring>

#include <solver/formats/gmsh/gmsh_reader.hpp>
#include <tests/mesh/damaged_files.hpp>

/// Binary files of Gmsh: those of tests/data/wedge.geo, beside the same as text.
namespace pinball::test::gmsh_binary_test {
namespace {

using testing::HasSubstr;

MeshFile read(const std::string& bytes, const std::vector<std::string>& physicals = {}) {
  return parse_gmsh(bytes, "a.msh", physicals);
}
std::string reading_error(const std::string& bytes) {
  return error_of([&] { read(bytes); });
}

class GmshBinary : public testing::TestWithParam<std::string> {
 protected:
  std::string bytes() const { return bytes_of("wedge_" + GetParam() + "_binary.msh"); }
};
INSTANTIATE_TEST_SUITE_P(Formats, GmshBinary, testing::Values("22", "41"),
                         [](const auto& format) { return "Format" + format.param; });

TEST_P(GmshBinary, HoldsWhatTheTextHolds) {
  const MeshFile file = read(bytes()), text = read(bytes_of("wedge_" + GetParam() + ".msh"));
  EXPECT_EQ(file.mesh.hexahedra, text.mesh.hexahedra);
  ASSERT_EQ(file.mesh.nodes.size(), text.mesh.nodes.size());
  for (std::size_t n = 0; n < file.mesh.nodes.size(); ++n) {
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(file.mesh.nodes[n][k], text.mesh.nodes[n][k], 1e-14);
  }
  EXPECT_EQ(file.node_ids, text.node_ids);
  EXPECT_EQ(file.element_ids, text.element_ids);
  EXPECT_EQ(find_set(file.node_sets, "side 1")->members, find_set(text.node_sets, "side 1")->members);
  EXPECT_EQ(find_set(file.node_sets, "2")->members.size(), 20u);
  EXPECT_EQ(file.face_sets[0].faces, text.face_sets[0].faces);
  EXPECT_EQ(file.face_sets[0].faces.size(), 12u);
  EXPECT_EQ(elements_of_part(file, "wedge").size(), 12u);
  EXPECT_EQ(read(bytes(), {"1"}).mesh.hexahedra.size(), 12u) << "by number";
}

TEST_P(GmshBinary, FilesThatAreCutShortAreErrors) {
  expect_errors_where_cut(bytes(), 1, 1, [](const std::string& part) { read(part); });
}

TEST_P(GmshBinary, FilesWithOtherBytesAreReadOrErrors) {
  EXPECT_GT(errors_where_changed(bytes(), 6000, [](const std::string& changed) { read(changed); }), 2000);
}

TEST_P(GmshBinary, TheOtherByteOrderAndOtherSizesAreRefused) {
  std::string swapped = bytes();
  const std::size_t one = swapped.find('\n', swapped.find('\n') + 1) + 1;
  std::swap(swapped[one], swapped[one + 3]);
  EXPECT_THAT(reading_error(swapped),
              HasSubstr("expected numbers in the byte order of this machine (gmsh writes them anew), got "
                        "\"those of the other byte order\""));
  std::string small = bytes();
  small[small.find(" 8\n") + 1] = '4';
  EXPECT_THAT(reading_error(small), HasSubstr("expected numbers of 8 bytes in a binary file, got \"4\""));
}

TEST(GmshBinary22, CountsBeyondTheFileAreRefused) {
  std::string bytes = bytes_of("wedge_22_binary.msh");
  const std::size_t nodes = bytes.find("$Nodes\n") + 7;
  bytes.replace(nodes, bytes.find('\n', nodes) - nodes, "2000000000");
  EXPECT_THAT(reading_error(bytes),
              HasSubstr("expected as many nodes that the rest of the file can hold, got \"2000000000\""));
}

}  // namespace
}  // namespace pinball::test::gmsh_binary_test
