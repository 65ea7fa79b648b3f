#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <solver/contact/tied/tied_nodes.hpp>
#include <solver/model/model.hpp>

namespace pinball {

/// Which nodes of a scene are tied to which faces. Nodes that are tied from the start are put on their faces: the mesh
/// is changed. In the numbers of the scene, an element's in the place of a slot. Throws InputError for sides that hold
/// nothing, and where that turns an element inside out.
///
/// A node is tied to the nearest of the faces that it is near enough to, the first of several. Not tied are corners of
/// faces that others are tied to, nodes that are tied already, and nodes that are held in all directions or moved as
/// prescribed. Faces with a corner that is tied take none.
std::vector<TiedNode> find_ties(const Scene& scene, ModelMesh& mesh, std::vector<TiedResult>& counts);

}  // namespace pinball
