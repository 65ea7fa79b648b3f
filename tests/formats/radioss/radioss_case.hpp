#pragma once

#include <fmt/format.h>

#include <fstream>
#include <string>

#include <solver/formats/radioss/cards/radioss_scene.hpp>
#include <tests/formats/lsdyna/deck_file_case.hpp>

/// Radioss input of a few keywords, written to files of its own.
namespace pinball::test {

/// Fields of ten columns each, "-" blank.
inline std::string ten(std::initializer_list<const char*> fields) {
  std::string line;
  for (const std::string field : fields) line += fmt::format("{:>10}", field == "-" ? "" : field);
  return line + "\n";
}
inline std::string twenty(std::initializer_list<double> numbers) {
  std::string line;
  for (const double number : numbers) line += fmt::format("{:>20}", number);
  return line + "\n";
}

/// Corners of a unit square at a height, in turn from (0, 0).
inline std::string square_nodes(int first, double height) {
  static constexpr int x[4] = {0, 1, 1, 0}, y[4] = {0, 0, 1, 1};
  std::string lines;
  for (int i = 0; i < 4; ++i) lines += fmt::format("{:>10}{:>20}{:>20}{:>20}\n", first + i, x[i], y[i], height);
  return lines;
}

inline const std::string radioss_begin = "/BEGIN\ncube\n" + ten({"2022", "0"}) +
                                         "                  Mg                  mm                   s\n"
                                         "                  Mg                  mm                   s\n";
inline const std::string radioss_steel = "/MAT/ELAST/1\nsteel\n" + twenty({7.85e-9, 0}) + twenty({210000, 0.3}),
                         radioss_property = "/PROP/SOLID/1\nsolids\n\n\n\n",
                         radioss_cube = "/PART/1\ncube\n" + ten({"1", "1", "0"}) + "/NODE\n" + square_nodes(1, 0) +
                                        square_nodes(5, 1) + "/BRICK/1\n" +
                                        ten({"10", "1", "2", "3", "4", "5", "6", "7", "8"}),
                         radioss_run = "/RUN/cube/1\n1.0E-6\n";

class RadiossTest : public DeckFileTest {
 protected:
  RadiossTest() : DeckFileTest("cube_0000.rad") {}

  using DeckFileTest::translate;
  TranslatedDeck translate(const std::string& text, const DeckOptions& options) override {
    std::ofstream(path_) << "#RADIOSS STARTER\n" << text << "/END\n";
    std::ofstream((folder_ / "cube_0001.rad").string()) << engine_;
    return translate_radioss(path_, options);
  }
  /// A cube with these keywords more.
  static std::string cube_with(const std::string& more) {
    return radioss_begin + "/TITLE\nA cube\n" + radioss_steel + radioss_property + radioss_cube + more;
  }

  std::string engine_ = radioss_run;
};

}  // namespace pinball::test
