#include <gmock/gmock.h>

#include <solver/scene_rules.hpp>
#include <tests/formats/lsdyna/deck_case.hpp>
#include <tests/formats/lsdyna/own_deck.hpp>

/// What *DATABASE keywords ask for: bodies, forces, nodes and solids, sets of them.
namespace pinball::test::deck_output_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class DeckOutput : public DeckTest {
 protected:
  std::vector<std::string> names_of_probes(const std::string& database) {
    return names_of(scene(cube + elastic + ends + set_of_top + "*SET_SOLID_LIST\n4\n10\n" + database).probes);
  }
};

TEST_F(DeckOutput, NodesAndSolidsAreWatchedByTheirNumbers) {
  EXPECT_THAT(names_of_probes("*DATABASE_HISTORY_NODE\n7,2\n*DATABASE_HISTORY_SOLID\n10\n"),
              ElementsAre("node_7", "node_2", "element_10"));
  EXPECT_THAT(names_of_probes("*DATABASE_HISTORY_NODE_ID\n7,left\n2,right\n"), ElementsAre("node_7", "node_2"));
  const Scene s = scene(cube + elastic + ends + "*DATABASE_HISTORY_NODE\n7\n*DATABASE_HISTORY_SOLID\n10\n");
  const Simulation simulation(s);
  EXPECT_EQ(simulation.probes()[0].point, (Point{1, 1, 1}));
  EXPECT_EQ(simulation.probes()[1].point, (Point{0.5, 0.5, 0.5}));
  EXPECT_TRUE(simulation.probes()[1].element);
}

TEST_F(DeckOutput, SetsAreWatchedMemberByMemberAndEachOnce) {
  EXPECT_THAT(names_of_probes("*DATABASE_HISTORY_NODE\n6\n*DATABASE_HISTORY_NODE_SET\n3\n"),
              ElementsAre("node_6", "node_5", "node_7", "node_8"));
  EXPECT_THAT(names_of_probes("*DATABASE_HISTORY_SOLID_SET\n4\n"), ElementsAre("element_10"));
}

TEST_F(DeckOutput, UnknownNumbersAreNamedWithTheirLine) {
  const std::string deck = cube + elastic + ends;
  EXPECT_EQ(error(deck + "*DATABASE_HISTORY_NODE\n9\n"), "deck.k:23: *DATABASE_HISTORY_NODE: node 9 is not there");
  EXPECT_EQ(error(deck + "*DATABASE_HISTORY_SOLID\n11\n"),
            "deck.k:23: *DATABASE_HISTORY_SOLID: element 11 is not there");
  EXPECT_EQ(error(deck + "*DATABASE_HISTORY_SOLID_SET\n5\n"),
            "deck.k:23: *DATABASE_HISTORY_SOLID_SET: there is no set 5 of elements");
}

TEST_F(DeckOutput, ForcesHaveNames) {
  const std::string deck = cube + elastic + ends + set_of_top +
                           "*BOUNDARY_SPC_NODE\n1,0,1,1,1\n*DEFINE_CURVE\n5\n0.,1.\n1.,1.\n"
                           "*BOUNDARY_PRESCRIBED_MOTION_SET\n3,3,0,5\n*BOUNDARY_PRESCRIBED_MOTION_NODE\n2,1,0,5\n";
  EXPECT_EQ(scene(deck).fixed_constraints[0].name, "");
  const Scene s = scene(deck + "*DATABASE_SPCFORC\n1.E-7\n*DATABASE_BNDOUT\n2.E-7\n");
  EXPECT_EQ(s.fixed_constraints[0].name, "spc");
  EXPECT_THAT(names_of(s.prescribed_velocities), ElementsAre("motion_1", "motion_2"));
  EXPECT_EQ(s.output.interval, 1e-7);
  EXPECT_FALSE(s.output.body_energies);
}

TEST_F(DeckOutput, MatsumAsksForEachBody) {
  EXPECT_TRUE(scene(cube + elastic + ends + "*DATABASE_MATSUM\n1.E-7\n").output.body_energies);
}

/// Two parts of one mesh have the nodes between them in common: each has its half of their masses.
TEST(DeckBodies, ThatShareNodesAddUpToTheTotals) {
  Scene scene = scene_of_deck(own_deck("velocities.k"));
  scene.output.body_energies = true;
  Simulation s(scene);
  while (s.step()) {
    const HistoryRow row = s.history_row();
    const std::size_t first = row.more.size() - 16;
    const auto both = [&](std::size_t i) { return row.more[first + i] + row.more[first + 8 + i]; };
    EXPECT_EQ(s.history_columns()[first].substr(s.history_columns()[first].find('_')), "_kinetic");
    EXPECT_NEAR(both(0), row.energy.kinetic, 1e-12 * row.energy.kinetic);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(both(1 + k), row.momentum[k], 1e-12 * std::abs(row.momentum[2]));
    EXPECT_NEAR(row.more[first + 4], row.bodies[0].mass_initial, 1e-12 * row.bodies[0].mass_initial);
    EXPECT_NEAR(both(5), row.energy.internal, 1e-12 * (row.energy.internal + row.energy.kinetic));
  }
}

class ProbesByNumber : public DeckTest {
 protected:
  /// Of a scene with the cube as its mesh file, twice if asked for.
  std::string scene_with(const std::string& probe, bool twice = false) {
    std::ofstream(path_) << "*KEYWORD\n" << cube << "*END\n";
    std::ofstream(folder_ / "other.k") << "*KEYWORD\n" << cube << "*END\n";
    std::string text =
        "[time]\nend = 1e-6\n[[material]]\nname = \"m\"\nmodel = \"elastic\"\ndensity = 1e-9\nyoung_modulus = 1.0\n"
        "poisson_ratio = 0.3\n[[body]]\nname = \"a\"\nmaterial = \"m\"\nmesh = { type = \"keyword\", file = \"deck.k\" "
        "}\n";
    if (twice)
      text +=
          "[[body]]\nname = \"b\"\nmaterial = \"m\"\nposition = [3, 0, 0]\n"
          "mesh = { type = \"keyword\", file = \"other.k\" }\n"
          "[[body]]\nname = \"c\"\nmaterial = \"m\"\nposition = [6, 0, 0]\n"
          "mesh = { type = \"block\", size = [1, 1, 1], elements = [1, 1, 1] }\n";
    return text + "[[probe]]\nname = \"p\"\n" + probe;
  }
  Scene read(const std::string& text) { return read_scene(SceneSource{(folder_ / "s.toml").string(), text, {}}); }
  std::string error_of_probe(const std::string& probe, bool twice = false) {
    return without_folder(error_of([&] { const Simulation simulation(read(scene_with(probe, twice))); }));
  }
};

TEST_F(ProbesByNumber, WatchWhatTheMeshFileCallsSo) {
  const Simulation one(read(scene_with("node = 3\n")));
  EXPECT_EQ(one.probes()[0].point, (Point{1, 1, 0}));
  const Simulation two(read(scene_with("element = 10\nbody = \"b\"\n", true)));
  EXPECT_EQ(two.probes()[0].point, (Point{3.5, 0.5, 0.5}));
  EXPECT_EQ(two.probes()[0].body, "b");
}

TEST_F(ProbesByNumber, ErrorsSayWhere) {
  EXPECT_EQ(error_of_probe("node = 9\n"), "s.toml:13:1: probe.p: deck.k has no node 9 that a body uses");
  EXPECT_THAT(error_of_probe("element = 9\n"), HasSubstr("s.toml:13:1: probe.p: deck.k has no element 9"));
  EXPECT_THAT(error_of_probe("node = 3\n", true), HasSubstr("there are several"));
  EXPECT_THAT(error_of_probe("node = 3\nbody = \"c\"\n", true), HasSubstr("its body is from none"));
  EXPECT_THAT(error_of_probe("node = 3\npoint = [0, 0, 0]\n"),
              HasSubstr("expected only one of point, node and element"));
  EXPECT_THAT(error_of_probe("node = 3\nkind = \"element\"\n"), HasSubstr("probe.p.kind"));
  EXPECT_THAT(error_of_probe(""), HasSubstr("point: missing"));
}

}  // namespace
}  // namespace pinball::test::deck_output_test
