#pragma once

#include <fstream>
#include <string>

#include <solver/formats/abaqus/cards/abaqus_scene.hpp>
#include <tests/formats/lsdyna/deck_file_case.hpp>
#include <tests/support/cube_text.hpp>

/// Abaqus input of a few lines, written to a file of its own.
namespace pinball::test {

/// A cube of 1 mm, nodes 1 to 8, element 10; its material is Steel.
inline const std::string abaqus_cube = "*NODE\n" + cube_lines(1) + R"(*ELEMENT, TYPE=C3D8R, ELSET=Cube
10, 1, 2, 3, 4, 5, 6, 7, 8
*NSET, NSET=base
1, 2, 3, 4
*NSET, NSET=top
5, 6, 7, 8
*SOLID SECTION, ELSET=Cube, MATERIAL=Steel
,
)";
inline const std::string abaqus_steel = "*MATERIAL, NAME=Steel\n*DENSITY\n7.85E-9\n*ELASTIC\n210000., 0.3\n";
/// A step of 1e-6 s with more keywords in it.
inline std::string abaqus_step(const std::string& keywords = "") {
  return "*STEP\n*DYNAMIC, EXPLICIT\n, 1.0E-6\n" + keywords + "*END STEP\n";
}

class AbaqusTest : public DeckFileTest {
 protected:
  AbaqusTest() : DeckFileTest("deck.inp") {}

  using DeckFileTest::translate;
  TranslatedDeck translate(const std::string& text, const DeckOptions& options) override {
    std::ofstream(path_) << text;
    return translate_abaqus(path_, options);
  }
};

}  // namespace pinball::test
