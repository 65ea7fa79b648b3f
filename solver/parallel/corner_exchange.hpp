#pragma once

#include <cstdint>
#include <vector>

#include <kernels/exec/array.hpp>
#include <solver/model/model.hpp>

#include "corner_plan.hpp"
#include "due_corners.hpp"
#include "ranks.hpp"

namespace pinball {

/// The forces of element corners at nodes of several ranks (CornerPlan), in the memory of the host. Each such corner of
/// this rank has a record of its own behind those of the nodes: kernels find the node's position and velocity there,
/// and leave its force.
template <class S>
class CornerExchange {
 public:
  /// Adds records to the nodes of the model. plan: has to stay where it is; rank_of_tile: per tile of the model.
  CornerExchange(Model<S>& model, const CornerPlan& plan, const std::vector<std::int32_t>& rank_of_tile, Ranks& ranks);

  /// ElementView::corner of the elements of this rank.
  const std::int32_t* corner() const { return corner_.data(); }
  /// Which tiles are worked in which step (Subcycling); at first all are of level 0, and so in all.
  void set_levels(const std::vector<int>& level_of_tile) { due_ = DueCorners(plan_, level_of_tile); }
  /// Before the elements of a level are worked: positions and velocities of nodes go to the records of their corners.
  void spread(NodeStore<S>& nodes, int level) const;
  /// Afterwards: adds the forces of all corners that were worked to those of the nodes, and clears those of the
  /// records. level: the highest that was due.
  void collect(NodeStore<S>& nodes, int level);

  std::size_t bytes() const;

 private:
  void repeat_in_padding(const Model<S>& model, const std::vector<std::int32_t>& rank_of_tile);

  const CornerPlan& plan_;
  DueCorners due_;
  Ranks& ranks_;
  Array<std::int32_t> corner_;
  std::vector<std::vector<S>> sent_;  ///< to each neighbour
  std::vector<S> received_;
};

}  // namespace pinball
