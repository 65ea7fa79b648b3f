#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <solver/mesh/mesh_file.hpp>

namespace pinball {

/// How many of these faces, corners as places in the mesh, are of one solid and stand so that their normal, by the
/// right hand, points into it.
std::size_t count_reversed(const Mesh& mesh, const std::vector<std::array<std::int32_t, 4>>& faces);

}  // namespace pinball
