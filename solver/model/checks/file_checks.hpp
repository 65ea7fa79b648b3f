#pragma once

#include <functional>
#include <string>
#include <vector>

#include <solver/mesh/mesh_file.hpp>

namespace pinball {

/// What the mesh of a file is like where bodies are made of it. body: per element, place in `names`; -1: of none.
/// Throws InputError, with the file's own numbers, for elements that are inverted at their centre and elements that
/// have the same nodes. Returns warnings: nodes that lie on each other and are not one, elements that are inverted at a
/// corner or a Gauss point, and what the reader left out. may_meet: of two nodes of the file; of those nothing is
/// reported, for they are apart on purpose.
std::vector<std::string> check_file(const MeshFile& file, const std::vector<std::int32_t>& body,
                                    const std::vector<std::string>& names,
                                    const std::function<bool(std::int32_t, std::int32_t)>& may_meet);

}  // namespace pinball
