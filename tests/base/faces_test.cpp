#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

#include <solver/base/error.hpp>
#include <solver/base/faces.hpp>
#include <solver/mesh/generators.hpp>

namespace pinball::faces_test {
namespace {

using Hexahedra = std::vector<std::array<std::int32_t, 8>>;
using Neighbours = std::vector<std::array<std::int32_t, 6>>;

std::set<std::int32_t> face_set(const std::array<std::int32_t, 8>& hexahedron, int face) {
  std::set<std::int32_t> nodes;
  for (const int local : face_nodes[face]) nodes.insert(hexahedron[local]);
  return nodes;
}

Neighbours brute_force_neighbours(const Hexahedra& hexahedra) {
  std::vector<std::array<std::set<std::int32_t>, 6>> faces(hexahedra.size());
  for (std::size_t e = 0; e < hexahedra.size(); ++e)
    for (int f = 0; f < 6; ++f) faces[e][f] = face_set(hexahedra[e], f);
  Neighbours neighbours(hexahedra.size(), {-1, -1, -1, -1, -1, -1});
  for (std::size_t e = 0; e < hexahedra.size(); ++e)
    for (std::size_t other = 0; other < hexahedra.size(); ++other)
      for (int f = 0; f < 6 && other != e; ++f)
        for (int g = 0; g < 6; ++g)
          if (faces[e][f] == faces[other][g]) neighbours[e][f] = static_cast<std::int32_t>(other);
  return neighbours;
}

Point area_vector(const Mesh& mesh, std::size_t element, int face) {
  Point x[4];
  for (int i = 0; i < 4; ++i) x[i] = mesh.nodes[mesh.hexahedra[element][face_nodes[face][i]]];
  Point a, b;
  for (int i = 0; i < 3; ++i) a[i] = x[2][i] - x[0][i], b[i] = x[3][i] - x[1][i];
  return {0.5 * (a[1] * b[2] - a[2] * b[1]), 0.5 * (a[2] * b[0] - a[0] * b[2]), 0.5 * (a[0] * b[1] - a[1] * b[0])};
}

Mesh small_rod(bool half = true) { return generate_round_nosed_rod({3.0, 1.0, half, {2, 2}, 1, 7}); }

TEST(Faces, AreaVectorsOfABoxPointAlongTheParentAxes) {
  const Mesh mesh = generate_block({{2, 3, 5}, {1, 1, 1}});
  const Point expected[6] = {{-15, 0, 0}, {15, 0, 0}, {0, -10, 0}, {0, 10, 0}, {0, 0, -6}, {0, 0, 6}};
  for (int face = 0; face < 6; ++face) EXPECT_EQ(area_vector(mesh, 0, face), expected[face]) << face;
}

TEST(Faces, AgreeWithBruteForce) {
  Hexahedra block = generate_block({{1, 1, 1}, {5, 4, 3}}).hexahedra;
  EXPECT_EQ(face_neighbours(block), brute_force_neighbours(block));
  std::mt19937 random(1);
  std::shuffle(block.begin(), block.end(), random);
  EXPECT_EQ(face_neighbours(block), brute_force_neighbours(block));
  for (const bool half : {true, false}) {
    Hexahedra rod = small_rod(half).hexahedra;
    EXPECT_EQ(face_neighbours(rod), brute_force_neighbours(rod));
    std::shuffle(rod.begin(), rod.end(), random);
    EXPECT_EQ(face_neighbours(rod), brute_force_neighbours(rod));
  }
  EXPECT_TRUE(face_neighbours({}).empty());
}

TEST(Faces, SurfaceIsClosedAndOfTheTopologyOfASphere) {
  for (const Mesh& mesh : {small_rod(true), small_rod(false), generate_block({{1, 2, 3}, {3, 4, 5}})}) {
    const Neighbours neighbours = face_neighbours(mesh.hexahedra);
    Point sum{};
    double volume = 0.0;  // by the divergence theorem on the surface's bilinear patches, exact for flat faces
    std::set<std::int32_t> nodes;
    std::set<std::pair<std::int32_t, std::int32_t>> edges;
    int faces = 0;
    for (std::size_t e = 0; e < mesh.hexahedra.size(); ++e)
      for (int f = 0; f < 6; ++f) {
        if (neighbours[e][f] >= 0) continue;
        ++faces;
        const Point area = area_vector(mesh, e, f);
        for (int i = 0; i < 4; ++i) {
          const std::int32_t a = mesh.hexahedra[e][face_nodes[f][i]], b = mesh.hexahedra[e][face_nodes[f][(i + 1) % 4]];
          nodes.insert(a);
          edges.insert({std::min(a, b), std::max(a, b)});
          for (int axis = 0; axis < 3; ++axis) volume += area[axis] * mesh.nodes[a][axis] / 12.0;
        }
        for (int axis = 0; axis < 3; ++axis) sum[axis] += area[axis];
      }
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(sum[axis], 0.0, 1e-12);
    EXPECT_GT(volume, 0.0);
    EXPECT_EQ(static_cast<int>(nodes.size()) - static_cast<int>(edges.size()) + faces, 2);
  }
}

TEST(Faces, OfTheSameElementTwiceAreRefused) {
  Hexahedra hexahedra = generate_block({{1, 1, 1}, {1, 1, 2}}).hexahedra;
  const auto twin = hexahedra[1];
  const std::array turned{twin[1], twin[2], twin[3], twin[0], twin[5], twin[6], twin[7], twin[4]};
  for (const auto& other : {twin, turned}) {
    try {
      face_neighbours({twin, other});
      ADD_FAILURE() << "accepted";
    } catch (const InputError& error) {
      EXPECT_STREQ(error.what(), "mesh: elements 0 and 1 have the same nodes");
    }
  }
  // A ring of three: each shares a face with each.
  EXPECT_NO_THROW(face_neighbours({{0, 1, 3, 2, 4, 5, 7, 6}, {2, 3, 9, 8, 6, 7, 11, 10}, {8, 9, 1, 0, 10, 11, 5, 4}}));
}

TEST(Faces, NameTheElementOfABadFace) {
  Hexahedra hexahedra = generate_block({{1, 1, 1}, {1, 1, 2}}).hexahedra;
  hexahedra.push_back({4, 5, 7, 6, 12, 13, 15, 14});  // a second element on top of the first
  try {
    face_neighbours(hexahedra);
    FAIL() << "three elements at a face were accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("element 2"), std::string::npos) << error.what();
  }
  EXPECT_THROW(face_neighbours({{0, 1, 2, 3, 3, 2, 1, 0}}), InputError);
  EXPECT_THROW(face_neighbours({{0, 1, 2, 3, 4, 5, 6, -7}}), InputError);
}

}  // namespace
}  // namespace pinball::faces_test
