#pragma once

#include <string>
#include <vector>

#include <solver/scene.hpp>

namespace pinball {

/// Prescribed displacements that are not 0 where they begin: nodes and bodies move by what the displacement grows from
/// there, and do not leap; a sentence for each of them. One that goes on where another one ends is none.
std::vector<std::string> displacement_jumps(const Scene& scene);

}  // namespace pinball
