#pragma once

#include <cstdint>
#include <vector>

#include <solver/model/model.hpp>

#include "node_holders.hpp"

namespace pinball {

/// Which forces of element corners cross between ranks: those at nodes that several hold. All ranks that hold a node
/// get the forces of its corners and add them up in the order in which one process does: the sums have the same bits,
/// whatever rank works what. Both sides of a message go through the corners in that order.
struct CornerPlan {
  /// A corner of an element of this rank at a node of several.
  struct Corner {
    std::int64_t slot;
    std::int32_t corner, node, tile;
  };
  struct Neighbour {
    std::int32_t rank = 0;
    std::vector<std::int32_t> sent;     ///< in `own`
    std::int64_t first = 0, count = 0;  ///< of what it sends, in all that is received
  };

  /// rank_of_tile: per tile of the model; self: this rank.
  template <class S>
  CornerPlan(const Model<S>& model, const std::vector<std::int32_t>& rank_of_tile, const NodeHolders& holders,
             std::int32_t self);

  std::vector<Corner> own;
  std::vector<Neighbour> neighbours;
  std::int64_t received = 0;         ///< forces, of all neighbours together
  std::vector<std::int32_t> nodes;   ///< of several ranks, held by this one
  std::vector<std::int64_t> first;   ///< [nodes + 1]: their part of `source`
  std::vector<std::int64_t> source;  ///< in `own`; or -1 - number of a force that is received
  std::vector<std::int32_t> tile_of_source;
  std::vector<std::int64_t> records_of_tile;  ///< forces that its rank sends
  std::int64_t records = 0;                   ///< all of them: what all ranks together send where all tiles are worked
  std::int64_t messages = 0;                  ///< in which they do
  std::size_t bytes() const;

 private:
  Neighbour& neighbour(std::int32_t rank);
};

}  // namespace pinball
