#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <solver/model/model.hpp>

namespace pinball {

/// The ranks that hold a node: they have its forces, and move it. Those are the ranks of the elements around it, and
/// who sums something up in which the node takes part.
class NodeHolders {
 public:
  /// Those of the elements. rank_of_tile: per tile of the model.
  template <class S>
  NodeHolders(const Model<S>& model, const std::vector<std::int32_t>& rank_of_tile);

  /// The ranks of a node, ascending.
  std::span<const std::int32_t> of(std::int64_t node) const {
    const std::int32_t one = single_[node];
    if (one >= 0) return {&single_[node], 1};
    const std::size_t place = -1 - one;
    return {ranks_.data() + first_[place], ranks_.data() + first_[place + 1]};
  }
  bool has(std::int64_t node, std::int32_t rank) const;
  bool is_shared(std::int64_t node) const { return single_[node] < 0; }
  /// The nodes of several ranks, ascending; shared_place(): place of such a node there.
  const std::vector<std::int32_t>& shared() const { return shared_; }
  std::int32_t shared_place(std::int64_t node) const { return -1 - single_[node]; }

  /// More of them, which of() knows from take_more() on.
  void add(std::int32_t node, std::int32_t rank) { more_.emplace_back(node, rank); }
  void take_more();

 private:
  using Pairs = std::vector<std::pair<std::int32_t, std::int32_t>>;  ///< node and rank
  void set_shared(Pairs pairs);

  std::vector<std::int32_t> single_;  ///< per node its rank, or -1 - its place in shared_
  std::vector<std::int32_t> shared_, first_, ranks_;
  Pairs more_;
};

}  // namespace pinball
