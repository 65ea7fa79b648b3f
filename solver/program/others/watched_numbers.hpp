#pragma once

#include <string>
#include <vector>

#include <solver/scene.hpp>

#include "other_history.hpp"

namespace pinball {

/// Gives a scene of one mesh file probes of nodes and elements that others have by their numbers and the scene does not
/// watch, so that its history has them, too: up to ten nodes and ten elements, evenly from all of them. Returns a
/// sentence for each kind of which there are more; empty: all are watched.
std::vector<std::string> watch_numbers(const std::vector<OtherHistory>& others, Scene& scene);

}  // namespace pinball
