#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include <solver/base/faces.hpp>
#include <solver/mesh/generators.hpp>
#include <solver/mesh/quality.hpp>
#include <solver/mesh/tetrahedra.hpp>

namespace pinball::tetrahedra_test {
namespace {

/// Ways in which other programs write the tetrahedron of the nodes 5, 6, 7 and 8.
TEST(Tetrahedra, AreFoundInHexahedraThatAreCollapsedToThem) {
  const std::optional<Corners8> expected(tetrahedron(5, 6, 7, 8));
  EXPECT_EQ(as_tetrahedron({5, 6, 7, 7, 8, 8, 8, 8}), expected);
  EXPECT_EQ(as_tetrahedron({5, 6, 7, 8, 8, 8, 8, 8}), expected);
  EXPECT_EQ(as_tetrahedron({5, 5, 6, 7, 8, 8, 8, 8}), expected);
  EXPECT_EQ(as_tetrahedron(*expected), expected);
  // Turned inside out it stays so.
  EXPECT_EQ(as_tetrahedron({8, 8, 8, 8, 5, 6, 7, 7}), std::optional<Corners8>(tetrahedron(8, 5, 6, 7)));
  EXPECT_EQ(as_tetrahedron({5, 6, 7, 8, 5, 6, 7, 8}), std::nullopt);  // fills nothing
  EXPECT_EQ(as_tetrahedron({5, 6, 7, 7, 8, 9, 9, 9}), std::nullopt);  // five nodes
  EXPECT_EQ(as_tetrahedron({5, 6, 7, 7, 5, 6, 7, 7}), std::nullopt);  // three
}

bool is_positive(const Mesh& mesh, const Corners8& corners) {
  std::array<Point, 8> points;
  for (std::size_t i = 0; i < 8; ++i) points[i] = mesh.nodes[corners[i]];
  return volume_by_quadrature(points) > 0;
}

/// Faces that no other element has.
std::size_t outer_faces_of(const Mesh& mesh) {
  std::size_t count = 0;
  for (const auto& of_element : face_neighbours(mesh.hexahedra)) count += std::ranges::count(of_element, -1);
  return count;
}

TEST(Tetrahedra, AreCutOfHexahedraSoThatNeighboursFit) {
  struct Case {
    MeshSettings mesh;
    std::size_t per_element;
    bool warped;  // faces: then their volumes differ from those of two triangles
  };
  const std::vector<Case> cases{
      {BlockMesh{{1, 2, 3}, {2, 3, 4}}, 6, false},
      {CylinderMesh{.radius = 1, .length = 2, .core = 4, .ring = 3, .layers = 5}, 6, false},
      {SphereMesh{.radius = 1, .core = {4, 4}, .ring = 3}, 6, true},
  };
  for (const Case& c : cases) {
    const Mesh mesh = generate(c.mesh), cut = cut_into_tetrahedra(mesh);
    EXPECT_EQ(cut.hexahedra.size(), c.per_element * mesh.hexahedra.size());
    EXPECT_EQ(cut.nodes.size(), mesh.nodes.size());
    for (const Corners8& corners : cut.hexahedra) {
      EXPECT_TRUE(is_tetrahedron(corners));
      EXPECT_TRUE(is_positive(cut, corners));
    }
    EXPECT_EQ(outer_faces_of(cut), 2 * outer_faces_of(mesh));  // inner ones all fit
    EXPECT_NEAR(measure_quality(cut).volume, measure_quality(mesh).volume, (c.warped ? 0.02 : 1e-12) * 6);
  }
}

TEST(Tetrahedra, AreCutAlikeInWhateverOrderNodesAreNumbered) {
  Mesh mesh = generate(BlockMesh{{1, 1, 1}, {3, 3, 3}});
  std::vector<std::int32_t> number(mesh.nodes.size());
  std::iota(number.begin(), number.end(), 0);
  for (int trial = 0; trial < 20; ++trial) {
    std::ranges::next_permutation(number);
    std::ranges::rotate(number, number.begin() + 7);
    Mesh other = mesh;
    for (std::size_t n = 0; n < number.size(); ++n) other.nodes[number[n]] = mesh.nodes[n];
    for (Corners8& corners : other.hexahedra) {
      for (std::int32_t& node : corners) node = number[node];
    }
    const Mesh cut = cut_into_tetrahedra(other);
    EXPECT_EQ(cut.hexahedra.size(), 6 * mesh.hexahedra.size());
    EXPECT_EQ(outer_faces_of(cut), 2 * outer_faces_of(mesh));
    EXPECT_NEAR(measure_quality(cut).volume, 1, 1e-12);
  }
}

TEST(Tetrahedra, AreCutOfWedges) {
  const Mesh mesh = generate(
      CylinderMesh{.radius = 0.4, .length = 0.6, .section = Section::wedge, .angle = 20, .radial = 3, .layers = 2});
  const Mesh cut = cut_into_tetrahedra(mesh);
  EXPECT_EQ(cut.hexahedra.size(), 2 * 3 + 4 * 6U);  // two wedges at the axis, four hexahedra
  for (const Corners8& corners : cut.hexahedra) EXPECT_TRUE(is_positive(cut, corners));
  EXPECT_NEAR(measure_quality(cut).volume, measure_quality(mesh).volume, 1e-12);
}

}  // namespace
}  // namespace pinball::tetrahedra_test
