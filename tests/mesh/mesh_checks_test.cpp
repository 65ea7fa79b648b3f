#include <gmock/gmock.h>

#include <random>

#include <solver/mesh/generators.hpp>
#include <solver/mesh/mesh_checks.hpp>

namespace pinball::test::mesh_checks_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

Mesh block(int elements) { return generate_block({{1, 1, 1}, {elements, elements, elements}, {}}); }

TEST(CheckShapes, FindNothingInSoundMeshes) {
  const Mesh mesh = block(4);
  const ShapeFindings found = check_shapes(mesh.nodes, mesh.hexahedra);
  EXPECT_THAT(found.inverted_at_centre, IsEmpty());
  EXPECT_THAT(found.inverted_somewhere, IsEmpty());
  EXPECT_DOUBLE_EQ(found.shortest_edge, 0.25);
  CylinderMesh wedge;
  wedge.radius = wedge.length = 1;
  wedge.section = Section::wedge;
  wedge.angle = 10;
  wedge.radial = wedge.layers = 3;
  const Mesh collapsed = generate_cylinder(wedge);
  EXPECT_THAT(check_shapes(collapsed.nodes, collapsed.hexahedra).inverted_somewhere, IsEmpty())
      << "of collapsed elements";
}

TEST(CheckShapes, AnElementIsFoldedWhereACornerIsDrawnThroughIt) {
  Mesh mesh = block(1);
  mesh.nodes[0] = {0.45, 0.45, 0};
  EXPECT_THAT(check_shapes(mesh.nodes, mesh.hexahedra).inverted_somewhere, IsEmpty());
  mesh.nodes[0] = {0.6, 0.6, 0};
  const ShapeFindings found = check_shapes(mesh.nodes, mesh.hexahedra);
  EXPECT_THAT(found.inverted_somewhere, ElementsAre(0));
  EXPECT_THAT(found.inverted_at_centre, IsEmpty());
}

TEST(CheckShapes, AnElementIsInvertedWhereItsCentreIs) {
  Mesh mesh = block(2);
  std::swap_ranges(mesh.hexahedra[5].begin(), mesh.hexahedra[5].begin() + 4, mesh.hexahedra[5].begin() + 4);
  EXPECT_THAT(check_shapes(mesh.nodes, mesh.hexahedra).inverted_at_centre, ElementsAre(5));
}

/// Every pair of nodes, by itself.
TEST(CoincidentNodes, AreThoseThatAreNear) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-1, 1), little(-1.2e-3, 1.2e-3);
  std::vector<Point> nodes;
  for (int i = 0; i < 400; ++i) nodes.push_back({place(random), place(random), place(random)});
  for (int i = 0; i < 400; ++i) {
    Point x = nodes[i];
    for (double& coordinate : x) coordinate += little(random);
    nodes.push_back(x);
  }
  const double tolerance = 1e-3;
  std::vector<std::int32_t> expected, found;
  for (std::size_t b = 0; b < nodes.size(); ++b) {
    for (std::size_t a = 0; a < b; ++a) {
      if (dot(minus(nodes[a], nodes[b]), minus(nodes[a], nodes[b])) > tolerance * tolerance) continue;
      expected.push_back(static_cast<std::int32_t>(b));
      break;
    }
  }
  for (const auto& [a, b] : coincident_nodes(nodes, std::vector<bool>(nodes.size(), true), tolerance)) {
    EXPECT_LE(dot(minus(nodes[a], nodes[b]), minus(nodes[a], nodes[b])), tolerance * tolerance);
    found.push_back(b);
  }
  EXPECT_GT(found.size(), 100u);
  EXPECT_LT(found.size(), 300u);
  EXPECT_EQ(found, expected);
}

TEST(CoincidentNodes, AreFoundOnRoundNumbersAndOnlyWhereUsed) {
  std::vector<Point> nodes = block(10).nodes;
  const auto count = static_cast<std::int32_t>(nodes.size());
  for (std::int32_t i = 0; i < count; ++i) nodes.push_back({nodes[i][0] - 1e-6, nodes[i][1] + 1e-6, nodes[i][2]});
  std::vector<bool> used(nodes.size(), true);
  EXPECT_EQ(coincident_nodes(nodes, used, 1e-5).size(), static_cast<std::size_t>(count));
  EXPECT_THAT(coincident_nodes(nodes, used, 1e-7), IsEmpty());
  std::fill(used.begin() + count + 1, used.end(), false);
  EXPECT_THAT(coincident_nodes(nodes, used, 1e-5), ElementsAre(Pair(0, count)));
}

TEST(RepeatedElements, AreThoseOfTheSameNodesInAnyOrder) {
  Mesh mesh = block(3);
  EXPECT_THAT(repeated_elements(mesh.hexahedra), IsEmpty());
  mesh.hexahedra.push_back(mesh.hexahedra[4]);
  std::rotate(mesh.hexahedra.back().begin(), mesh.hexahedra.back().begin() + 4, mesh.hexahedra.back().end());
  EXPECT_THAT(repeated_elements(mesh.hexahedra), ElementsAre(Pair(4, 27)));
}

}  // namespace
}  // namespace pinball::test::mesh_checks_test
