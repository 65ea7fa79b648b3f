#pragma once

#include <cstdint>
#include <vector>

#include <solver/parallel/ranks.hpp>

namespace pinball {

/// Parts of as many elements as can be, between which few nodes are shared, by METIS: the part of each tile. Throws
/// InputError where the program was built without it.
std::vector<std::int32_t> cut_graph(const TileGraph& tiles, int parts);

}  // namespace pinball
