#pragma once

#include <string>

#include "solver_case.hpp"

/// Blocks that are tied to each other.
namespace pinball::test {

inline TiedContact tie(const std::string& first, const std::string& second) {
  TiedContact tied;
  tied.name = "glue";
  tied.first.bodies = {first};
  tied.second.bodies = {second};
  return tied;
}

/// A block on another, whose meshes have `fine` and `coarse` elements along their sides of length 0.6.
inline Scene glued(int fine, int coarse, double end, double gap = 0) {
  Scene scene = scene_of({block("low", {coarse, coarse, coarse}, 0.6 / coarse, {0, 0, 0}),
                          block("high", {fine, fine, fine}, 0.6 / fine, {0, 0, 0.6 + gap})},
                         end, false);
  scene.element.hourglass = HourglassControl::assumed_strain;
  scene.tied_contacts = {tie("high", "low")};
  return scene;
}

}  // namespace pinball::test
