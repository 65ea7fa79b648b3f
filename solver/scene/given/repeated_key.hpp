#pragma once

#include <toml++/toml.h>

#include <cstdint>
#include <string>

namespace pinball {

/// The line in which the key or table stands first that the parser found a second time; 0: it found something else, or
/// what is first is not near.
std::int64_t line_of_first(const std::string& text, const toml::parse_error& error);

}  // namespace pinball
