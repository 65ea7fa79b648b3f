#pragma once

#include <memory>
#include <string>
#include <vector>

#include <solver/mesh.hpp>

#include "radioss_block.hpp"

namespace pinball {

/// Radioss input: the keywords of the starter's file, of those that it includes and, behind these, of the engine's
/// file, in their order.
struct RadiossDeck {
  std::vector<RadiossBlock> blocks;
  std::vector<MeshSource> files;                          ///< of the starter as opened, the deck itself first
  std::vector<std::shared_ptr<const std::string>> texts;  ///< what the blocks refer to
  std::int64_t version = 0;                               ///< of the form of the starter's file: 2022
  std::vector<DeckPlace> behind_end;                      ///< where in its files more stands behind /END
  std::string engine;                                     ///< path of the engine's file; empty: there is none
};

/// NAME_0001.rad of a NAME_0000.rad, or that of a later run, 1 to 9; empty: there is no such file.
std::string radioss_engine_of(const std::string& path, int run = 1);

/// The file of the starter alone, as a mesh. Throws InputError "FILE:LINE: ..." for a file that is missing or includes
/// itself, and for what is no Radioss input, or one of a form before version 5.1.
RadiossDeck read_radioss_deck(const std::string& path);

/// The same of a text in memory, for which `path` stands, with the engine's file beside it.
RadiossDeck parse_radioss_deck(std::string text, const std::string& path);

}  // namespace pinball
