#pragma once

#include <vector>

#include <solver/model/model.hpp>

#include "element_parts.hpp"

namespace pinball {

/// By what time.smallest_step multiplies the mass of each element; empty: by 1.
///
/// The stable step of an element that has f times the mass of its material follows from the same equation as that of
/// any other (stable_time_step.hpp), with its frequency squared and its damping over f:
///
///     f = w^2 dt^2/4 + d dt/2 ,      dt = time.smallest_step / time.cfl .
///
/// It is that of the mesh at the start: an element that is squeezed later has a smaller step, as everywhere.
std::vector<double> mass_factors(const Scene& scene, const ModelMesh& mesh, const ElementParts& parts);

}  // namespace pinball
