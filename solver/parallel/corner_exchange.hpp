#pragma once

#include <cstdint>
#include <vector>

#include <kernels/exec/array.hpp>
#include <solver/model/model.hpp>

#include "node_holders.hpp"
#include "ranks.hpp"

namespace pinball {

/// The forces of element corners at nodes of several ranks. Each such corner of this rank has a record of its own
/// behind those of the nodes: kernels find the node's position and velocity there, and leave its force. All ranks that
/// hold the node get the forces of its corners and add them up in the order in which one process does: the sums have
/// the same bits, whatever rank works what.
template <class S>
class CornerExchange {
 public:
  /// Adds records to the nodes of the model. rank_of_tile: per tile of the model.
  CornerExchange(Model<S>& model, const std::vector<std::int32_t>& rank_of_tile, const NodeHolders& holders,
                 Ranks& ranks);

  /// ElementView::corner of the elements of this rank.
  const std::int32_t* corner() const { return corner_.data(); }
  /// Before the elements are worked: positions and velocities of nodes go to the records of their corners.
  void spread(NodeStore<S>& nodes) const;
  /// Afterwards: adds the forces of all corners to those of the nodes, and clears those of the records.
  void collect(NodeStore<S>& nodes);

  /// Forces of corners that all ranks together send in a step.
  std::int64_t records() const { return records_; }
  /// In as many messages: of ranks to others.
  std::int64_t messages() const { return messages_; }
  /// Of one of them.
  static constexpr std::int64_t bytes_per_record = 3 * sizeof(S);
  std::size_t bytes() const;

 private:
  struct Neighbour {
    std::int32_t rank = 0;
    std::vector<std::int32_t> sent;     ///< records, behind those of the nodes
    std::int64_t first = 0, count = 0;  ///< of what it sends, in received_
    std::vector<S> buffer;
  };
  Neighbour& neighbour(std::int32_t rank);
  void find_records(Model<S>& model, const std::vector<std::int32_t>& rank_of_tile, const NodeHolders& holders);
  void repeat_in_padding(const Model<S>& model, const std::vector<std::int32_t>& rank_of_tile);

  Ranks& ranks_;
  Array<std::int32_t> corner_;
  std::vector<std::int32_t> node_of_record_;
  std::vector<Neighbour> neighbours_;
  std::vector<S> received_;
  std::vector<std::int32_t> nodes_;   ///< of several ranks, held by this one
  std::vector<std::int64_t> first_;   ///< [nodes_ + 1]: their part of source_
  std::vector<std::int64_t> source_;  ///< a record; or -1 - number of a force in received_
  std::int64_t records_ = 0, messages_ = 0;
};

}  // namespace pinball
