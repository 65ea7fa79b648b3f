#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model.hpp"

namespace pinball {

/// Two bodies that share space.
struct InitialOverlap {
  std::string first, second;  ///< names of the bodies; empty: no bodies do
  std::int64_t points = 0;    ///< nodes, and nine points of each element, that lie inside an element of the other body
};

/// The first two bodies that overlap, by default more than rounding and curved surfaces of touching meshes do: a node
/// or the centre of an element lies inside an element of the other body, at least `depth` deep over the size of that
/// [-]. Contact cannot tell from which side such bodies came. pairs: of the scene; where there are any, only bodies
/// that these let touch are looked at.
InitialOverlap find_initial_overlap(const ModelMesh& mesh, const std::vector<ContactPair>& pairs = {},
                                    double depth = 0.1);

}  // namespace pinball
