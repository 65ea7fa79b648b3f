#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "ranks.hpp"
#include "shared_blocks.hpp"

namespace pinball {

/// What loops over lists of nodes ask of several ranks that share these. No type of the model: sources of nvcc see it.
class SharedNodes {
 public:
  virtual ~SharedNodes() = default;

  /// A sum over a list of nodes that is cut into blocks; before the first step.
  virtual std::shared_ptr<const SharedBlocks> blocks(std::int64_t count, SharedBlocks::Visit visit) = 0;
  /// Of the element in a slot, and of those that move a node the one whose word counts.
  virtual std::int32_t rank_of_slot(std::int64_t slot) const = 0;
  virtual std::int32_t rank_of_node(std::int32_t node) const = 0;
  /// Calls bring() on all ranks with the state of the model, so that rank 0 has what results are made of.
  virtual void keep_with_state(std::function<void()> bring) = 0;

  /// Of each number, what its owner has goes to all; owner: rank of each number.
  template <class Value>
  void share(const std::vector<std::int32_t>& owner, Value* of) {
    ranks_.share(owner, of);
  }

 protected:
  explicit SharedNodes(Ranks& ranks) : ranks_(ranks) {}

  Ranks& ranks_;
};

}  // namespace pinball
