#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>

#include <solver/model/model.hpp>
#include <tests/formats/ten_nodes_case.hpp>

#include "abaqus_case.hpp"

/// A deck with tetrahedra of ten nodes as a scene: two of them (ten_nodes_case.hpp), 10 and 11.
namespace pinball::test::abaqus_ten_nodes_test {
namespace {

using testing::HasSubstr;

std::string deck_of(const std::string& type, const std::string& in_step = "", const std::string& more = "") {
  return "*NODE\n" + ten_nodes_lines() + "*ELEMENT, TYPE=" + type + ", ELSET=both\n10, " +
         joined(ten_nodes_elements[0]) + "\n11, " + joined(ten_nodes_elements[1]) +
         "\n*SOLID SECTION, ELSET=both, MATERIAL=Steel\n,\n" + more + abaqus_steel + abaqus_step(in_step);
}

class AbaqusTenNodes : public AbaqusTest {};

TEST_F(AbaqusTenNodes, HaveTheirMassAtAllNodes) {
  for (const char* type : {"C3D10", "C3D10M", "C3D10H", "C3D10MH"}) {
    const Model<double> model = build_model<double>(scene(deck_of(type)));
    const double mass = 7.85e-9 * (1.0 / 6 + 1.0 / 3);
    EXPECT_EQ(model.element_count(), 16);
    EXPECT_EQ(model.node_mass.size(), 14u);
    EXPECT_NEAR(std::accumulate(model.node_mass.begin(), model.node_mass.end(), 0.0), mass, 1e-14 * mass);
    // The first corner has a quarter of one of eight.
    const auto lightest = *std::ranges::min_element(model.node_mass);
    EXPECT_NEAR(lightest, 7.85e-9 / 6 / 8 / 4, 1e-14 * mass);
  }
  EXPECT_THAT(translate(deck_of("C3D10M")).understood,
              testing::IsSupersetOf({HasSubstr("2 tetrahedra of ten nodes, each as eight of four nodes"),
                                     HasSubstr("both: tetrahedra with volumes averaged over nodes")}));
}

/// Pressure on a face is that on its four triangles: twice its area, and outwards.
TEST_F(AbaqusTenNodes, ArePressedOnFourTrianglesOfAFace) {
  std::map<std::int64_t, Point> place(ten_nodes_nodes.begin(), ten_nodes_nodes.end());
  const Point twice[2][4] = {{{0, 0, -1}, {0, -1, 0}, {1, 1, 1}, {-1, 0, 0}},
                             {{-1, -1, -1}, {1, 1, -1}, {-1, 1, 1}, {1, -1, 1}}};
  for (int element = 0; element < 2; ++element) {
    for (int side = 0; side < 4; ++side) {
      const Scene s = scene(deck_of("C3D10", fmt::format("*DLOAD\n{}, P{}, 2.\n", 10 + element, side + 1)));
      ASSERT_EQ(s.pressures.size(), 1u);
      ASSERT_EQ(s.pressures[0].corners.size(), 4u);
      Point sum{};
      for (const auto& face : s.pressures[0].corners) {
        EXPECT_EQ(face[2], face[3]);
        Point u, v;
        for (std::size_t k = 0; k < 3; ++k) {
          u[k] = place[face[1]][k] - place[face[0]][k];
          v[k] = place[face[2]][k] - place[face[0]][k];
        }
        const Point area{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
        for (std::size_t k = 0; k < 3; ++k) {
          EXPECT_EQ(area[k], twice[element][side][k] / 4);
          sum[k] += area[k];
        }
      }
      EXPECT_EQ(sum, twice[element][side]);
      if (element == 0 && side == 2) continue;  // the face that both have
      if (element == 1 && side == 0) continue;
      EXPECT_EQ(error_of([&] { build_model<double>(s); }), no_error);
    }
  }
}

TEST_F(AbaqusTenNodes, OfASetArePressedOnce) {
  const Scene s = scene(deck_of("C3D10", "*DLOAD\nboth, P2, 2.\n"));
  EXPECT_EQ(s.pressures.at(0).corners.size(), 8u);
}

TEST_F(AbaqusTenNodes, BesideHexahedraKeepTheirPlaces) {
  const auto cube = [](int number, int first, double height) {
    return "*NODE\n" + square_lines(first, height) + square_lines(first + 4, height + 1) +
           fmt::format("*ELEMENT, TYPE=C3D8R, ELSET=cubes\n{}, {}", number, first) +
           fmt::format(", {}, {}, {}, {}, {}, {}, {}\n", first + 1, first + 2, first + 3, first + 4, first + 5,
                       first + 6, first + 7);
  };
  const std::string deck =
      cube(1, 101, 5) +
      deck_of("C3D10", "*DLOAD\n2, P2, 3.\ncubes, P1, 4.\nboth, P4, 5.\n",
              cube(2, 201, 8) + "*SOLID SECTION, ELSET=cubes, MATERIAL=Steel\n,\n*SURFACE, NAME=s\n2, S1\n11, S2\n");
  const Scene s = scene(deck);
  EXPECT_EQ(s.bodies.size(), 2u);
  const auto lengths = [&](std::size_t p) { return s.pressures.at(p).corners.size(); };
  EXPECT_EQ(lengths(0), 1u);
  EXPECT_THAT(s.pressures[0].corners[0], testing::UnorderedElementsAre(205, 206, 207, 208));
  EXPECT_EQ(lengths(1), 2u);
  EXPECT_EQ(lengths(2), 8u);
  const Model<double> model = build_model<double>(s);
  EXPECT_EQ(model.element_count(), 18);
  EXPECT_NEAR(std::accumulate(model.node_mass.begin(), model.node_mass.end(), 0.0), 7.85e-9 * 2.5, 1e-22);
}

}  // namespace
}  // namespace pinball::test::abaqus_ten_nodes_test
