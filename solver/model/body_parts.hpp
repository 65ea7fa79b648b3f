#pragma once

#include <cstdint>
#include <vector>

#include "model.hpp"

namespace pinball {

/// A body that has a node, and which part of the node's mass is its own, as in MassShares.
struct BodyPart {
  std::int32_t body = 0;
  double share = 0;  ///< [-]
};

/// Of each of these nodes of the scene.
template <class S>
std::vector<std::vector<BodyPart>> parts_of_bodies(const Model<S>& model, const std::vector<std::int32_t>& nodes);

}  // namespace pinball
