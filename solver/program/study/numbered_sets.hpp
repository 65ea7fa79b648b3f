#pragma once

#include <solver/scene.hpp>

namespace pinball {

/// Nodes, and corners of faces, that the scene lists by the numbers of a mesh file whose hexahedra are split become
/// sets of that file, which go with finer meshes: a new node belongs to them where all nodes of its edge, face or body
/// do, a face becomes four. The meshes are read for that, and held for the model that is built next. Throws InputError
/// for a number that the file does not have.
void carry_numbers(Scene& scene);

/// Throws InputError that names the key of a list that cannot be carried: of an element, which becomes eight, of
/// nodes that have to be in a set, too, and an equation that pairs the nodes of lists or sets.
void require_numbers_that_carry(const Scene& scene);

}  // namespace pinball
