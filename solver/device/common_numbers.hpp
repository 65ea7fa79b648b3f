#pragma once

namespace pinball {

/// Numbers of nodes, as flags.
enum class NodeNumbers : unsigned {
  none = 0,
  motion = 1,  ///< positions and velocities
  force = 2,
  all = motion | force
};
constexpr NodeNumbers operator|(NodeNumbers some, NodeNumbers others) {
  return static_cast<NodeNumbers>(static_cast<unsigned>(some) | static_cast<unsigned>(others));
}
constexpr NodeNumbers operator&(NodeNumbers some, NodeNumbers others) {
  return static_cast<NodeNumbers>(static_cast<unsigned>(some) & static_cast<unsigned>(others));
}
constexpr bool has(NodeNumbers numbers, NodeNumbers some) { return (numbers & some) != NodeNumbers::none; }
/// How many records of four they are for each node.
constexpr int records_of(NodeNumbers numbers) {
  return (has(numbers, NodeNumbers::motion) ? 2 : 0) + (has(numbers, NodeNumbers::force) ? 1 : 0);
}

/// All common nodes, those of them that are listed (StepSpace), or, of several ranks, those whose forces this one gives
/// to all (CommonNodes).
enum class CommonSet { all, listed, own };

}  // namespace pinball
