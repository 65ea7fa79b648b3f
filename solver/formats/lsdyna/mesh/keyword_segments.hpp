#pragma once

#include <solver/formats/lsdyna/scan/keyword_deck.hpp>
#include <solver/mesh/mesh_file.hpp>
#include <solver/mesh/number_index.hpp>

namespace pinball {

/// The sets of segments of a keyword deck, added to its mesh: SET_SEGMENT, and SET_SEGMENT_GENERAL, whose parts and
/// boxes give faces of the surface. What is wrong with a set is kept with it.
void read_keyword_segments(const KeywordDeck& deck, const NumberIndex& nodes, MeshFile& file);

}  // namespace pinball
