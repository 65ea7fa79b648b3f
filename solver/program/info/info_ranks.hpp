#pragma once

#include <vector>

#include <solver/scene.hpp>

namespace pinball {

/// A table of what so many processes that mpirun starts would share of a scene, and send each other in its first step.
template <class S>
void print_ranks(const Scene& scene, const std::vector<int>& counts);

}  // namespace pinball
