#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include <solver/contact/segments/edge_table.hpp>

#include "eroding_block.hpp"

namespace pinball::edge_table_test {
namespace {

using namespace test;
using Table = EdgeTable<double>;

/// A surface and its edges, as they are at first.
struct Collected {
  explicit Collected(const Model<double>& model) : surface(ModelSurface<double>(model), surface_topology(model)) {
    edges.collect(surface);
  }
  SegmentSurface<double> surface;
  Table edges;
};

/// Segments by the ends of their sides, sides of no length left out: in the order of segments.
std::map<std::pair<std::int32_t, std::int32_t>, std::vector<std::int32_t>> sides_of(
    const SegmentSurface<double>& surface) {
  std::map<std::pair<std::int32_t, std::int32_t>, std::vector<std::int32_t>> sides;
  for (std::size_t s = 0; s < surface.segments().size(); ++s) {
    const auto& node = surface.segments()[s].node;
    for (int k = 0; k < 4; ++k) {
      const auto [low, high] = std::minmax(node[k], node[(k + 1) % 4]);
      if (low != high) sides[{low, high}].push_back(static_cast<std::int32_t>(s));
    }
  }
  return sides;
}

/// That every side of a segment is one edge, which knows the segments that meet there, and nothing else is.
void expect_edges_of_all_segments(const Collected& c) {
  const auto sides = sides_of(c.surface);
  ASSERT_EQ(c.edges.edges().size(), sides.size());
  std::set<std::pair<std::int32_t, std::int32_t>> met;
  for (std::size_t e = 0; e < sides.size(); ++e) {
    const auto& edge = c.edges.edges()[e];
    const auto side = sides.find({edge.node[0], edge.node[1]});
    ASSERT_NE(side, sides.end());
    EXPECT_TRUE(met.insert(side->first).second) << "each once";
    const auto meeting = c.edges.segments_of(static_cast<std::int32_t>(e));
    EXPECT_EQ(std::vector(meeting.begin(), meeting.end()), side->second);
    for (int end = 0; end < 2; ++end) EXPECT_EQ(c.surface.slaves()[edge.slave[end]].node, edge.node[end]);
  }
  for (std::size_t s = 0; s < c.surface.segments().size(); ++s) {
    const auto& node = c.surface.segments()[s].node;
    const auto& edges = c.edges.edges_of(static_cast<std::int32_t>(s));
    for (std::size_t k = 0; k < 4; ++k) {
      const auto [low, high] = std::minmax(node[k], node[(k + 1) % 4]);
      if (low == high) {
        EXPECT_EQ(edges[k], -1);
        continue;
      }
      ASSERT_GE(edges[k], 0);
      const auto& edge = c.edges.edges()[edges[k]];
      EXPECT_EQ(edge.node[0], low);
      EXPECT_EQ(edge.node[1], high);
    }
  }
}

std::set<std::int64_t> names_of(const Table& edges) {
  std::set<std::int64_t> names;
  for (const auto& edge : edges.edges()) names.insert(Table::name_of(edge));
  return names;
}

std::set<std::int64_t> names_of_active_edges(const Collected& c) {
  std::set<std::int64_t> names;
  for (const auto& edge : c.edges.edges()) {
    const auto segments = Table::segments_of(edge);
    if (std::any_of(segments.begin(), segments.end(), [&](std::int32_t s) { return c.surface.active_segment(s); })) {
      names.insert(Table::name_of(edge));
    }
  }
  return names;
}

/// Edges by how many segments meet there.
std::map<std::size_t, int> meetings(const Table& edges) {
  std::map<std::size_t, int> count;
  for (const auto& edge : edges.edges()) ++count[Table::segments_of(edge).size()];
  return count;
}

TEST(EdgeTable, OfABlockHasEachEdgeOnceBetweenTwoSegments) {
  const Collected block(eroding_block());
  EXPECT_EQ(block.edges.edges().size(), 56 + 54 - 2);  // Euler's formula
  EXPECT_EQ(meetings(block.edges), (std::map<std::size_t, int>{{2, 108}}));
  EXPECT_EQ(names_of(block.edges).size(), 108);
  expect_edges_of_all_segments(block);
}

TEST(EdgeTable, HasNoEdgeForASideOfNoLength) {
  Body body = block("a", {1, 1, 1}, 1, {});
  body.mesh = CylinderMesh{.radius = 0.4, .length = 0.6, .section = Section::wedge, .angle = 30, .radial = 3};
  const Collected wedge(build_model<double>(scene_of({body}, 1)));
  EXPECT_EQ(wedge.surface.segments().size(), 13);
  EXPECT_EQ(wedge.surface.slaves().size(), 14);
  EXPECT_EQ(wedge.edges.edges().size(), 14 + 13 - 2);
  int missing = 0;
  for (std::int32_t s = 0; s < 13; ++s) {
    const auto& edges = wedge.edges.edges_of(s);
    missing += static_cast<int>(std::count(edges.begin(), edges.end(), -1));
  }
  EXPECT_EQ(missing, 2) << "of the triangles at both ends";
  expect_edges_of_all_segments(wedge);
}

TEST(EdgeTable, NamesStayWhateverWaits) {
  Model<double> model = eroding_block();
  const std::set<std::int64_t> names = names_of(Collected(model).edges);
  strain_nearly_to_erosion(model, {upper_element});
  Collected waiting(model);
  expect_edges_of_all_segments(waiting);
  EXPECT_EQ(waiting.edges.edges().size(), 108 + 8);
  EXPECT_EQ(meetings(waiting.edges), (std::map<std::size_t, int>{{2, 104 + 8}, {3, 4}}));
  EXPECT_EQ(names_of_active_edges(waiting), names);

  ASSERT_TRUE(erode(model, waiting.surface, upper_element));
  const std::set<std::int64_t> after = names_of_active_edges(waiting);
  EXPECT_EQ(after.size(), 108 + 8);
  waiting.surface.collect(ModelSurface<double>(model));
  waiting.edges.collect(waiting.surface);
  EXPECT_EQ(names_of_active_edges(waiting), after);
  expect_edges_of_all_segments(waiting);
}

TEST(EdgeTable, FourSegmentsMeetWhereElementsShareAnEdgeAlone) {
  Scene scene = scene_of({block("a", {2, 2, 1}, 0.1, {0, 0, 0})}, 1);
  scene.materials = {plastic_material("steel", 1e9, 1.0)};
  Model<double> model = build_model<double>(scene);
  Collected c(model);
  for (const std::size_t element : {std::size_t{0}, std::size_t{3}}) ASSERT_TRUE(erode(model, c.surface, element));
  c.surface.collect(ModelSurface<double>(model));
  c.edges.collect(c.surface);
  EXPECT_EQ(meetings(c.edges), (std::map<std::size_t, int>{{2, 22}, {4, 1}}));
  expect_edges_of_all_segments(c);
}

TEST(EdgeTable, EdgesShareANodeWhereTheyMeet) {
  const Collected c(eroding_block());
  const auto count = static_cast<std::int32_t>(c.edges.edges().size());
  int sharing = 0;
  for (std::int32_t e = 0; e < count; ++e) {
    for (std::int32_t f = 0; f < count; ++f) {
      const auto &a = c.edges.edges()[e].node, &b = c.edges.edges()[f].node;
      const bool expected = std::find_first_of(a, a + 2, b, b + 2) != a + 2;
      EXPECT_EQ(c.edges.share_node(e, f), expected);
      sharing += e != f && expected;
    }
  }
  EXPECT_EQ(sharing, 8 * 3 * 2 + 48 * 4 * 3) << "three edges at a corner of the block, four at its other nodes";
}

}  // namespace
}  // namespace pinball::edge_table_test
