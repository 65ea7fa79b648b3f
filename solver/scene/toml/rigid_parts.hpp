#pragma once

#include <solver/scene.hpp>
#include <solver/scene/names.hpp>

#include "table.hpp"

namespace pinball {

/// [[rigid_body]] and [[rigid_motion]] of a scene of which bodies, time and contact have been read. Throws InputError
/// on a missing key or a bad value.
void read_rigid_bodies(const SceneTable& top, Scene& scene);

}  // namespace pinball
