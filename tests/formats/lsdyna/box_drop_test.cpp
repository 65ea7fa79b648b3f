#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <solver/step/solver.hpp>

#include "deck_case.hpp"

/// The cube of a public deck, box_drop.k, on a layer of solids in the place of the plate of shells, which decks here
/// have not. The public decks lie beside the project; where they do not, this is skipped.
namespace pinball::test::box_drop_test {
namespace {

class BoxDrop : public DeckTest {
 protected:
  void SetUp() override {
    DeckTest::SetUp();
    if (!std::filesystem::exists(public_deck())) GTEST_SKIP() << "there is no " << public_deck();
  }
  static std::string public_deck() { return PINBALL_SOURCE_DIR "/../shared/decks/box_drop.k"; }

  /// Nodes and solids of the cube, part 2, whose nodes have the numbers from 122 on.
  static std::string cube_of_deck() {
    std::ifstream file(public_deck());
    std::string line, block, text;
    while (std::getline(file, line)) {
      if (line.starts_with('*')) {
        block = line.substr(0, line.find_last_not_of(" \r") + 1);
        if (block == "*NODE" || block == "*ELEMENT_SOLID") text += block + '\n';
        continue;
      }
      const bool node_of_cube = block == "*NODE" && std::atoi(line.substr(0, 8).c_str()) >= 122;
      if (node_of_cube || block == "*ELEMENT_SOLID") text += line + '\n';
    }
    return text;
  }

  /// 10 x 10 x 1 solids of 10 x 10 x 1 mm about the plane of the shells, with held edges: part 1, nodes from 10001 on.
  static std::string layer() {
    std::string nodes = "*NODE\n", solids = "*ELEMENT_SOLID\n", edge = "*SET_NODE_LIST\n90\n";
    const auto number = [](int i, int j, int k) { return 10001 + i + 11 * j + 121 * k; };
    for (int k = 0; k < 2; ++k) {
      for (int j = 0; j <= 10; ++j) {
        for (int i = 0; i <= 10; ++i) {
          nodes += fmt::format("{},{},{},{}\n", number(i, j, k), 10 * i, 10 * j, k - 0.5);
          if (i % 10 == 0 || j % 10 == 0) edge += fmt::format("{}\n", number(i, j, k));
        }
      }
    }
    for (int j = 0; j < 10; ++j) {
      for (int i = 0; i < 10; ++i) {
        solids += fmt::format("{},1", 20001 + i + 10 * j);
        for (int k = 0; k < 2; ++k) {
          solids += fmt::format(",{},{},{},{}", number(i, j, k), number(i + 1, j, k), number(i + 1, j + 1, k),
                                number(i, j + 1, k));
        }
        solids += '\n';
      }
    }
    return nodes + solids + edge;
  }

  static std::string deck() {
    return cube_of_deck() + layer() +
           "*PART\nplate\n1,1,1\n*PART\nbox\n2,1,1\n*SECTION_SOLID\n1,1\n*MAT_ELASTIC\n1,7.85E-9,210000.,0.3\n"
           "*SET_PART_LIST\n1\n1\n*SET_PART_LIST\n2\n2\n*SET_NODE_GENERAL\n4\nPART,2\n"
           "*INITIAL_VELOCITY\n4\n0.,0.,-500.\n*BOUNDARY_SPC_SET\n90,0,1,1,1,1,1,1\n"
           "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_ID\n1,drop\n2,1,2,2\n\n\n*CONTROL_TERMINATION\n0.0092\n";
  }
};

/// 4.5 mm at 500 mm/s.
TEST_F(BoxDrop, FirstForceOfTheContactIsThatOfTheFreeFall) {
  Solver<double> solver(scene(deck()));
  ASSERT_EQ(solver.element_count(), 1100);
  EXPECT_EQ(solver.contact_pairs().at(0).name, "contact_1");
  while (!solver.at_end() && solver.contact_pairs()[0].force_max == 0) solver.step();
  EXPECT_NEAR(solver.force_time(), 9.00e-3, 0.05e-3);
  while (!solver.at_end()) solver.step();
  EXPECT_GT(solver.contact_pairs()[0].impulse[2], 0) << "on the box";
}

}  // namespace
}  // namespace pinball::test::box_drop_test
