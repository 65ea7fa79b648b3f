#pragma once

#include <solver/mesh.hpp>
#include <solver/mesh_settings.hpp>

namespace pinball {

/// The copy of a host's arrays. Throws InputError that names the array and the place in it: a null pointer, a wrong
/// type or number of components, no records, a coordinate that is not finite, an index out of range, a node of no
/// element.
Mesh copy_mesh(const ArrayMesh& arrays);

}  // namespace pinball
