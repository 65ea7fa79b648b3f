#pragma once

#include <cstdint>
#include <optional>

#include <solver/mesh.hpp>

#include "element_types.hpp"

/// Meshes of tetrahedra, hexahedra of which four edges are collapsed (kernels/tetrahedron.hpp).
namespace pinball {

/// A hexahedron that is collapsed to four nodes in some way, as other programs write tetrahedra (1 2 3 3 4 4 4 4, say),
/// in the form of tetrahedron(), on the side on which it has its volume. None where it has none, or more or fewer
/// nodes.
std::optional<Corners8> as_tetrahedron(const Corners8& corners);

/// Each hexahedron as six tetrahedra, a wedge as three, without new nodes. Faces are cut from their node of the lowest
/// number, so that neighbours cut theirs alike, in any mesh (Dompierre, Labbe, Vallet and Camarero, 8th International
/// Meshing Roundtable, 1999).
Mesh cut_into_tetrahedra(const Mesh& mesh);

}  // namespace pinball
