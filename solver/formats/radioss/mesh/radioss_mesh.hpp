#pragma once

#include <solver/formats/radioss/scan/radioss_deck.hpp>
#include <solver/mesh/mesh_file.hpp>

namespace pinball {

/// The mesh of Radioss input: /NODE, /BRICK, /PART, groups and surfaces. Parts are found by their numbers. Throws
/// InputError "FILE:LINE: ..." for what is wrong, for other solids. given_nodes: how many nodes the deck has; behind
/// these come those that hexahedra of twenty nodes get.
MeshFile radioss_mesh(const RadiossDeck& deck, std::size_t* given_nodes = nullptr);

}  // namespace pinball
