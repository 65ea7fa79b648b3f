#pragma once

#include <string>
#include <vector>

#include <solver/scene.hpp>

#include "run_results.hpp"

namespace pinball {

/// What is asked of a scene whose user names nothing: energies and velocities of bodies at the end, plastic strain and
/// what is left of their mass, impulse and peak of walls, pairs and named forces, and of each probe the last value and
/// the peak. Of components and energies those that are more than 1e-6 of their scale.
std::vector<std::string> default_quantities(const Scene& scene, const RunResults& run);

/// Throws InputError that names the nearest where a run has no such quantity.
void require_quantities(const std::vector<std::string>& names, const RunResults& run);

}  // namespace pinball
