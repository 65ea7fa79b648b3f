#pragma once

#include <optional>
#include <string>

#include "given.hpp"

/// TOML as what it gives, and the other way round.
namespace pinball {

/// Throws InputError "PATH:LINE:COLUMN: not valid TOML: ...".
GivenTable parse_toml(const std::string& text, const std::string& path);

/// One value, as behind "KEY = ". source: for messages. None: it is none.
std::optional<GivenValue> parse_toml_value(const std::string& text, const std::string& source);

/// The text of a scene, from which the same bits are read again: tables in the order in which they are first given,
/// each with its comment, and before them a line about the whole.
std::string write_toml(const GivenTable& scene);

}  // namespace pinball
