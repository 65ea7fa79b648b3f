#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include <solver/base/error.hpp>
#include <solver/formats/deck_reader.hpp>
#include <solver/program/others/last_state.hpp>
#include <solver/program/others/other_history.hpp>
#include <solver/program/others/watched_numbers.hpp>
#include <solver/simulation.hpp>
#include <tests/formats/abaqus/abaqus_case.hpp>
#include <tests/support/error_of.hpp>
#include <tests/support/output_case.hpp>
#include <tests/support/program.hpp>

#include "other_history_case.hpp"

/// What CalculiX writes as text beside a run: its .dat.
namespace pinball::calculix_dat_test {
namespace {

using Json = nlohmann::json;
using test::error_of;
using test::Finished;
using test::run;
using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

std::string table(const std::string& words, const std::string& set, double time, const std::string& rows) {
  return fmt::format("\n {} for set {} and time {:14.7E}\n\n{}", words, set, time, rows);
}
std::string node_row(std::int64_t number, const Point& v) {
  return fmt::format("{:10} {:13.6E} {:13.6E} {:13.6E}\n", number, v[0], v[1], v[2]);
}

class CalculixDat : public test::OtherHistories {
 protected:
  OtherHistory read(const std::string& text) const { return read_other_history(write("deck.dat", text)); }
  static std::vector<double> values(const OtherHistory& history, const std::string& name) {
    return curve(history, name).values;
  }
};

TEST_F(CalculixDat, HasNodesSetsAndMeansOverIntegrationPoints) {
  std::string text =
      "\n                        S T E P       1\n\n\n                                INCREMENT     1\n\n";
  for (const double time : {1e-6, 2e-6}) {
    text += table("displacements (vx,vy,vz)", "NALL", time,
                  node_row(1, {time, 0, 0}) + node_row(17, {0, 2 * time, -3 * time})) +
            table("velocities (vx,vy,vz)", "NALL", time, node_row(17, {4, 5, 6})) +
            table("total force (fx,fy,fz)", "BASE", time, "        1.000000E+00  2.000000E+00 -3.000000E+00\n") +
            table("stresses (elem, integ.pnt.,sxx,syy,szz,sxy,sxz,syz)", "EALL", time,
                  "         5   1  1.0E+00  2.0E+00  3.0E+00  4.0E+00  5.0E+00  6.0E+00\n"
                  "         5   2  3.0E+00  2.0E+00  3.0E+00  4.0E+00  7.0E+00  6.0E+00\n"
                  "         6   1  9.0E+00  0.0E+00  0.0E+00  0.0E+00  0.0E+00  0.0E+00\n") +
            table("equivalent plastic strain (elem, integ.pnt.,pe)", "EALL", time, "         5   1  1.0E-02\n") +
            table("volume (element, volume)", "EALL", time, "         5  1.0E-02\n");
  }
  const OtherHistory h = read(text);
  EXPECT_EQ(h.kind, "dat of CalculiX");
  EXPECT_THAT(h.times, ElementsAre(1e-6, 2e-6));
  EXPECT_THAT(values(h, "node_1_displacement_x"), ElementsAre(1e-6, 2e-6));
  EXPECT_THAT(values(h, "node_17_displacement_z"), ElementsAre(-3e-6, -6e-6));
  EXPECT_THAT(values(h, "node_17_velocity_y"), ElementsAre(5, 5));
  EXPECT_THAT(values(h, "BASE_force_z"), ElementsAre(-3, -3));
  EXPECT_THAT(values(h, "element_5_stress_xx"), ElementsAre(2, 2));
  EXPECT_THAT(values(h, "element_5_stress_zx"), ElementsAre(6, 6));  // CalculiX has xz before yz
  EXPECT_THAT(values(h, "element_5_stress_yz"), ElementsAre(6, 6));
  EXPECT_THAT(values(h, "element_6_stress_xx"), ElementsAre(9, 9));
  EXPECT_THAT(values(h, "element_5_plastic_strain"), ElementsAre(1e-2, 1e-2));
  EXPECT_EQ(h.curves.size(), 3 + 6 + 3 + 12 + 1);
}

TEST_F(CalculixDat, OneTimeIsEnoughAndRowsInALocalSystemAreLeftOut) {
  const OtherHistory h = read(
      table("displacements (vx,vy,vz)", "N", 1, node_row(1, {1, 2, 3}) + "         2  1.0E+00  2.0E+00  3.0E+00 L\n"));
  EXPECT_THAT(h.times, ElementsAre(1));
  EXPECT_EQ(h.curves.size(), 3);
}

TEST_F(CalculixDat, WhatIsNoRowIsNamedWithItsLine) {
  const auto problem = [&](const std::string& text) { return error_of([&] { read(text); }); };
  EXPECT_THAT(problem(table("displacements (vx,vy,vz)", "N", 1, "         1  1.0E+00  2.0E+00\n")),
              HasSubstr("deck.dat:4: expected a row of displacements: 4 numbers, got '1  1.0E+00  2.0E+00'"));
  EXPECT_THAT(problem(table("displacements (vx,vy,vz)", "N", 1, "       1.5  1.0E+00  2.0E+00  1.0\n")),
              HasSubstr("expected a row of displacements"));
  EXPECT_THAT(problem("\n displacements (vx,vy,vz) for set N and time soon\n"),
              HasSubstr("deck.dat:2: expected a time behind 'and time', got 'soon'"));
}

/// Of node 1 moved by 3 along x, node 2 by 4 along y, and a number that two files give.
LastState moved() {
  FieldSnapshot snapshot;
  snapshot.time = 2;
  snapshot.position = {{3, 0, 0}, {1, 4, 0}, {5, 5, 5}, {6, 6, 6}};
  snapshot.velocity = {{1, 0, 0}, {0, 0, 0}, {}, {}};
  const std::vector<Point> initial{{0, 0, 0}, {1, 0, 0}, {}, {}};
  return last_state(snapshot, {initial, {1, 2, 7, 7}, {}});
}

OtherHistory nodes_there(const std::vector<double>& times, double of_2) {
  OtherHistory other{"", "", times, {}};
  for (const auto& [name, value] : {std::pair{"node_1_displacement_x", 3.0},
                                    {"node_1_displacement_y", 0.0},
                                    {"node_1_displacement_z", 0.0},
                                    {"node_2_displacement_x", 0.0},
                                    {"node_2_displacement_y", of_2},
                                    {"node_2_displacement_z", 0.0},
                                    {"node_7_displacement_x", 9.0},
                                    {"node_7_displacement_y", 9.0},
                                    {"node_7_displacement_z", 9.0},
                                    {"node_8_displacement_x", 9.0}}) {
    OtherCurve& curve = other.curves.emplace_back(OtherCurve{name, {}, {}});
    for (const double time : times) curve.values.push_back(value * time / 2);
  }
  return other;
}

TEST(LastStates, DifferencesOfNodesAreThoseOfTheirVectors) {
  for (const std::vector<double>& times : {std::vector{0.0, 2.0}, {1.0, 3.0}, {2.0 - 1e-6}}) {
    const std::vector<StateDifference> all = state_differences(moved(), nodes_there(times, 5));
    ASSERT_EQ(all.size(), 1U);
    EXPECT_EQ(all[0].quantity, "displacement");
    EXPECT_EQ(all[0].nodes, 2);
    EXPECT_NEAR(all[0].scale, 5, 1e-5);
    EXPECT_NEAR(*all[0].largest, 0.2, 1e-5);
    EXPECT_EQ(all[0].largest_node, 2);
    EXPECT_NEAR(*all[0].root_mean_square, 0.2 / std::sqrt(2), 1e-5);
  }
  EXPECT_TRUE(state_differences(moved(), nodes_there({0, 1.9}, 5)).empty());
  EXPECT_TRUE(state_differences(moved(), nodes_there({2.1, 3}, 5)).empty());
}

/// A cube of Abaqus input that is pulled at its top, as CalculiX would read it.
std::string deck_of_cube() {
  return test::abaqus_cube + test::abaqus_steel +
         "*BOUNDARY\nbase, 1, 3\n*INITIAL CONDITIONS, TYPE=VELOCITY\ntop, 3, 5000.\n" + test::abaqus_step();
}

TEST_F(CalculixDat, NodesAndElementsAreLaidBesideTheRunByTheirNumbers) {
  const std::string deck = write("deck.inp", deck_of_cube());
  Simulation simulation(read_scene(translate_any_deck(deck, {}).source(deck)));
  simulation.run();
  const LastState end = last_state(simulation.snapshot(), simulation.field_base());
  ASSERT_EQ(end.numbers.size(), 8U);
  std::string nodes, wrong;
  for (std::size_t i = 0; i < 8; ++i) {
    Point there = end.displacements[i];
    nodes += node_row(end.numbers[i], there);
    for (double& component : there) component *= end.numbers[i] == 7 ? 1.25 : 1.0;
    wrong += node_row(end.numbers[i], there);
  }
  const std::array<double, 6> s = simulation.snapshot().stress[0];
  const std::string stress =
      fmt::format("        10   1 {:.6E} {:.6E} {:.6E} {:.6E} {:.6E} {:.6E}\n", s[0], s[1], s[2], s[3], s[5], s[4]);
  const auto beside = [&](const std::string& rows) {
    const std::string dat =
        write("deck.dat", table("displacements (vx,vy,vz)", "NALL", end.time, rows) +
                              table("stresses (elem, integ.pnt.,sxx,syy,szz,sxy,sxz,syz)", "EALL", end.time, stress));
    const std::string json_file = folder_ / "table.json";
    const Finished f = run("compare " + deck + " --quiet --threads 1 --with " + dat + " --json " + json_file);
    EXPECT_EQ(f.status, 0) << f.text;
    EXPECT_THAT(f.text, HasSubstr("last state"));
    EXPECT_THAT(f.text, Not(HasSubstr("not compared")));
    return Json::parse(test::content(json_file))["beside"][0];
  };
  const Json same = beside(nodes), other = beside(wrong);
  EXPECT_EQ(same["last_state"][0]["displacement"]["nodes"], 8);
  EXPECT_LT(same["last_state"][0]["displacement"]["largest_difference"], 1e-5);
  EXPECT_THAT(other["last_state"][0]["displacement"]["largest_difference"].get<double>(), DoubleNear(0.2, 1e-3));
  EXPECT_EQ(other["last_state"][0]["displacement"]["largest_node"], 7);
  std::size_t stresses = 0;
  for (const Json& quantity : same["quantities"]) {
    const Json& share = quantity["variants"][0]["difference"];
    EXPECT_TRUE(share.is_null() || std::abs(share.get<double>()) < 1e-4) << quantity;
    stresses += quantity["name"].get<std::string>().starts_with("element_10_stress");
  }
  EXPECT_EQ(stresses, 6U);
}

TEST_F(CalculixDat, OfManyNodesSomeAreWatchedEvenly) {
  const auto others = [&](int nodes) {
    std::string rows;
    for (int i = 1; i <= nodes; ++i) rows += node_row(i, {});
    return std::vector{read(table("displacements (vx,vy,vz)", "N", 1, rows + node_row(99999999, {})))};
  };
  const std::string deck = PINBALL_SOURCE_DIR "/data/decks/taylor_bar.k";
  Scene scene = read_scene(translate_any_deck(deck, {}).source(deck));
  scene.probes.clear();
  EXPECT_TRUE(watch_numbers(others(8), scene).empty());
  ASSERT_EQ(scene.probes.size(), 8U);  // the last one is no node of the deck
  EXPECT_EQ(scene.probes[7].name, "node_8");
  EXPECT_TRUE(watch_numbers(others(8), scene).empty());
  EXPECT_EQ(scene.probes.size(), 8U);
  scene.probes.clear();
  EXPECT_THAT(watch_numbers(others(91), scene),
              ElementsAre("histories of 10 of 91 nodes that the other programs have by number"));
  ASSERT_EQ(scene.probes.size(), 10U);
  for (int i = 0; i < 10; ++i) EXPECT_EQ(scene.probes[i].number, 1 + 10 * i);
}

}  // namespace
}  // namespace pinball::calculix_dat_test
