#pragma once

#include <tests/support/solver_case.hpp>

namespace pinball::test {

/// A bar along x of cubes of size 1, `along` of them on either side of a section in its middle with eight times as many
/// elements: elements of two steps, one four times the other.
inline Scene bar_with_thin_section(double end, int across = 2, int along = 12) {
  constexpr int thin = 8;
  Body bar = block("bar", {2 * along + thin, across, across}, 1, {0, 0, 0});
  auto& mesh = std::get<BlockMesh>(bar.mesh);
  mesh.size[0] = 2 * along + 1;
  mesh.sections[0] = {{static_cast<double>(along), along}, {1, thin}, {static_cast<double>(along), along}};
  Scene scene = scene_of({bar}, end, false);
  scene.time.subcycling = true;
  return scene;
}

}  // namespace pinball::test
