#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include <solver/mesh.hpp>

/// Tetrahedra in meshes: hexahedra of which four edges are collapsed (kernels/tetrahedron.hpp); wedges and pyramids.
namespace pinball {

using Corners8 = std::array<std::int32_t, 8>;

/// The tetrahedron of four nodes: seen from d, a to c go counterclockwise, so that its volume is positive.
constexpr Corners8 tetrahedron(std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d) {
  return {a, a, b, b, c, d, d, c};
}

/// The wedge between the triangles a b c and d e f: seen from the second, both go counterclockwise.
constexpr Corners8 wedge(std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d, std::int32_t e,
                         std::int32_t f) {
  return {a, b, c, c, d, e, f, f};
}

/// The pyramid of the base a b c d: seen from the top it goes counterclockwise.
constexpr Corners8 pyramid(std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d, std::int32_t top) {
  return {a, b, c, d, top, top, top, top};
}

/// Whether corners have the form of tetrahedron().
bool is_tetrahedron(const Corners8& corners);

/// Whether corners have six different nodes, as those of wedge().
bool is_wedge(const Corners8& corners);

/// A hexahedron that is collapsed to four nodes in some way, as other programs write tetrahedra (1 2 3 3 4 4 4 4, say),
/// in the form of tetrahedron(), on the side on which it has its volume. None where it has none, or more or fewer
/// nodes.
std::optional<Corners8> as_tetrahedron(const Corners8& corners);

/// Each hexahedron as six tetrahedra, a wedge as three, without new nodes. Faces are cut from their node of the lowest
/// number, so that neighbours cut theirs alike, in any mesh (Dompierre, Labbe, Vallet and Camarero, 8th International
/// Meshing Roundtable, 1999).
Mesh cut_into_tetrahedra(const Mesh& mesh);

}  // namespace pinball
