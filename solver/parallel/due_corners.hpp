#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "corner_plan.hpp"

namespace pinball {

/// The corners of a plan by the levels of their tiles (Subcycling). Levels that are due are worked from the highest to
/// level 0, each in the order of the plan: so one process adds their forces, and so do ranks. What is due in a step is
/// the beginning of each message.
struct DueCorners {
  struct Neighbour {
    std::vector<std::int32_t> sent;                        ///< in CornerPlan::own, by level
    std::vector<std::int64_t> sent_up_to, received_up_to;  ///< per level: forces of tiles that are not above it
  };
  struct Source {
    std::int64_t place;  ///< as in CornerPlan::source, of what is received by level
    std::int32_t level;
  };

  /// level_of_tile: per tile of the model; empty: all are of level 0.
  DueCorners(const CornerPlan& plan, const std::vector<int>& level_of_tile);

  std::vector<std::vector<std::int32_t>> own;  ///< per level: in CornerPlan::own
  std::vector<Neighbour> neighbours;           ///< each of the plan
  std::vector<Source> sources;                 ///< of each node of the plan, from the highest level on
  std::vector<std::int64_t> records;           ///< per level, the highest that is due: forces that all ranks send
  std::size_t bytes() const;
};

}  // namespace pinball
