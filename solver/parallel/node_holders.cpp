#include "node_holders.hpp"

#include <algorithm>

namespace pinball {

namespace {

/// visit(node, rank) for all corners of elements.
template <class S, class Visit>
void for_each_corner(const Model<S>& model, const std::vector<std::int32_t>& rank_of_tile, const Visit& visit) {
  for (std::int32_t tile = 0; tile < model.tile_count(); ++tile) {
    for (const std::int64_t slot : model.slots_of(tile)) {
      for (const std::int32_t node : model.elements.corners(slot)) visit(node, rank_of_tile[tile]);
    }
  }
}

}  // namespace

template <class S>
NodeHolders::NodeHolders(const Model<S>& model, const std::vector<std::int32_t>& rank_of_tile)
    : single_(model.nodes.count, -1) {
  std::vector<std::uint8_t> several(model.nodes.count, 0);
  for_each_corner(model, rank_of_tile, [&](std::int32_t node, std::int32_t rank) {
    if (single_[node] < 0) single_[node] = rank;
    if (single_[node] != rank) several[node] = 1;
  });
  Pairs pairs;
  for_each_corner(model, rank_of_tile, [&](std::int32_t node, std::int32_t rank) {
    if (several[node] != 0 && (pairs.empty() || pairs.back() != std::pair(node, rank))) pairs.emplace_back(node, rank);
  });
  set_shared(std::move(pairs));
}

void NodeHolders::set_shared(Pairs pairs) {
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  shared_.clear();
  first_.clear();
  ranks_.clear();
  for (const auto& [node, rank] : pairs) {
    if (shared_.empty() || shared_.back() != node) {
      single_[node] = -1 - static_cast<std::int32_t>(shared_.size());
      shared_.push_back(node);
      first_.push_back(static_cast<std::int32_t>(ranks_.size()));
    }
    ranks_.push_back(rank);
  }
  first_.push_back(static_cast<std::int32_t>(ranks_.size()));
}

bool NodeHolders::has(std::int64_t node, std::int32_t rank) const { return std::ranges::binary_search(of(node), rank); }

void NodeHolders::take_more() {
  Pairs pairs = std::move(more_);
  more_.clear();
  std::erase_if(pairs, [this](const auto& pair) { return has(pair.first, pair.second); });
  const std::size_t added = pairs.size();
  for (std::size_t p = 0; p < added; ++p) {  // their ranks so far
    const std::int32_t node = pairs[p].first;
    for (const std::int32_t rank : of(node)) pairs.emplace_back(node, rank);
  }
  for (const std::int32_t node : shared_) {
    for (const std::int32_t rank : of(node)) pairs.emplace_back(node, rank);
  }
  set_shared(std::move(pairs));
}

template NodeHolders::NodeHolders(const Model<double>&, const std::vector<std::int32_t>&);
template NodeHolders::NodeHolders(const Model<float>&, const std::vector<std::int32_t>&);

}  // namespace pinball
