#include "pinball_entries.hpp"

#include <solver/base/packs.hpp>

namespace pinball {

namespace {

/// for_each: calls its argument with each thing and an entry of it, in the order of the lists; twice the same.
template <class ForEach>
EntryLists lists_of(std::size_t things, const ForEach& for_each) {
  EntryLists lists;
  lists.first.assign(things + 1, 0);
  for_each([&](std::size_t thing, std::uint32_t) { ++lists.first[thing + 1]; });
  for (std::size_t t = 0; t < things; ++t) lists.first[t + 1] += lists.first[t];
  lists.entry.resize(lists.first.back());
  std::vector<std::uint32_t> next(lists.first.begin(), lists.first.end() - 1);
  for_each([&](std::size_t thing, std::uint32_t entry) { lists.entry[next[thing]++] = entry; });
  return lists;
}

}  // namespace

EntryLists entries_of_pinballs(std::span<const PairPiece> pieces, const std::int32_t* first, const std::int32_t* second,
                               std::int32_t pinballs) {
  return lists_of(pinballs, [&](const auto& put) {
    for (const std::uint32_t as_first : {0U, 1U}) {
      const std::int32_t* const pinball = as_first != 0 ? first : second;
      for (const PairPiece& piece : pieces) {
        for (std::int64_t place = piece.begin; place < piece.end; ++place) {
          put(pinball[place], static_cast<std::uint32_t>(2 * place) + as_first);
        }
      }
    }
  });
}

EntryLists NodeEntries::of(std::span<const std::int32_t> nodes, std::int32_t node_count, const std::int32_t* corner,
                           int row, std::span<const std::int32_t> tile_first, std::span<const std::int32_t> tiles) {
  number_.resize(node_count);
  for (std::size_t i = 0; i < nodes.size(); ++i) number_[nodes[i]] = static_cast<std::int32_t>(i);
  return lists_of(nodes.size(), [&](const auto& put) {
    for (const std::int32_t tile : tiles) {
      for (std::int32_t p = tile_first[tile]; p < tile_first[tile + 1]; ++p) {
        for (int i = 0; i < 8; ++i) put(number_[corner[place_in_packs(row, p, i, 8)]], p);
      }
    }
  });
}

}  // namespace pinball
