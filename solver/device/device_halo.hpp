#pragma once

#include <cstdint>
#include <vector>

#include <kernels/exec.hpp>

namespace pinball {

/// Where messages of ranks begin and end: on the host, or on the device, which a library of messages may be able to
/// reach.
enum class Messages { host, device };

/// The corners of elements whose forces cross between ranks, and those that each node adds up: a corner is number
/// 8 x place + i. Those that come from other ranks have numbers behind the corners of all places.
struct DeviceHalo {
  std::vector<std::uint32_t> sent;       ///< message after message
  std::int64_t received = 0;             ///< in all messages, in the order of their numbers
  Array<std::uint32_t> first_of_node;    ///< [nodes + 1] (CornersOfNodes)
  Array<std::uint32_t> corners_of_node;  ///< node after node, in the order in which one process adds their forces

  /// for_each: calls its argument with the node and the number of each corner, those of a node in their order; twice
  /// the same.
  template <class ForEach>
  void set_corners(std::int32_t nodes, const ForEach& for_each) {
    first_of_node.reset(static_cast<std::size_t>(nodes) + 1);
    for_each([&](std::size_t node, std::uint32_t) { ++first_of_node[node + 1]; });
    for (std::int32_t n = 0; n < nodes; ++n) first_of_node[n + 1] += first_of_node[n];
    corners_of_node.reset(first_of_node[nodes]);
    std::vector<std::uint32_t> next(first_of_node.data(), first_of_node.data() + nodes);
    for_each([&](std::size_t node, std::uint32_t corner) { corners_of_node[next[node]++] = corner; });
  }
};

}  // namespace pinball
