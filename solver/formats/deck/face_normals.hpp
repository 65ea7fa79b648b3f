#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include <solver/mesh.hpp>

/// Which way the normals of faces that a deck lists point.
namespace pinball {

using DeckFace = std::array<std::int32_t, 4>;

/// By its key (face_key), the element of each of these faces that is of one element alone; of others a number below 0.
std::map<DeckFace, std::int32_t> solids_of_faces(const Mesh& mesh, const std::vector<DeckFace>& faces);

/// Whether the normal of a face, that of its diagonals 1 to 3 and 2 to 4, points into its element.
bool points_inwards(const Mesh& mesh, const DeckFace& face, const std::array<std::int32_t, 8>& solid);

}  // namespace pinball
