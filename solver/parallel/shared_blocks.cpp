#include "shared_blocks.hpp"

#include <algorithm>
#include <utility>

#include "node_holders.hpp"

namespace pinball {

SharedBlocks::SharedBlocks(Ranks& ranks, NodeHolders& holders, std::int64_t blocks, Visit visit)
    : ranks_(&ranks), visit_(std::move(visit)) {
  std::vector<std::int64_t> held(ranks.count());
  for (std::int64_t block = 0; block < blocks; ++block) {
    std::fill(held.begin(), held.end(), 0);
    visit_(block, [&](std::int32_t node) {
      for (const std::int32_t rank : holders.of(node)) ++held[rank];
    });
    const auto owner = static_cast<std::int32_t>(std::max_element(held.begin(), held.end()) - held.begin());
    owner_.push_back(owner);
    visit_(block, [&](std::int32_t node) {
      if (!holders.has(node, owner)) holders.add(node, owner);
    });
  }
}

}  // namespace pinball
