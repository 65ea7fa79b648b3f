#pragma once

#include <vector>

#include <solver/scene.hpp>

namespace pinball {

/// When constraints, motions, rigid walls, pressures, pairs, ties and limits of a scene begin or end, in order; those
/// after the start of the run [time].
std::vector<double> marked_times(const Scene& scene);

}  // namespace pinball
