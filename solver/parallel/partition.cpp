#include "partition.hpp"

#include <algorithm>
#include <numeric>
#include <random>
#include <utility>

namespace pinball {

namespace {

/// Consecutive tiles, as much work for each rank as whole tiles allow.
std::vector<std::int32_t> ranges(const std::vector<std::int32_t>& work, std::int64_t ranks) {
  const std::int64_t all = std::accumulate(work.begin(), work.end(), std::int64_t{0});
  std::vector<std::int32_t> rank_of;
  std::int64_t before = 0;
  for (const std::int32_t of_tile : work) {  // by the middle of the tile
    const std::int64_t rank = (2 * before + of_tile) * ranks / (2 * all);
    rank_of.push_back(static_cast<std::int32_t>(std::min(rank, ranks - 1)));
    before += of_tile;
  }
  return rank_of;
}

std::vector<std::int32_t> at_random(std::size_t tiles, int ranks, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  std::vector<std::int32_t> rank_of(tiles);
  for (std::int32_t& rank : rank_of) rank = static_cast<std::int32_t>(generator() % static_cast<std::uint64_t>(ranks));
  return rank_of;
}

/// The tiles of each node, once each: node after node.
template <class S>
std::vector<std::pair<std::int32_t, std::int32_t>> tiles_of_nodes(const Model<S>& model) {
  std::vector<std::pair<std::int32_t, std::int32_t>> pairs;
  std::vector<std::int32_t> last(model.nodes.count, -1);
  for (std::int32_t tile = 0; tile < model.tile_count(); ++tile) {
    for (const std::int64_t slot : model.slots_of(tile)) {
      for (const std::int32_t node : model.elements.corners(slot)) {
        if (std::exchange(last[node], tile) != tile) pairs.emplace_back(node, tile);
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

template <class S>
TileGraph graph_of(const Model<S>& model) {
  const std::vector<std::pair<std::int32_t, std::int32_t>> tiles = tiles_of_nodes(model);
  std::vector<std::pair<std::int32_t, std::int32_t>> edges;  // each once for each node, in both directions
  for (std::size_t begin = 0, end = 0; begin < tiles.size(); begin = end) {
    while (end < tiles.size() && tiles[end].first == tiles[begin].first) ++end;
    for (std::size_t a = begin; a < end; ++a) {
      for (std::size_t b = begin; b < end; ++b) {
        if (a != b) edges.emplace_back(tiles[a].second, tiles[b].second);
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  TileGraph graph;
  graph.work = work_of_tiles(model);
  graph.first.assign(graph.work.size() + 1, 0);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (e > 0 && edges[e] == edges[e - 1]) {
      ++graph.shared.back();
      continue;
    }
    graph.neighbour.push_back(edges[e].second);
    graph.shared.push_back(1);
    ++graph.first[static_cast<std::size_t>(edges[e].first) + 1];
  }
  std::partial_sum(graph.first.begin(), graph.first.end(), graph.first.begin());
  return graph;
}

}  // namespace

template <class S>
std::vector<std::int32_t> elements_of_tiles(const Model<S>& model) {
  std::vector<std::int32_t> elements(model.tile_count(), 0);
  for (std::int32_t tile = 0; tile < model.tile_count(); ++tile) {
    for (const std::int64_t slot : model.slots_of(tile)) elements[tile] += model.is_padding(slot) ? 0 : 1;
  }
  return elements;
}

template <class S>
std::vector<std::int32_t> work_of_tiles(const Model<S>& model) {
  std::vector<std::int32_t> work = elements_of_tiles(model);
  if (model.tile_levels.empty()) return work;
  const int top = std::ranges::max_element(model.tile_levels, {}, &TileLevels::highest)->highest;
  for (std::size_t t = 0; t < work.size(); ++t) work[t] <<= top - model.tile_levels[t].highest;
  return work;
}

template <class S>
std::vector<std::int32_t> ranks_of_tiles(const Model<S>& model, const Ranks& ranks) {
  switch (ranks.partition.by) {
    case Partition::By::graph:
      return ranks.cut(graph_of(model));
    case Partition::By::random:
      return at_random(model.tile_part.size(), ranks.count(), ranks.partition.seed);
    case Partition::By::tiles:
      break;
  }
  return ranges(work_of_tiles(model), ranks.count());
}

template std::vector<std::int32_t> elements_of_tiles(const Model<double>&);
template std::vector<std::int32_t> elements_of_tiles(const Model<float>&);
template std::vector<std::int32_t> work_of_tiles(const Model<double>&);
template std::vector<std::int32_t> work_of_tiles(const Model<float>&);
template std::vector<std::int32_t> ranks_of_tiles(const Model<double>&, const Ranks&);
template std::vector<std::int32_t> ranks_of_tiles(const Model<float>&, const Ranks&);

}  // namespace pinball
