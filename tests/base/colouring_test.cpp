#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

#include <solver/base/colouring.hpp>
#include <solver/base/error.hpp>
#include <solver/mesh/generators.hpp>
#include <solver/model/ordering.hpp>

namespace pinball::colouring_test {
namespace {

using Hexahedra = std::vector<std::array<std::int32_t, 8>>;

std::vector<std::int32_t> equal_tiles(std::size_t elements, std::size_t tile) {
  std::vector<std::int32_t> offsets{0};
  while (static_cast<std::size_t>(offsets.back()) < elements)
    offsets.push_back(static_cast<std::int32_t>(std::min(elements, offsets.back() + tile)));
  return offsets;
}

/// Every tile listed once, items ascending within a colour, no node in two tiles of one colour.
void expect_valid(const Colouring& colouring, const std::vector<std::int32_t>& offsets, const Hexahedra& hexahedra) {
  const std::size_t tiles = offsets.size() - 1;
  ASSERT_EQ(colouring.items.size(), tiles);
  ASSERT_EQ(colouring.colour_offsets.front(), 0);
  ASSERT_EQ(colouring.colour_offsets.back(), static_cast<std::int32_t>(tiles));
  EXPECT_EQ(std::set<std::int32_t>(colouring.items.begin(), colouring.items.end()).size(), tiles);
  for (std::size_t colour = 0; colour + 1 < colouring.colour_offsets.size(); ++colour) {
    const auto begin = colouring.items.begin() + colouring.colour_offsets[colour];
    const auto end = colouring.items.begin() + colouring.colour_offsets[colour + 1];
    EXPECT_LT(begin, end) << "colour without tiles";
    EXPECT_TRUE(std::is_sorted(begin, end));
    std::set<std::int32_t> seen;
    for (auto tile = begin; tile != end; ++tile) {
      std::set<std::int32_t> nodes;
      for (std::int32_t element = offsets[*tile]; element < offsets[*tile + 1]; ++element)
        nodes.insert(hexahedra[element].begin(), hexahedra[element].end());
      for (const std::int32_t node : nodes) EXPECT_TRUE(seen.insert(node).second) << "node " << node;
    }
  }
}

std::size_t colours(const Colouring& colouring) { return colouring.colour_offsets.size() - 1; }

TEST(Colouring, OfSingleElementsOfABlockNeedsEight) {
  const Mesh mesh = generate_block({{1, 1, 1}, {8, 8, 8}});
  const auto offsets = equal_tiles(mesh.hexahedra.size(), 1);
  const Colouring colouring = colour_tiles(offsets, mesh.hexahedra, static_cast<std::int32_t>(mesh.nodes.size()));
  expect_valid(colouring, offsets, mesh.hexahedra);
  EXPECT_EQ(colours(colouring), 8u);
}

TEST(Colouring, OfOrderedTilesIsValidFrugalAndBalanced) {
  const Mesh mesh = generate_block({{42, 17, 10}, {42, 17, 10}});
  std::vector<Point> centres;
  for (const auto& hexahedron : mesh.hexahedra) centres.push_back(mesh.nodes[hexahedron[0]]);
  Hexahedra ordered;
  std::vector<std::int32_t> all(centres.size());
  std::iota(all.begin(), all.end(), 0);
  const TileOrder tiles = compact_tiles(centres, std::vector<Point>(centres.size(), Point{1, 1, 1}), all, 16, 8);
  for (const std::int32_t element : tiles.order) ordered.push_back(mesh.hexahedra[element]);
  const auto& offsets = tiles.offsets;
  const Colouring colouring = colour_tiles(offsets, ordered, static_cast<std::int32_t>(mesh.nodes.size()));
  expect_valid(colouring, offsets, ordered);
  EXPECT_LE(colours(colouring), 24u);
  const auto mean = static_cast<double>(offsets.size() - 1) / static_cast<double>(colours(colouring));
  for (std::size_t colour = 0; colour < colours(colouring); ++colour)
    EXPECT_LE(colouring.colour_offsets[colour + 1] - colouring.colour_offsets[colour], 1.5 * mean + 1) << colour;
}

TEST(Colouring, OfShuffledMeshesIsValid) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 4; ++trial) {
    Mesh mesh =
        trial % 2 ? generate_round_nosed_rod({8, 1, true, {2, 2}, 1, 30}) : generate_block({{1, 1, 1}, {9, 7, 5}});
    std::shuffle(mesh.hexahedra.begin(), mesh.hexahedra.end(), random);
    for (const std::size_t tile : {1, 3, 16}) {
      const auto offsets = equal_tiles(mesh.hexahedra.size(), tile);
      expect_valid(colour_tiles(offsets, mesh.hexahedra, static_cast<std::int32_t>(mesh.nodes.size())), offsets,
                   mesh.hexahedra);
    }
  }
}

TEST(Colouring, OfRandomElementsTakesMoreThan64Colours) {
  std::mt19937 random(5);
  std::uniform_int_distribution<std::int32_t> node(0, 99);
  Hexahedra hexahedra(1500);
  for (auto& hexahedron : hexahedra)
    for (auto& entry : hexahedron) entry = node(random);
  const auto offsets = equal_tiles(hexahedra.size(), 2);
  const Colouring colouring = colour_tiles(offsets, hexahedra, 100);
  expect_valid(colouring, offsets, hexahedra);
  EXPECT_GT(colours(colouring), 128u);
}

TEST(Colouring, AcceptsNoTilesAndEmptyTiles) {
  EXPECT_EQ(colours(colour_tiles({0}, {}, 0)), 0u);
  const Mesh mesh = generate_block({{1, 1, 1}, {2, 1, 1}});
  const std::vector<std::int32_t> offsets{0, 0, 1, 1, 2, 2};
  expect_valid(colour_tiles(offsets, mesh.hexahedra, 12), offsets, mesh.hexahedra);
}

TEST(Colouring, RejectsWhatDoesNotFit) {
  const Mesh mesh = generate_block({{1, 1, 1}, {2, 1, 1}});
  EXPECT_THROW(colour_tiles({}, mesh.hexahedra, 12), InputError);
  EXPECT_THROW(colour_tiles({0, 1}, mesh.hexahedra, 12), InputError);
  EXPECT_THROW(colour_tiles({0, 2, 1, 2}, mesh.hexahedra, 12), InputError);
  EXPECT_THROW(colour_tiles({0, 2}, mesh.hexahedra, 11), InputError);
}

}  // namespace
}  // namespace pinball::colouring_test
