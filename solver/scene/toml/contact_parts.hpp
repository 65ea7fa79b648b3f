#pragma once

#include <solver/scene.hpp>
#include <solver/scene/names.hpp>

#include "table.hpp"

/// The tables of contact that a scene holds any number of. Each function throws InputError on a missing key, a bad
/// value and a body that is not there. scene: as far as it is read; the contact settings are.
namespace pinball {

ContactPair read_contact_pair(const SceneTable& table, const Scene& scene, const Names& bodies);
TiedContact read_tied_contact(const SceneTable& table, const Scene& scene, const Names& bodies);

}  // namespace pinball
