#include <gmock/gmock.h>

#include <algorithm>
#include <set>

#include <solver/mesh/file/split_hexahedra.hpp>
#include <solver/mesh/file/split_ten_nodes.hpp>
#include <solver/mesh/generators.hpp>
#include <solver/mesh/quality.hpp>
#include <tests/support/error_of.hpp>

namespace pinball::test::split_hexahedra_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A block as a file gives it, with the nodes and faces of its top as sets, and its first element as one.
MeshFile block_file(const std::array<int, 3>& elements) {
  MeshFile file;
  file.path = "block.k";
  file.mesh = generate(BlockMesh{{1, 2, 3}, elements, {}});
  const auto top = [&](std::int32_t n) { return file.mesh.nodes[static_cast<std::size_t>(n)][2] > 3 - 1e-9; };
  MeshSet nodes{1, "top", {}};
  FaceSet faces{2, "roof", {}};
  for (std::size_t n = 0; n < file.mesh.nodes.size(); ++n) {
    file.node_ids.push_back(static_cast<std::int64_t>(10 + 2 * n));
    file.held.push_back(top(static_cast<std::int32_t>(n)) ? 5 : 1);
    if (top(static_cast<std::int32_t>(n))) nodes.members.push_back(static_cast<std::int32_t>(n));
  }
  for (std::size_t e = 0; e < file.mesh.hexahedra.size(); ++e) {
    const auto& h = file.mesh.hexahedra[e];
    if (top(h[4])) faces.faces.push_back({h[4], h[5], h[6], h[7]});
    file.element_ids.push_back(static_cast<std::int64_t>(100 + e));
    file.part.push_back(static_cast<std::int32_t>(e % 2));
    file.line.push_back(static_cast<std::int32_t>(7 + e));
  }
  file.parts = {{1, "even"}, {2, "odd"}};
  file.node_sets = {nodes};
  file.face_sets = {faces};
  file.element_sets = {{3, "first", {0}}};
  return file;
}

std::set<Point> rounded(const std::vector<Point>& nodes) {
  std::set<Point> places;
  for (Point p : nodes) {
    for (double& x : p) x = std::round(x * 1e9) / 1e9;
    places.insert(p);
  }
  return places;
}

TEST(SplitHexahedra, ABlockBecomesThatOfTwiceAsManyElements) {
  MeshFile file = block_file({2, 3, 2});
  const std::vector<Point> old = file.mesh.nodes;
  split_hexahedra(file);
  const MeshFile finer = block_file({4, 6, 4});
  EXPECT_EQ(file.mesh.nodes.size(), finer.mesh.nodes.size());
  EXPECT_EQ(rounded(file.mesh.nodes), rounded(finer.mesh.nodes));
  EXPECT_TRUE(std::equal(old.begin(), old.end(), file.mesh.nodes.begin()));
  ASSERT_EQ(file.mesh.hexahedra.size(), finer.mesh.hexahedra.size());
  std::set<Point> centres, finer_centres;
  for (const MeshFile* of : {static_cast<const MeshFile*>(&file), &finer}) {
    std::vector<Point> all;
    for (const auto& hexahedron : of->mesh.hexahedra) {
      std::array<Point, 8> corners;
      for (std::size_t c = 0; c < 8; ++c) corners[c] = of->mesh.nodes[static_cast<std::size_t>(hexahedron[c])];
      EXPECT_NEAR(volume_by_quadrature(corners), 6.0 / 96, 1e-12);
      all.push_back({(corners[0][0] + corners[6][0]) / 2, (corners[0][1] + corners[6][1]) / 2,
                     (corners[0][2] + corners[6][2]) / 2});
    }
    (of == &file ? centres : finer_centres) = rounded(all);
  }
  EXPECT_EQ(centres, finer_centres);
}

TEST(SplitHexahedra, SetsPartsAndNumbersGoWithIt) {
  MeshFile file = block_file({2, 3, 2});
  const std::size_t old_nodes = file.mesh.nodes.size();
  const std::int64_t largest = file.node_ids.back();
  file.lines_of = {{0, "a.k"}, {4, "b.k"}};
  split_hexahedra(file);
  const MeshFile finer = block_file({4, 6, 4});
  std::vector<Point> top, finer_top;
  for (const std::int32_t n : file.node_sets[0].members) top.push_back(file.mesh.nodes[static_cast<std::size_t>(n)]);
  for (const std::int32_t n : finer.node_sets[0].members)
    finer_top.push_back(finer.mesh.nodes[static_cast<std::size_t>(n)]);
  EXPECT_EQ(top.size(), finer_top.size());
  EXPECT_EQ(rounded(top), rounded(finer_top));
  EXPECT_EQ(file.face_sets[0].faces.size(), finer.face_sets[0].faces.size());
  for (const auto& face : file.face_sets[0].faces) {
    const bool of_one = std::any_of(file.mesh.hexahedra.begin(), file.mesh.hexahedra.end(), [&face](const auto& h) {
      return std::is_permutation(h.begin() + 4, h.end(), face.begin());
    });
    EXPECT_TRUE(of_one);
    const auto at = [&](std::size_t c, std::size_t k) { return file.mesh.nodes[static_cast<std::size_t>(face[c])][k]; };
    const double turn = (at(1, 0) - at(0, 0)) * (at(3, 1) - at(0, 1)) - (at(1, 1) - at(0, 1)) * (at(3, 0) - at(0, 0));
    EXPECT_NEAR(turn, 2.0 / 24, 1e-12);  // the same way round, upwards
  }
  MeshFile apart = block_file({2, 1, 1});
  apart.face_sets = {{1, "", {{0, 1, 2, -1}, {0, 1, 10, 11}}}};  // a node that is gone, and four of no face
  const FaceSet as_it_was = apart.face_sets[0];
  split_hexahedra(apart);
  EXPECT_EQ(apart.face_sets[0].faces, as_it_was.faces);
  EXPECT_EQ(apart.mesh.nodes.size(), 5 * 3 * 3);

  EXPECT_THAT(file.element_sets[0].members, ElementsAre(0, 1, 2, 3, 4, 5, 6, 7));
  ASSERT_EQ(file.element_ids.size(), 96);
  EXPECT_EQ(file.element_ids[7], 100);
  EXPECT_EQ(file.element_ids[8], 101);
  EXPECT_EQ(file.part[15], 1);
  EXPECT_EQ(file.line[16], 9);
  EXPECT_EQ(file.lines_of[1].first, 32);
  ASSERT_EQ(file.node_ids.size(), file.mesh.nodes.size());
  EXPECT_EQ(file.node_ids[old_nodes], largest + 1);
  for (std::size_t n = 0; n < file.mesh.nodes.size(); ++n) {
    EXPECT_EQ(file.held[n], file.mesh.nodes[n][2] > 3 - 1e-9 ? 5 : 1);
  }
}

/// A segment is found by its nodes, whichever way they go: across the face new nodes were made that no element has, and
/// none of the four was a face.
TEST(SplitHexahedra, AFaceNamedAcrossItsEdgesIsSplitAlongThem) {
  for (const std::array<std::int32_t, 4>& named :
       {std::array{4, 5, 6, 7}, std::array{4, 7, 5, 6}, std::array{5, 4, 6, 7}}) {
    MeshFile file = block_file({1, 1, 1});  // the top of which is 4, 5, 7, 6
    file.face_sets = {{1, "top", {named}}};
    split_hexahedra(file);
    EXPECT_EQ(file.mesh.nodes.size(), 27);
    ASSERT_EQ(file.face_sets[0].faces.size(), 4);
    for (const auto& face : file.face_sets[0].faces) {
      EXPECT_TRUE(std::any_of(file.mesh.hexahedra.begin(), file.mesh.hexahedra.end(), [&face](const auto& h) {
        return std::is_permutation(h.begin() + 4, h.end(), face.begin());
      }));
    }
  }
}

TEST(EdgeMiddles, OfAFaceThatIsNamedAcrossItsEdgesAreThoseOfTheFace) {
  EdgeMiddles middles;
  for (const std::array<std::int32_t, 3>& line :
       {std::array{0, 1, 4}, {1, 2, 5}, {2, 3, 6}, {0, 3, 7}, {0, 2, 8}, {1, 3, 8}})
    middles.add(line[0], line[1], line[2]);
  const auto pieces = [&middles](const std::array<std::int32_t, 4>& face) {
    std::set<std::set<std::int32_t>> all;
    for (const auto& piece : middles.pieces_of(face)) all.insert({piece.begin(), piece.end()});
    return all;
  };
  const std::set<std::set<std::int32_t>> four{{0, 4, 7, 8}, {1, 4, 5, 8}, {2, 5, 6, 8}, {3, 6, 7, 8}};
  for (const std::array<std::int32_t, 4>& face : {std::array{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 1, 3, 2}, {3, 1, 0, 2}})
    EXPECT_EQ(pieces(face), four);
}

TEST(SplitHexahedra, ASetThatHasNoWholeEdgeGetsNoNewNode) {
  MeshFile file = block_file({1, 1, 1});
  file.node_sets = {{1, "diagonal", {0, 7}}, {2, "all", {0, 1, 2, 3, 4, 5, 6, 7}}};
  split_hexahedra(file);
  EXPECT_THAT(file.node_sets[0].members, ElementsAre(0, 7));
  EXPECT_EQ(file.node_sets[1].members.size(), 27);
}

TEST(SplitHexahedra, CollapsedHexahedraAreRefused) {
  MeshFile file = block_file({2, 1, 1});
  file.mesh.hexahedra[1][3] = file.mesh.hexahedra[1][2];
  file.mesh.hexahedra[1][7] = file.mesh.hexahedra[1][6];
  EXPECT_THAT(error_of([&] { split_hexahedra(file); }), HasSubstr("element 101"));
}

}  // namespace
}  // namespace pinball::test::split_hexahedra_test
