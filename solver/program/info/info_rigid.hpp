#pragma once

#include <vector>

#include <solver/results.hpp>
#include <solver/scene.hpp>
#include <solver/scene/units/units.hpp>

namespace pinball {

/// Prints which bodies are rigid, their masses and centres, and what holds and moves them ("pinball info"). results: of
/// the rigid bodies of the scene.
void print_rigid_bodies(const Scene& scene, const std::vector<RigidBodyResult>& results, const Units& units);

}  // namespace pinball
