#pragma once

#include <fstream>
#include <string>

#include <tests/support/cube_text.hpp>

#include "deck_file_case.hpp"

/// LS-DYNA decks of a few cards, written to a file of their own.
namespace pinball::test {

/// A cube of 1 mm of elastic steel, nodes 1 to 8, element 10, part 1.
inline const std::string cube = "*NODE\n" + cube_lines(1) + R"(*ELEMENT_SOLID
10,1,1,2,3,4,5,6,7,8
*PART
cube
1,1,1
*SECTION_SOLID
1,1
)";
inline const std::string elastic = "*MAT_ELASTIC\n1,7.85E-9,210000.,0.3\n";
inline const std::string ends = "*CONTROL_TERMINATION\n1.0E-6\n";
inline const std::string set_of_top = "*SET_NODE_LIST\n3\n5,6,7,8\n";

class DeckTest : public DeckFileTest {
 protected:
  DeckTest() : DeckFileTest("deck.k") {}

  using DeckFileTest::translate;
  TranslatedDeck translate(const std::string& text, const DeckOptions& options) override {
    std::ofstream(path_) << "*KEYWORD\n" << text << "*END\n";
    return translate_deck(path_, options);
  }
  /// The error of the scene, or of its model, as the program has it.
  std::string error_in_cards(const std::string& text) {
    const TranslatedDeck deck = translate(text);
    return without_folder(error_of([&] { build_model<double>(read_scene(deck.source(path_ + " as a scene"))); }));
  }
};

}  // namespace pinball::test
