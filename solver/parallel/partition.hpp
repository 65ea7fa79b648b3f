#pragma once

#include <cstdint>
#include <vector>

#include <solver/model/model.hpp>

#include "ranks.hpp"

namespace pinball {

/// Elements of each tile, without padding.
template <class S>
std::vector<std::int32_t> elements_of_tiles(const Model<S>& model);

/// Steps of the elements of each tile in a cycle of the smallest ones, by the levels of the mesh; without subcycling
/// the elements.
template <class S>
std::vector<std::int32_t> work_of_tiles(const Model<S>& model);

/// The rank that works each tile, as ranks.partition says. A scene of few tiles leaves some ranks without any.
template <class S>
std::vector<std::int32_t> ranks_of_tiles(const Model<S>& model, const Ranks& ranks);

}  // namespace pinball
