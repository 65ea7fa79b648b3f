#pragma once

#include <optional>

#include <solver/results.hpp>
#include <solver/scene.hpp>

namespace pinball {

/// Of all bodies and of what is at nodes beside them [mass].
double initial_mass(const RunSummary& summary);

/// Change of the momentum along the directions in which nothing acts on the scene from outside (no plane of symmetry,
/// no other constraint, wall, load, prescribed velocity or damping), over the largest momentum that initial_mass
/// can have with the initial energy, sqrt(2 m E) [-]. None where something acts in all directions, or without
/// energy at the start.
std::optional<double> momentum_error(const Scene& scene, const RunSummary& summary);

}  // namespace pinball
