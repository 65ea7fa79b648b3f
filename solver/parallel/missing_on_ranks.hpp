#pragma once

#include <string>

#include <solver/scene.hpp>

namespace pinball {

/// What of a completed scene several ranks with a device each cannot do yet, as the end of a sentence ("contact,
/// subcycling"); empty: all of it can be done, as it always is where processors work the elements. averages_volumes: as
/// of Model.
std::string missing_on_ranks(const Scene& scene, bool averages_volumes);

/// Throws InputError for a scene with any of it.
void require_ranks_can(const Scene& scene, bool averages_volumes);

}  // namespace pinball
