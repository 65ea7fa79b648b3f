#pragma once

#include <string>
#include <vector>

#include <solver/scene/given/given.hpp>

namespace pinball {

/// Published materials, in the files data/materials/*.toml: tables [[material]] as in a scene, in SI, each with its
/// `source` and the `range` in which it holds. Files of a folder that PINBALL_DATA names come first.
std::vector<GivenTable> known_materials();

/// Gives materials of a scene that `use` a known one what they do not say themselves, in the units of the scene. Throws
/// InputError for a name that is not known. Where the units of the scene are not it does nothing, and the reader says
/// so.
void take_known_materials(GivenTable& scene);

}  // namespace pinball
