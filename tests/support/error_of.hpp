#pragma once

#include <string>

#include <solver/base/error.hpp>

namespace pinball::test {

/// What error_of() gives where nothing is thrown.
inline const std::string no_error = "no error";

/// What a call says that throws this kind of error. Other exceptions pass.
template <class Error = InputError, class Call>
std::string error_of(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return no_error;
}

}  // namespace pinball::test
