#include "corner_plan.hpp"

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>

#include <solver/model/corner_order.hpp>

namespace pinball {

CornerPlan::Neighbour& CornerPlan::neighbour(std::int32_t rank) {
  const auto found = std::ranges::find(neighbours, rank, &Neighbour::rank);
  if (found != neighbours.end()) return *found;
  neighbours.push_back({});
  neighbours.back().rank = rank;
  return neighbours.back();
}

template <class S>
CornerPlan::CornerPlan(const Model<S>& model, const std::vector<std::int32_t>& rank_of_tile, const NodeHolders& holders,
                       std::int32_t self) {
  struct Source {
    std::int32_t node, rank;  // place of the node in holders.shared(); who has the force
    std::int64_t number;      // in `own`, or of what that rank sends to this one
    std::int32_t tile;
  };
  records_of_tile.assign(rank_of_tile.size(), 0);
  std::vector<Source> sources;
  std::vector<std::pair<std::int32_t, std::int32_t>> pairs;  // who sends to whom
  for_each_corner_in_order(model, [&](std::int32_t tile, std::int64_t slot, int i) {
    if (model.is_rigid(tile)) return;  // no kernel works it
    const std::int32_t node = model.elements.corner[model.elements.at(slot, i, 8)];
    if (!holders.is_shared(node)) return;
    const std::span<const std::int32_t> all = holders.of(node);
    records_of_tile[tile] += std::ssize(all) - 1;
    const std::int32_t from = rank_of_tile[tile], place = holders.shared_place(node);
    for (const std::int32_t to : all) {
      if (to != from && (pairs.empty() || pairs.back() != std::pair(from, to))) pairs.emplace_back(from, to);
    }
    if (from == self) {
      const auto number = static_cast<std::int32_t>(own.size());
      own.push_back({slot, i, node, tile});
      sources.push_back({place, self, number, tile});
      for (const std::int32_t to : all) {
        if (to != self) neighbour(to).sent.push_back(number);
      }
    } else if (holders.has(node, self)) {
      sources.push_back({place, from, neighbour(from).count++, tile});
    }
  });
  records = std::reduce(records_of_tile.begin(), records_of_tile.end());
  std::ranges::sort(pairs);
  messages = std::unique(pairs.begin(), pairs.end()) - pairs.begin();
  for (Neighbour& of : neighbours) {
    of.first = received;
    received += of.count;
  }
  std::ranges::stable_sort(sources, {}, &Source::node);
  for (std::size_t s = 0; s < sources.size(); ++s) {
    const Source& of = sources[s];
    if (s == 0 || of.node != sources[s - 1].node) {
      nodes.push_back(holders.shared()[of.node]);
      first.push_back(static_cast<std::int64_t>(s));
    }
    source.push_back(of.rank == self ? of.number : -1 - (neighbour(of.rank).first + of.number));
    tile_of_source.push_back(of.tile);
  }
  first.push_back(static_cast<std::int64_t>(sources.size()));
}

std::size_t CornerPlan::bytes() const {
  std::size_t sum = own.size() * sizeof(Corner) + nodes.size() * sizeof(std::int32_t) +
                    tile_of_source.size() * sizeof(std::int32_t) +
                    (first.size() + source.size() + records_of_tile.size()) * sizeof(std::int64_t);
  for (const Neighbour& of : neighbours) sum += of.sent.size() * sizeof(std::int32_t);
  return sum;
}

template CornerPlan::CornerPlan(const Model<double>&, const std::vector<std::int32_t>&, const NodeHolders&,
                                std::int32_t);
template CornerPlan::CornerPlan(const Model<float>&, const std::vector<std::int32_t>&, const NodeHolders&,
                                std::int32_t);

}  // namespace pinball
