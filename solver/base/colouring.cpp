#include "colouring.hpp"

#include <algorithm>
#include <atomic>
#include <bit>
#include <utility>

#include "error.hpp"
#include "lists_in_order.hpp"
#include "message.hpp"

namespace pinball {
namespace {

using Hexahedron = std::array<std::int32_t, 8>;

/// Of each tile the nodes that other tiles touch, too, each once: for all others no colour is taken.
std::vector<std::vector<std::int32_t>> shared_nodes(const std::vector<std::int32_t>& offsets,
                                                    const std::vector<Hexahedron>& hexahedra, std::int32_t node_count) {
  constexpr std::int32_t nobody = -1, several = -2;
  std::vector<std::int32_t> whose(node_count, nobody);
  const std::int64_t tiles = std::ssize(offsets) - 1;
  parallel_for("whose nodes", RangePolicy<>{0, tiles}, [&](std::int64_t index) {
    const std::int32_t tile = index;
    for (std::int32_t element = offsets[tile]; element < offsets[tile + 1]; ++element) {
      for (const std::int32_t node : hexahedra[element]) {
        const std::atomic_ref of(whose[node]);
        std::int32_t before = of.load(std::memory_order_relaxed);
        if (before == tile || before == several) continue;
        if (before == nobody && of.compare_exchange_strong(before, tile, std::memory_order_relaxed)) continue;
        of.store(several, std::memory_order_relaxed);
      }
    }
  });
  std::vector<std::vector<std::int32_t>> shared(tiles);
  parallel_for("shared nodes", RangePolicy<>{0, tiles}, [&](std::int64_t tile) {
    std::vector<std::int32_t>& nodes = shared[tile];
    for (std::int32_t element = offsets[tile]; element < offsets[tile + 1]; ++element) {
      for (const std::int32_t node : hexahedra[element]) {
        if (whose[node] == several) nodes.push_back(node);
      }
    }
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  });
  return shared;
}

/// For each node a bitmask of the colours of the tiles that touch it, of as many 64-bit words as the colours need.
class NodeColours {
 public:
  NodeColours(const std::vector<std::int32_t>& offsets, const std::vector<Hexahedron>& hexahedra,
              std::int32_t node_count)
      : nodes_(shared_nodes(offsets, hexahedra, node_count)), masks_(node_count, 0), used_(1, 0) {}

  /// Finds the colours that the tile's nodes carry; `taken` asks about the result.
  void gather(std::int32_t tile) {
    used_.assign(words_, 0);
    visit(tile, [&](const std::uint64_t* mask) {
      for (std::size_t word = 0; word < words_; ++word) used_[word] |= mask[word];
    });
  }

  bool taken(std::int32_t colour) const { return used_[colour / 64] >> (colour % 64) & 1u; }

  /// Lowest colour that is not taken; widens the masks if all are.
  std::int32_t first_free() {
    for (std::size_t word = 0; word < words_; ++word)
      if (~used_[word] != 0) return 64 * word + std::countr_one(used_[word]);
    const std::int32_t colour = 64 * words_;
    widen();
    return colour;
  }

  void add(std::int32_t tile, std::int32_t colour) {
    visit(tile, [&](std::uint64_t* mask) { mask[colour / 64] |= std::uint64_t{1} << (colour % 64); });
  }

  /// Only one tile of a colour touches a node, so that its bit can go with it.
  void remove(std::int32_t tile, std::int32_t colour) {
    visit(tile, [&](std::uint64_t* mask) { mask[colour / 64] &= ~(std::uint64_t{1} << (colour % 64)); });
  }

 private:
  template <class Action>
  void visit(std::int32_t tile, Action action) {
    for (const std::int32_t node : nodes_[tile]) action(&masks_[node * words_]);
  }

  void widen() {
    std::vector<std::uint64_t> wider(2 * masks_.size(), 0);
    for (std::size_t i = 0; i < masks_.size(); ++i) wider[i / words_ * 2 * words_ + i % words_] = masks_[i];
    masks_ = std::move(wider);
    words_ *= 2;
    used_.resize(words_, 0);
  }

  std::vector<std::vector<std::int32_t>> nodes_;
  std::size_t words_ = 1;
  std::vector<std::uint64_t> masks_;  // [nodes][words]
  std::vector<std::uint64_t> used_;   // [words]
};

void check(const std::vector<std::int32_t>& offsets, const std::vector<Hexahedron>& hexahedra,
           std::int32_t node_count) {
  bool ascending = !offsets.empty() && offsets.front() == 0 && offsets.back() == std::ssize(hexahedra);
  for (std::size_t i = 1; i < offsets.size(); ++i) ascending = ascending && offsets[i - 1] <= offsets[i];
  if (!ascending)
    throw InputError(
        message_of("colouring: tile offsets do not ascend from 0 to the number of elements, ", hexahedra.size()));
  const auto is_foreign = [node_count](std::int32_t node) { return node < 0 || node >= node_count; };
  const std::int64_t bad = first_where("nodes of elements", std::ssize(hexahedra),
                                       [&](std::int64_t e) { return std::ranges::any_of(hexahedra[e], is_foreign); });
  if (bad == std::ssize(hexahedra)) return;
  throw InputError(message_of("mesh: element ", bad, ": node index ", *std::ranges::find_if(hexahedra[bad], is_foreign),
                              " is not among the ", node_count, " nodes"));
}

/// First-fit leaves few tiles in the last colours. Tiles of colours above the mean move to the emptiest colour that is
/// free for them, if that evens the two out.
void balance(NodeColours& nodes, std::vector<std::int32_t>& colour, std::vector<std::int32_t>& count) {
  const std::int32_t tiles = colour.size();
  const std::int32_t colours = count.size();
  for (std::int32_t tile = 0; tile < tiles; ++tile) {
    const std::int32_t from = colour[tile];
    if (std::int64_t{count[from]} * colours <= tiles) continue;
    nodes.gather(tile);
    std::int32_t to = from;
    for (std::int32_t candidate = 0; candidate < colours; ++candidate)
      if (!nodes.taken(candidate) && count[candidate] < count[to]) to = candidate;
    if (count[to] + 1 >= count[from]) continue;
    nodes.remove(tile, from);
    nodes.add(tile, to);
    --count[from];
    ++count[to];
    colour[tile] = to;
  }
}

}  // namespace

Colouring colour_tiles(const std::vector<std::int32_t>& tile_offsets_in_elements,
                       const std::vector<Hexahedron>& hexahedra, std::int32_t node_count) {
  check(tile_offsets_in_elements, hexahedra, node_count);
  NodeColours nodes(tile_offsets_in_elements, hexahedra, node_count);
  std::vector<std::int32_t> colour(tile_offsets_in_elements.size() - 1);
  std::vector<std::int32_t> count;
  for (std::size_t tile = 0; tile < colour.size(); ++tile) {
    const std::int32_t index = tile;
    nodes.gather(index);
    colour[tile] = nodes.first_free();
    nodes.add(index, colour[tile]);
    if (colour[tile] == std::ssize(count)) count.push_back(0);
    ++count[colour[tile]];
  }
  balance(nodes, colour, count);

  Colouring result;
  result.colour_offsets.assign(count.size() + 1, 0);
  for (std::size_t c = 0; c < count.size(); ++c) result.colour_offsets[c + 1] = result.colour_offsets[c] + count[c];
  result.items.resize(colour.size());
  std::vector<std::int32_t> next = result.colour_offsets;
  for (std::size_t tile = 0; tile < colour.size(); ++tile) result.items[next[colour[tile]]++] = tile;
  return result;
}

}  // namespace pinball
