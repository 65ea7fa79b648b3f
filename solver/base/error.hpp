#pragma once

#include <stdexcept>

#include "export.h"

namespace pinball {

/// Bad input: a scene, a mesh, a command line or an argument that cannot be used as it is. The program ends with
/// status 2. `what()` is complete and readable as it is: "data/scenes/x.toml:12:9: contact.beta: expected a number >=
/// 0, got -1".
struct PINBALL_API InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A run that began well and failed: non-finite state, energy out of bounds, collapsed time step, inverted element.
/// `what()` says what failed, where, when and what to try. The program ends with status 1. Bad input is an InputError.
struct PINBALL_API RunError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace pinball
