#pragma once

#include <optional>
#include <string>

#include <solver/mesh_formats.hpp>

namespace pinball {

/// What a file is by its ending, in capitals or not; none: an ending that is not known.
std::optional<MeshFormat> format_by_ending(const std::string& file);
/// ".msh, .k, ...", for messages.
std::string known_endings();

}  // namespace pinball
