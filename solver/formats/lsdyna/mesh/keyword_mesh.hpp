#pragma once

#include <solver/formats/lsdyna/scan/keyword_deck.hpp>
#include <solver/mesh/mesh_file.hpp>

namespace pinball {

/// The mesh of a keyword deck: NODE, ELEMENT_SOLID (both layouts; wedges, pyramids and tetrahedra as collapsed
/// hexahedra, those of ten nodes as eight of these), PART, and the sets of nodes, solids and segments. Keywords that
/// say nothing of a mesh are passed over. Throws InputError "FILE:LINE: ..." for a number that is given twice, a node
/// that is not there.
MeshFile keyword_mesh(const KeywordDeck& deck);

}  // namespace pinball
