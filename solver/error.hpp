#pragma once

#include <pinball/contact/error.hpp>

namespace pinball {

/// A run that began well and failed: non-finite state, energy out of bounds, collapsed time step, inverted element.
/// `what()` says what failed, where, when and what to try. The program ends with status 1. Bad input is an InputError.
struct PINBALL_API RunError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace pinball
