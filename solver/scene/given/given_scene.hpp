#pragma once

#include <memory>
#include <string>
#include <vector>

#include "given.hpp"

namespace pinball {

class HeldMesh;  // solver/mesh/held_mesh.hpp

/// What something that is no file of TOML gives of a scene: a deck of another program.
struct GivenScene {
  GivenTable table;
  bool contact_said = true;            ///< whether anything says what touches
  std::shared_ptr<HeldMesh> mesh{};    ///< of its bodies, which was read with it; null: their file is read
  std::string file{};                  ///< its name, in the folder of its source; empty: not known
  std::vector<std::string> options{};  ///< with which the command line reads it: --case, --lenient
};

}  // namespace pinball
