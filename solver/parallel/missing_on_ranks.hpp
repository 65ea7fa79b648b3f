#pragma once

#include <string>

#include <solver/scene.hpp>

namespace pinball {

/// What of a completed scene several ranks cannot do yet, as the end of a sentence ("contact, subcycling"); empty: all
/// of it can be done. tetrahedra: whether a mesh of a file has some.
std::string missing_on_ranks(const Scene& scene, bool tetrahedra = false);

/// Throws InputError for a scene with any of it.
void require_ranks_can(const Scene& scene, bool tetrahedra);

}  // namespace pinball
