#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "ranks.hpp"

namespace pinball {

class NodeHolders;

/// Sums over nodes that are cut into blocks of the whole list, whatever the number of ranks. Each block is summed up by
/// one rank, which holds all its nodes, and the sums of the blocks go to all: so they have one order.
class SharedBlocks {
 public:
  struct Run {
    std::int64_t begin, end;  ///< consecutive blocks
  };
  /// visit(block, take) calls take(node) for the nodes of a block.
  using Visit = std::function<void(std::int64_t, const std::function<void(std::int32_t)>&)>;
  /// A block goes to the rank that holds most of its nodes, and this becomes a holder of the others.
  SharedBlocks(Ranks& ranks, NodeHolders& holders, std::int64_t blocks, Visit visit);
  /// When the holders of all nodes are known. moves(node): whether this rank moves a node.
  template <class Moves>
  void find_worked(const Moves& moves) {
    worked_.clear();
    for (std::int64_t block = 0; block < count(); ++block) {
      bool works = owner_[block] == ranks_->number();
      if (!works) visit_(block, [&](std::int32_t node) { works = works || moves(node); });
      if (!works) continue;
      if (worked_.empty() || worked_.back().end != block) worked_.push_back({block, block});
      worked_.back().end = block + 1;
    }
  }

  /// Blocks with a node that this rank moves: it works them, though the sums of some are another's.
  const std::vector<Run>& worked() const { return worked_; }
  std::int32_t owner(std::int64_t block) const { return owner_[block]; }
  std::int64_t count() const { return static_cast<std::int64_t>(owner_.size()); }

  /// of_block: per block; this rank's are known before, all after.
  template <class Value>
  void gather(Value* of_block) const {
    ranks_->share(owner_, of_block);
  }
  /// Of those blocks alone that all ranks want.
  template <class Value, class Wanted>
  void gather(Value* of_block, const Wanted& wanted) const {
    ranks_->share(owner_, of_block, wanted);
  }

 private:
  Ranks* ranks_;
  Visit visit_;
  std::vector<std::int32_t> owner_;  ///< per block
  std::vector<Run> worked_;
};

}  // namespace pinball
