#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <solver/model/model.hpp>

#include "ranks.hpp"

namespace pinball {

/// Nodes that all ranks move, whether they hold elements around them or not: those of the surface, of ties and of rigid
/// bodies. One of the ranks that hold such a node has the sum of its element forces, and sends it to all. From then on
/// all have the same of it, and work contact, ties and rigid bodies alike.
///
/// Nodes come to them, for erosion makes new surface; none goes.
template <class S>
class CommonNodes {
 public:
  CommonNodes(Ranks& ranks, std::int32_t node_count);

  bool any() const { return count_ > 0; }
  std::int64_t count() const { return count_; }
  bool has(std::int64_t node) const { return is_common_[node] != 0; }
  /// Those whose forces this rank has for all.
  const std::vector<std::int32_t>& own() const { return of_rank_[ranks_.number()]; }
  /// owner(node): the rank that has the forces of a node, and its motion until it is common. nodes: some perhaps
  /// several times, or common already. Returns whether any were not.
  template <class Owner>
  bool add(std::span<const std::int32_t> nodes, const Owner& owner) {
    for (std::vector<std::int32_t>& of : added_) of.clear();
    bool any = false;
    for (const std::int32_t node : nodes) {
      if (has(node)) continue;
      is_common_[node] = 1;
      added_[owner(node)].push_back(node);
      any = true;
    }
    if (any) take_added();
    return any;
  }

  /// Forces of elements go from owners to all; in each step, before others are added.
  void share_forces(NodeStore<S>& nodes);
  /// Positions, velocities and forces of those that the last add() has brought: in the middle of a step.
  void share_added(NodeStore<S>& nodes);

  std::size_t bytes() const;

 private:
  using NodesOfRanks = std::vector<std::vector<std::int32_t>>;
  void take_added();
  template <class Numbers>
  void share(const NodesOfRanks& of_rank, int numbers, const Numbers& numbers_of);

  Ranks& ranks_;
  std::vector<std::uint8_t> is_common_;  ///< per node of the store
  NodesOfRanks of_rank_, added_;         ///< nodes by their owners
  std::int64_t count_ = 0;
  std::vector<S> own_, all_;  ///< messages
};

}  // namespace pinball
