#pragma once

#include <fmt/format.h>

#include <string>

namespace pinball::test {

/// Lines of nodes for decks and Abaqus input, "NUMBER,x,y,z": the corners of a unit square at a height z, in turn from
/// (0, 0). Two such squares, the lower first, are the eight corners of a cube in the order of an element.
inline std::string square_lines(int first, double height, int step = 1) {
  static constexpr int x[4] = {0, 1, 1, 0}, y[4] = {0, 0, 1, 1};
  std::string lines;
  for (int i = 0; i < 4; ++i) lines += fmt::format("{},{},{},{:g}\n", first + i * step, x[i], y[i], height);
  return lines;
}

/// A cube on z = 0, from the number `first` on.
inline std::string cube_lines(int first, int step = 1) {
  return square_lines(first, 0, step) + square_lines(first + 4 * step, 1, step);
}

}  // namespace pinball::test
