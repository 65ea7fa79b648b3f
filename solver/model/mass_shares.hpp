#pragma once

#include <cstdint>
#include <vector>

#include "model.hpp"

namespace pinball {

/// Nodes of some bodies, ascending in the order of the store, and which part of each node's mass is theirs: their
/// elements' part of the masses of all elements around it. A node may have mass added to it, and take part in a tie.
struct MassShares {
  std::vector<std::int32_t> nodes;
  std::vector<double> share;  ///< per node [-]
};

/// Of each of so many groups of bodies. group_of_body: -1: of none.
template <class S>
std::vector<MassShares> mass_shares(const Model<S>& model, const std::vector<std::int32_t>& group_of_body,
                                    std::size_t groups);

}  // namespace pinball
