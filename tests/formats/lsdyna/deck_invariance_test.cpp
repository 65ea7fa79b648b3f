#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <random>

#include "deck_case.hpp"
#include "own_deck.hpp"

namespace pinball::test::deck_invariance_test {
namespace {

struct DeckNode {
  int id;
  Point x;
};
struct DeckSolid {
  int id, part;
  std::array<int, 8> nodes;
};

/// Two blocks of 3 x 3 x 4 solids, of which the upper one falls onto the lower one, which a wall holds: nodes and
/// solids by their numbers, and the other keywords in blocks.
struct Collision {
  std::vector<DeckNode> nodes;
  std::vector<DeckSolid> solids;
  std::vector<std::string> blocks;
  std::array<double, 3> units{1, 1, 1};  ///< what a new unit of length, time and mass is in old ones

  explicit Collision(std::array<double, 3> u = {1, 1, 1}) : units(u) {
    for (int part = 1; part <= 2; ++part) add_block(part);
    const double stress = 1 / mass() * length() * time() * time(), velocity = time() / length();
    blocks = {"*PART\nlower\n1,1,1\n",
              "*PART\nupper\n2,1,2\n",
              "*SECTION_SOLID\n1,1\n",
              fmt::format("*MAT_ELASTIC\n1,{},{},0.3\n", density(), 7e4 * stress),
              fmt::format("*MAT_PLASTIC_KINEMATIC\n2,{},{},0.3,{},{},1.0\n", density(), 7e4 * stress, 300 * stress,
                          700 * stress),
              fmt::format("*INITIAL_VELOCITY_GENERATION\n2,2,0,{},0.,{}\n\n", 2 * velocity, -20 * velocity),
              fmt::format("*RIGIDWALL_PLANAR\n0\n0.,0.,{},0.,0.,1.,0.2\n", -0.01 / length()),
              "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n1,2,3,3\n0.2,0.2\n",
              "*CONTROL_HOURGLASS\n4,0.05\n",
              fmt::format("*CONTROL_TERMINATION\n{}\n", 0.02 / time()),
              "*CONTROL_TIMESTEP\n0.,0.8\n"};
  }

  double length() const { return units[0]; }
  double time() const { return units[1]; }
  double mass() const { return units[2]; }
  double density() const { return 2.7e-3 / mass() * std::pow(length(), 3); }

  void add_block(int part) {
    const int first = part == 1 ? 1 : 1001;
    const double z0 = part == 1 ? 0 : 4.003;
    const auto node = [first](int i, int j, int k) { return first + i + 4 * (j + 4 * k); };
    for (int k = 0; k <= 4; ++k) {
      for (int j = 0; j <= 3; ++j) {
        for (int i = 0; i <= 3; ++i)
          nodes.push_back(
              {node(i, j, k), {(i + 0.13 * part) / length(), (j + 0.07 * part) / length(), (z0 + k) / length()}});
      }
    }
    for (int k = 0; k < 4; ++k) {
      for (int j = 0; j < 3; ++j) {
        for (int i = 0; i < 3; ++i)
          solids.push_back(
              {first + i + 3 * (j + 3 * k),
               part,
               {node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k), node(i, j + 1, k), node(i, j, k + 1),
                node(i + 1, j, k + 1), node(i + 1, j + 1, k + 1), node(i, j + 1, k + 1)}});
      }
    }
  }

  std::string mesh() const { return mesh_of_nodes() + mesh_of_solids(); }
  std::string mesh_of_nodes() const {
    std::string text = "*NODE\n";
    for (const DeckNode& n : nodes) text += fmt::format("{},{},{},{}\n", n.id, n.x[0], n.x[1], n.x[2]);
    return text;
  }
  std::string mesh_of_solids() const {
    std::string text = "*ELEMENT_SOLID\n";
    for (const DeckSolid& s : solids) text += fmt::format("{},{},{}\n", s.id, s.part, fmt::join(s.nodes, ","));
    return text;
  }
  std::string text() const { return mesh() + fmt::format("{}", fmt::join(blocks, "")); }
};

class DeckInvariance : public DeckTest {
 protected:
  Simulation run(const std::string& text) {
    Simulation s(scene(text));
    s.run();
    return s;
  }
  std::uint64_t hash(const std::string& text) { return run(text).state_hash(); }

  std::mt19937 random_{19};
};

TEST_F(DeckInvariance, OrderOfKeywordsChangesNoBit) {
  Collision c;
  const std::uint64_t expected = hash(c.text());
  for (int i = 0; i < 4; ++i) {
    std::shuffle(c.blocks.begin(), c.blocks.end(), random_);
    EXPECT_EQ(hash(fmt::format("{}{}", fmt::join(c.blocks, ""), c.mesh())), expected);
    EXPECT_EQ(hash(fmt::format("{}{}{}", c.mesh_of_solids(), fmt::join(c.blocks, ""), c.mesh_of_nodes())), expected);
  }
}

TEST_F(DeckInvariance, FormOfCardsChangesNoBit) {
  const Collision c;
  const std::uint64_t expected = hash(c.text());
  std::string windows = c.text(), commented;
  for (std::size_t at = windows.find('\n'); at != std::string::npos; at = windows.find('\n', at + 2))
    windows.insert(at, "\r");
  EXPECT_EQ(hash(windows), expected);
  std::string lower = c.text();
  for (std::size_t at = lower.find('*'); at != std::string::npos; at = lower.find('*', at + 1))
    for (std::size_t i = at; lower[i] != '\n'; ++i) lower[i] = static_cast<char>(std::tolower(lower[i]));
  EXPECT_EQ(hash(lower), expected);
  std::string parameters = c.text();
  parameters.replace(parameters.find("0.02\n"), 4, "&end");
  EXPECT_EQ(hash("*PARAMETER\nR end, 0.02\n" + parameters), expected);
}

TEST_F(DeckInvariance, ColumnsAndFilesChangeNoBit) {
  Collision c;
  for (DeckNode& n : c.nodes) {
    for (double& x : n.x) x = std::stod(fmt::format("{:.6f}", x));
  }
  const std::uint64_t expected = hash(c.text());
  std::string columns = "*NODE\n";
  for (const DeckNode& n : c.nodes)
    columns += fmt::format("{:8d}{:16.6f}{:16.6f}{:16.6f}\n", n.id, n.x[0], n.x[1], n.x[2]);
  columns += "*ELEMENT_SOLID\n";
  for (const DeckSolid& s : c.solids) {
    columns += fmt::format("{:8d}{:8d}\n", s.id, s.part);
    for (const int node : s.nodes) columns += fmt::format("{:8d}", node);
    columns += "       0       0\n";
  }
  const std::string others = fmt::format("{}", fmt::join(c.blocks, ""));
  EXPECT_EQ(hash(columns + others), expected);
  std::ofstream(folder_ / "mesh.k") << columns;
  std::ofstream(folder_ / "others.k") << others;
  EXPECT_EQ(hash("*INCLUDE\nothers.k\nmesh.k\n"), expected);
}

/// Other numbers for the nodes and solids that stand in the same order: nothing but the numbers changes.
TEST_F(DeckInvariance, NumbersOfNodesAndSolidsChangeNoBit) {
  Collision c;
  const std::uint64_t expected = hash(c.text());
  std::vector<int> number(2000);
  std::iota(number.begin(), number.end(), 1);
  std::shuffle(number.begin(), number.end(), random_);
  for (DeckNode& n : c.nodes) n.id = number[n.id];
  for (DeckSolid& s : c.solids) {
    s.id = number[s.id];
    for (int& node : s.nodes) node = number[node];
  }
  EXPECT_EQ(hash(c.text()), expected);
}

/// Steps, energies and velocities of bodies but for round-off. energy, velocity: what units of the first are in those
/// of the second.
void expect_same_but_round_off(const Simulation& s, const Simulation& expected, double energy = 1,
                               double velocity = 1) {
  EXPECT_EQ(s.steps(), expected.steps());
  EXPECT_NEAR(s.energies().internal * energy / expected.energies().internal, 1, 1e-10);
  EXPECT_NEAR(s.energies().kinetic * energy / expected.energies().kinetic, 1, 1e-10);
  for (std::size_t b = 0; b < 2; ++b) {
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(s.bodies()[b].velocity[k] * velocity, expected.bodies()[b].velocity[k], 1e-10 * 20) << b << k;
  }
}

/// The order of nodes and solids is that in which sums are made: with another one they differ by round-off.
TEST_F(DeckInvariance, OrderWithinAMeshChangesRoundOffAlone) {
  Collision c;
  const Simulation expected = run(c.text());
  for (int i = 0; i < 2; ++i) {
    std::shuffle(c.nodes.begin(), c.nodes.end(), random_);
    std::shuffle(c.solids.begin(), c.solids.end(), random_);
    expect_same_but_round_off(run(c.text()), expected);
  }
}

/// mm, ms, g and MPa; m, s and kg; and mm, s and t.
TEST_F(DeckInvariance, UnitsChangeRoundOffAlone) {
  const Simulation expected = run(Collision().text());
  for (const std::array<double, 3> units : {std::array{1e3, 1e3, 1e3}, std::array{1.0, 1e3, 1e6}}) {
    const Collision c(units);
    const double velocity = c.length() / c.time();
    expect_same_but_round_off(run(c.text()), expected, c.mass() * velocity * velocity, velocity);
  }
}

/// Mesh, parts and materials in m, s and kg, or in mm, s and t, included by a deck in mm, ms, g and MPa.
TEST_F(DeckInvariance, UnitsOfAnIncludedFileChangeRoundOffAlone) {
  const Collision own;
  const Simulation expected = run(own.text());
  constexpr std::ptrdiff_t parts_and_materials = 5;
  const std::string others =
      fmt::format("{}", fmt::join(own.blocks.begin() + parts_and_materials, own.blocks.end(), ""));
  for (const std::array<double, 3> units : {std::array{1e3, 1e3, 1e3}, std::array{1.0, 1e3, 1e6}}) {
    const Collision c(units);
    std::ofstream(folder_ / "bodies.k") << c.mesh()
                                        << fmt::format("{}", fmt::join(c.blocks.begin(),
                                                                       c.blocks.begin() + parts_and_materials, ""));
    const std::string included =
        fmt::format("*INCLUDE_TRANSFORM\nbodies.k\n\n\n{},{},{}\n\n", c.mass(), c.time(), c.length());
    expect_same_but_round_off(run(others + included), expected);
  }
}

}  // namespace
}  // namespace pinball::test::deck_invariance_test
