#pragma once

#include <string>
#include <vector>

#include <solver/scene.hpp>

#include "convergence_study.hpp"

namespace pinball {

/// What the runs of the study say of each quantity by now, in place of what was known before.
void draw_quantities(const Scene& scene, const std::vector<std::string>& names, ConvergenceStudy& study);

}  // namespace pinball
