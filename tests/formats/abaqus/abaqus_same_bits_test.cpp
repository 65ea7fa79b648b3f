#include <gmock/gmock.h>

#include <solver/base/state_hash.hpp>
#include <solver/formats/lsdyna/scan/fields.hpp>
#include <tests/support/solver_case.hpp>

#include "abaqus_case.hpp"

namespace pinball::test::abaqus_same_bits_test {
namespace {

/// A short plastic bar of 2 x 2 x 4 elements hits another one, as a scene, as an LS-DYNA deck and as Abaqus input.
class SameBits : public AbaqusTest {
 protected:
  static constexpr int across = 2, along = 4;
  static constexpr double width = 1.0, length = 2.0, gap = 0.01, speed = 400.0;

  static std::vector<Point> nodes_of(double bottom) {
    std::vector<Point> nodes;
    for (int k = 0; k <= along; ++k) {
      for (int j = 0; j <= across; ++j) {
        for (int i = 0; i <= across; ++i)
          nodes.push_back({i * width / across, j * width / across, bottom + k * length / along});
      }
    }
    return nodes;
  }
  /// Corners counted from 0.
  static std::vector<std::array<int, 8>> elements_of() {
    std::vector<std::array<int, 8>> elements;
    constexpr int row = across + 1, layer = row * row;
    for (int k = 0; k < along; ++k) {
      for (int j = 0; j < across; ++j) {
        for (int i = 0; i < across; ++i) {
          const int n = k * layer + j * row + i;
          elements.push_back(
              {n, n + 1, n + row + 1, n + row, n + layer, n + layer + 1, n + layer + row + 1, n + layer + row});
        }
      }
    }
    return elements;
  }
  static std::string node_lines(int first, double bottom) {
    std::string text;
    for (const Point& p : nodes_of(bottom)) text += fmt::format("{}, {}, {}, {}\n", first++, p[0], p[1], p[2]);
    return text;
  }
  /// part: behind the number, for LS-DYNA.
  static std::string element_lines(int first, int first_node, const std::string& part) {
    std::string text;
    for (const auto& element : elements_of()) {
      text += fmt::format("{}{}", first++, part);
      for (const int node : element) text += fmt::format(", {}", first_node + node);
      text += '\n';
    }
    return text;
  }

  std::string abaqus_deck() const {
    return "*PART, NAME=bar\n*NODE, NSET=all\n" + node_lines(1, 0.0) + "*ELEMENT, TYPE=C3D8R, ELSET=bar\n" +
           element_lines(1, 1, "") +
           "*SOLID SECTION, ELSET=bar, MATERIAL=steel\n,\n*END PART\n*ASSEMBLY, NAME=a\n"
           "*INSTANCE, NAME=low, PART=bar\n*END INSTANCE\n*INSTANCE, NAME=high, PART=bar\n0., 0., 2.01\n*END INSTANCE\n"
           "*END ASSEMBLY\n" +
           materials + initial + step;
  }
  const std::string materials =
      "*MATERIAL, NAME=steel\n*DENSITY\n8E-9,\n*ELASTIC\n200000., 0.3\n*PLASTIC\n300., 0.\n400., 0.1\n450., 0.5\n";
  const std::string initial = "*INITIAL CONDITIONS, TYPE=VELOCITY\nhigh.all, 3, -400000.\n";
  const std::string step =
      "*SURFACE INTERACTION, NAME=p\n*FRICTION\n0.1,\n*STEP\n*DYNAMIC, EXPLICIT\n, 4E-7\n*CONTACT\n"
      "*CONTACT INCLUSIONS, ALL EXTERIOR\n*CONTACT PROPERTY ASSIGNMENT\n, , p\n*END STEP\n";

  std::uint64_t hash_of(const Scene& scene) {
    Solver<double> solver(scene);
    run_to_end(solver);
    return state_hash(std::as_const(solver).model());
  }
  std::uint64_t hash_of_abaqus(const std::string& deck) { return hash_of(scene(deck)); }
  std::uint64_t hash_of_text(const std::string& text) { return hash_of(read_scene(SceneSource{path_, text, {}})); }
};

TEST_F(SameBits, OfASceneAndAbaqusInput) {
  const std::string scene_text = R"(
time.end = 4e-7
time.cfl = 0.9
contact = { method = "pinball", friction = 0.1 }
[[material]]
name = "steel"
model = "von_mises"
density = 8e-9
young_modulus = 200000.0
poisson_ratio = 0.3
yield_curve = { plastic_strain = [0.0, 0.1, 0.5, 1.5], stress = [300.0, 400.0, 450.0, 450.0] }
[[body]]
name = "low"
material = "steel"
mesh = { type = "block", size = [1.0, 1.0, 2.0], elements = [2, 2, 4] }
[[body]]
name = "high"
material = "steel"
position = [0.0, 0.0, 2.01]
velocity = [0.0, 0.0, -400000.0]
mesh = { type = "block", size = [1.0, 1.0, 2.0], elements = [2, 2, 4] }
)";
  EXPECT_EQ(hash_of_abaqus(abaqus_deck()), hash_of_text(scene_text));
}

TEST_F(SameBits, OfAnLsDynaDeckAndAbaqusInput) {
  const std::string k_deck =
      "*KEYWORD\n*NODE\n" + node_lines(1, 0.0) + node_lines(101, 2.01) + "*ELEMENT_SOLID\n" +
      element_lines(1, 1, ", 1") + element_lines(101, 101, ", 2") +
      "*PART\nlow\n1,1,1\nhigh\n2,1,1\n*SECTION_SOLID\n1,1\n*MAT_PIECEWISE_LINEAR_PLASTICITY\n1,8E-9,200000.,0.3\n\n"
      "0.,0.1,0.5,1.5\n300.,400.,450.,450.\n*CONTROL_TERMINATION\n4E-7\n*CONTROL_HOURGLASS\n6,1.\n"
      "*CONTROL_BULK_VISCOSITY\n1.44,0.06\n*INITIAL_VELOCITY_GENERATION\n2,2,0.,0.,0.,-400000.\n\n"
      "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0\n0.1,0.1\n*END\n";
  const std::string path = (folder_ / "deck.k").string();
  std::ofstream(path) << k_deck;
  const Scene as_scene = read_scene(translate_deck(path).source(path));
  EXPECT_EQ(hash_of_abaqus(abaqus_deck()), hash_of(as_scene));
}

std::string all_replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
  return text;
}

TEST_F(SameBits, WhateverTheOrderTheCaseAndTheLineEnds) {
  const std::uint64_t hash = hash_of_abaqus(abaqus_deck());
  EXPECT_EQ(hash_of_abaqus(materials + all_replaced(abaqus_deck(), materials, "")), hash);
  EXPECT_EQ(hash_of_abaqus(all_replaced(abaqus_deck(), "\n", "\r\n")), hash);
  EXPECT_EQ(hash_of_abaqus(lower_case(abaqus_deck())), hash);
  EXPECT_EQ(hash_of_abaqus(all_replaced(abaqus_deck(), "\n", "\n** a comment\n")), hash);
}

/// Without parts: one deck of two bodies, with other numbers for its nodes and elements.
TEST_F(SameBits, WithoutPartsAndWithOtherNumbers) {
  const std::string flat = "*NODE\n" + node_lines(5000, 0.0) + "*ELEMENT, TYPE=C3D8R, ELSET=low\n" +
                           element_lines(77, 5000, "") + "*NODE, NSET=ALL\n" + node_lines(200, 2.01) +
                           "*ELEMENT, TYPE=C3D8R, ELSET=high\n" + element_lines(3, 200, "") +
                           "*SOLID SECTION, ELSET=low, MATERIAL=steel\n*SOLID SECTION, ELSET=high, MATERIAL=steel\n" +
                           materials + all_replaced(initial, "high.all", "all") + step;
  EXPECT_EQ(hash_of_abaqus(flat), hash_of_abaqus(abaqus_deck()));
}

}  // namespace
}  // namespace pinball::test::abaqus_same_bits_test
