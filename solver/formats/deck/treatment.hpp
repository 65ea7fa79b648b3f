#pragma once

namespace pinball {

/// What is done with a keyword of a deck.
enum class Treatment {
  done,     ///< becomes part of the scene
  mesh,     ///< is read with the mesh
  ignored,  ///< cannot change the answer: output, and controls of what is not there
  rejected  ///< known, and not there yet
};

}  // namespace pinball
