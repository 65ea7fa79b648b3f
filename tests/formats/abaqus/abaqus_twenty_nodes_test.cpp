#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

#include <solver/formats/abaqus/mesh/abaqus_mesh.hpp>
#include <solver/model/model.hpp>

#include "abaqus_case.hpp"

/// A deck with hexahedra of twenty nodes as a scene: a cube of 2 mm, 10, and another one on its top, 11.
namespace pinball::test::abaqus_twenty_nodes_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr std::array<std::array<int, 3>, 20> places{
    {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2}, {0, 2, 2}, {1, 0, 0}, {2, 1, 0},
     {1, 2, 0}, {0, 1, 0}, {1, 0, 2}, {2, 1, 2}, {1, 2, 2}, {0, 1, 2}, {0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}}};

/// Its number, by its place: those of the upper cube go on.
int number_at(int x, int y, int z) { return 1 + x + 3 * (y + 3 * z); }

std::string element_of(int number, int up) {
  std::string line = std::to_string(number);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto& [x, y, z] = places[i];
    line += fmt::format(",{}{}", i == 14 ? "\n " : " ", number_at(x, y, z + up));
  }
  return line + "\n";
}

/// moved: what the node in the middle of the edge from (0, 0, 2) to (2, 0, 2) is moved along y by.
std::string deck_of(int elements, const std::string& in_step = "", const std::string& more = "", double moved = 0,
                    const std::string& type = "C3D20R") {
  std::string nodes, solids = element_of(10, 0);
  if (elements == 2) solids += element_of(11, 2);
  for (int z = 0; z <= 2 * elements; ++z) {
    for (int y = 0; y < 3; ++y) {
      for (int x = 0; x < 3; ++x) {
        if (x % 2 + y % 2 + z % 2 > 1) continue;
        const bool is_moved = x == 1 && y == 0 && z == 2;
        nodes += fmt::format("{}, {}., {}, {}.\n", number_at(x, y, z), x, is_moved ? moved : y, z);
      }
    }
  }
  return "*NODE\n" + nodes + "*ELEMENT, TYPE=" + type + ", ELSET=all\n" + solids +
         "*SOLID SECTION, ELSET=all, MATERIAL=Steel\n,\n*NSET, NSET=foot\n1, 2, 3, 4, 6, 7, 8, 9\n" + more +
         abaqus_steel + abaqus_step(in_step);
}

class AbaqusTwentyNodes : public AbaqusTest {};

TEST_F(AbaqusTwentyNodes, AreEightOfEightNodes) {
  for (const char* type : {"C3D20", "C3D20R", "C3D20H", "C3D20RH"}) {
    const Model<double> model = build_model<double>(scene(deck_of(1, "", "", 0, type)));
    EXPECT_EQ(model.element_count(), 8);
    EXPECT_EQ(model.mesh.nodes.size(), 27u);
    const double mass = 7.85e-9 * 8;
    EXPECT_NEAR(std::accumulate(model.node_mass.begin(), model.node_mass.end(), 0.0), mass, 1e-14 * mass);
    EXPECT_NEAR(*std::ranges::max_element(model.node_mass), mass / 8, 1e-14 * mass) << "in the middle";
    EXPECT_NEAR(*std::ranges::min_element(model.node_mass), mass / 64, 1e-14 * mass) << "at the corners";
  }
  EXPECT_EQ(build_model<double>(scene(deck_of(2))).mesh.nodes.size(), 45u) << "nine are of both";
  EXPECT_THAT(translate(deck_of(2)).understood,
              testing::Contains(HasSubstr("2 hexahedra of twenty nodes, each as eight of eight nodes")));
}

/// The nodes in the middles of faces are not the deck's: which of two sets belong together is not known.
TEST_F(AbaqusTwentyNodes, AreNotPairedByEquationsOfSets) {
  const std::string head = "*NSET, NSET=head\n19, 20, 21, 22, 24, 25, 26, 27\n",
                    paired = "*EQUATION\n2\nhead, 3, 1., foot, 3, -1.\n",
                    led = "*EQUATION\n2\nhead, 3, 1., 1, 3, -1.\n";
  EXPECT_THAT(error(deck_of(1, "", head + paired)),
              HasSubstr("*EQUATION of pairs of nodes of two sets on elements of twenty nodes"));
  EXPECT_THAT(error(deck_of(1, "", head + "*MPC\nPIN, head, foot\n")), HasSubstr("*MPC of pairs of nodes"));
  EXPECT_EQ(scene(deck_of(1, "", head + led)).equation_terms.size(), 2u);
}

/// Of a face that bends: its middle is half of what its edge is from where it was, that of the element a quarter.
TEST_F(AbaqusTwentyNodes, GetNodesWhereShapeFunctionsHaveThem) {
  const Model<double> model = build_model<double>(scene(deck_of(1, "", "", 0.4)));
  const auto has = [&](const Point& x) {
    return std::ranges::any_of(model.mesh.nodes, [&](const Point& node) {
      return std::abs(node[0] - x[0]) + std::abs(node[1] - x[1]) + std::abs(node[2] - x[2]) < 1e-12;
    });
  };
  EXPECT_TRUE(has({1, 0.4, 2}));
  EXPECT_TRUE(has({1, 1.2, 2})) << "of its top";
  EXPECT_TRUE(has({1, 0.2, 1})) << "of its front";
  EXPECT_TRUE(has({1, 1.1, 1})) << "of itself";
  EXPECT_TRUE(has({1, 2, 1})) << "of its back";
}

/// A force on each node is one of those of the deck; what holds all of a face holds its middle.
TEST_F(AbaqusTwentyNodes, SetsOfFacesHaveTheirMiddles) {
  const Scene s = scene(deck_of(1, "*BOUNDARY\nfoot, 1, 3\n*CLOAD\nfoot, 3, 2.\n"));
  ASSERT_EQ(s.loads.size(), 1u);
  const Scene most = scene(deck_of(1, "*BOUNDARY\nmost, 1, 3\n", "*NSET, NSET=most\n1, 2, 3, 4, 6, 7, 8\n"));
  EXPECT_EQ(build_model<double>(most).constraints.size(), 3u * 7) << "its middle is free";
  EXPECT_THAT(s.loads[0].nodes.nodes, ElementsAre(1, 2, 3, 4, 6, 7, 8, 9));
  EXPECT_EQ(build_model<double>(s).constraints.size(), 3u * 9);
}

TEST_F(AbaqusTwentyNodes, AreAllInSetsOfNodesOfElements) {
  const Scene s = scene(deck_of(2, "*BOUNDARY\nupper, 1, 3\n*CLOAD\nupper, 3, 2.\n",
                                "*ELSET, ELSET=upper\n11\n*NSET, NSET=upper, ELSET=upper\n"));
  EXPECT_EQ(s.loads.at(0).nodes.nodes.size(), 20u) << "the nodes of the deck alone";
  EXPECT_EQ(build_model<double>(s).constraints.size(), 3u * 27) << "those that it gets, too";
}

TEST_F(AbaqusTwentyNodes, AreWatchedByTheirOwnNumbers) {
  const Scene s = scene(deck_of(1, "*OUTPUT, HISTORY\n*NODE OUTPUT, NSET=foot\nU,\n"));
  EXPECT_EQ(s.probes.size(), 8u);
}

/// Pressure on a face is that on its four quarters: its area, and outwards.
TEST_F(AbaqusTwentyNodes, ArePressedOnFourQuartersOfAFace) {
  const MeshFile mesh = abaqus_mesh(parse_abaqus_deck(deck_of(1), "deck.inp")).file;
  std::map<std::int64_t, Point> place;
  for (std::size_t n = 0; n < mesh.node_ids.size(); ++n) place[mesh.node_ids[n]] = mesh.mesh.nodes[n];
  const Point outwards[6] = {{0, 0, -4}, {0, 0, 4}, {0, -4, 0}, {4, 0, 0}, {0, 4, 0}, {-4, 0, 0}};
  for (int side = 0; side < 6; ++side) {
    const Scene s = scene(deck_of(1, fmt::format("*DLOAD\nall, P{}, 2.\n", side + 1)));
    ASSERT_EQ(s.pressures.at(0).corners.size(), 4u) << side;
    Point sum{};
    for (const auto& face : s.pressures[0].corners) {
      const auto across = [&](int from, int to) {
        return Point{place[face[to]][0] - place[face[from]][0], place[face[to]][1] - place[face[from]][1],
                     place[face[to]][2] - place[face[from]][2]};
      };
      const Point u = across(0, 2), v = across(1, 3);
      const Point area{(u[1] * v[2] - u[2] * v[1]) / 2, (u[2] * v[0] - u[0] * v[2]) / 2,
                       (u[0] * v[1] - u[1] * v[0]) / 2};
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(area[k], outwards[side][k] / 4) << side;
        sum[k] += area[k];
      }
    }
    EXPECT_EQ(sum, outwards[side]);
    EXPECT_EQ(error_of([&] { build_model<double>(s); }), no_error) << side;
    const Scene surface =
        scene(deck_of(1, "*DSLOAD\nside, P, 2.\n", fmt::format("*SURFACE, NAME=side\nall, S{}\n", side + 1)));
    EXPECT_EQ(error_of([&] { build_model<double>(surface); }), no_error) << side;
  }
}

TEST_F(AbaqusTwentyNodes, InAnotherOrderAreRefused) {
  EXPECT_THAT(error(deck_of(1, "", "", 0.8)),
              HasSubstr("node 20 is not near the middle of its edge, from node 19 to 21: expected eight corners"));
  std::string collapsed = deck_of(1);
  const std::size_t at = collapsed.find("10, 1, 3, ");
  collapsed.replace(at, 10, "10, 1, 1, ");
  EXPECT_THAT(error(collapsed), HasSubstr("two of the eight corners of a hexahedron of twenty nodes are the same"));
}

}  // namespace
}  // namespace pinball::test::abaqus_twenty_nodes_test
