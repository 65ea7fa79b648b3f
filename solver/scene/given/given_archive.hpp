#pragma once

#include <memory>

#include <solver/base/state_archive.hpp>

#include "given_scene.hpp"

namespace pinball {

/// What a deck gives of a scene, with its places, as a part of a checkpoint; its mesh is read again.
void persist(StateArchive& archive, std::shared_ptr<const GivenScene>& given);

}  // namespace pinball
