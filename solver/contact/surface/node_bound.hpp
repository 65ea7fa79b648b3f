#pragma once

#include <cstdint>

#include <solver/base/point.hpp>

namespace pinball {

/// A plane that a node does not cross in the coming step, whatever contact does to it: that of a rigid wall.
struct NodeBound {
  std::int32_t node;  ///< of the store
  std::int32_t wall;  ///< number of the plane
  Point normal;       ///< to the free side, of unit length
  double gap;         ///< of the node before the step, from where the plane is after it [length]
  double present;     ///< the same from where the plane is before it [length]
  double rate;        ///< at which the gap closes before the step [length/time]
  double friction;    ///< coefficient, finite also where nothing slides [-]
  Point sliding;      ///< of the node before the step, across the normal [length/time]
};

}  // namespace pinball
