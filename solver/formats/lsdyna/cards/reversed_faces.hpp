#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <solver/formats/deck/deck_report.hpp>
#include <solver/mesh/mesh_file.hpp>

namespace pinball {

/// Faces that a card presses on, corners as places in the mesh; -1: a node that is not there.
struct DeckFaces {
  std::string what;  ///< the card and its fields that list the corners
  DeckPlace place;
  std::vector<std::array<std::int32_t, 4>> faces;
};

/// Which way round corners stand means nothing, for the one solid that has a face says where its outside is. Tells how
/// many faces have a normal, by the right hand, that points into it. Of all cards at once: the mesh is gone through
/// once.
void tell_reversed(const Mesh& mesh, const std::vector<DeckFaces>& all, DeckReport& report);

}  // namespace pinball
