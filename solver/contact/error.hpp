#pragma once

#include <pinball/contact/export.h>

#include <stdexcept>

namespace pinball {

/// Bad input: a scene, a mesh, a command line or an argument that cannot be used as it is. The program ends with
/// status 2. `what()` is complete and readable as it is: "data/scenes/x.toml:12:9: contact.beta: expected a number >=
/// 0, got -1".
struct PINBALL_API InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace pinball
