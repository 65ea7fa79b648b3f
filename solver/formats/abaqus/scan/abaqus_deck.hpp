#pragma once

#include <memory>
#include <string>
#include <vector>

#include <solver/mesh.hpp>

#include "abaqus_block.hpp"

namespace pinball {

/// Abaqus input: the keywords of all its files in their order, each with where it stands: in a part, an instance, the
/// assembly, a step. What opens and closes these stays in the list; *INCLUDE, and INPUT= of other keywords, do not.
struct AbaqusDeck {
  std::vector<AbaqusBlock> blocks;
  std::vector<MeshSource> files;                          ///< as opened, the deck itself first
  std::vector<std::shared_ptr<const std::string>> texts;  ///< what the blocks refer to
  std::vector<std::string> notes;                         ///< how it was read where that could be taken otherwise
};

/// Throws InputError "FILE:LINE: ..." for a file that is missing or includes itself, for what is closed and was not
/// opened, and for what is no Abaqus input.
AbaqusDeck read_abaqus_deck(const std::string& path);

/// The same for a text in memory; `name` stands for the path.
AbaqusDeck parse_abaqus_deck(std::string text, const std::string& name);

}  // namespace pinball
