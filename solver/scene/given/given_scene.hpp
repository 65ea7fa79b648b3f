#pragma once

#include <memory>

#include "given.hpp"

namespace pinball {

class HeldMesh;  // solver/mesh/held_mesh.hpp

/// What something that is no file of TOML gives of a scene: a deck of another program.
struct GivenScene {
  GivenTable table;
  bool contact_said = true;          ///< whether anything says what touches
  std::shared_ptr<HeldMesh> mesh{};  ///< of its bodies, which was read with it; null: their file is read
};

}  // namespace pinball
