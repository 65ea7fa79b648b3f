#pragma once

#include <cstdint>
#include <limits>
#include <type_traits>

#include "choices.hpp"
#include "key.hpp"

/// Whether a member has the value that it has where its key is not given, and which stands for none.
namespace pinball::schema {

template <class Value>
bool is_unset(const Value& value, const About& about) {
  if constexpr (std::is_same_v<Value, double> || std::is_same_v<Value, std::int64_t>) {
    const bool infinite = std::numeric_limits<Value>::has_infinity && value == std::numeric_limits<Value>::infinity();
    switch (about.unset) {
      case Unset::never:
        return false;
      case Unset::negative:
        return value < 0;
      case Unset::zero:
        return value == 0;
      case Unset::infinite:
        return infinite;
      case Unset::zero_or_infinite:
        return value == 0 || infinite;
    }
    return false;
  } else if constexpr (HasChoices<Value>) {
    return !is_in_files(value);
  } else if constexpr (requires { value.has_value(); }) {
    return !value.has_value();
  } else if constexpr (requires { value.empty(); }) {
    return value.empty() && *about.otherwise;
  } else {
    return false;
  }
}

}  // namespace pinball::schema
