#pragma once

#include <fmt/core.h>

#include <solver/scene.hpp>

namespace pinball::bench {

/// data/scenes/block.toml with so many elements along each side.
inline Scene block_scene(int per_side) {
  SceneOverrides overrides;
  overrides.set = {fmt::format("body.block.mesh.elements=[{0},{0},{0}]", per_side)};
  return read_scene(find_scene("block"), overrides);
}

}  // namespace pinball::bench
