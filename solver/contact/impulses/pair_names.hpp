#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pinball {

/// Places of pairs by their two names: a hash table with open addresses, at most half full.
class PairNames {
 public:
  static constexpr std::size_t none = ~std::size_t(0);

  void reset(std::size_t pairs) { table_.assign(pairs == 0 ? 0 : std::bit_ceil(2 * pairs), -1); }
  /// Each pair once. place: below 2^31.
  void add(std::int32_t first, std::int32_t second, std::size_t place) {
    std::size_t slot = start(first, second);
    while (table_[slot] >= 0) slot = next(slot);
    table_[slot] = place;
  }
  /// is(place): whether the pair there has these names. Returns its place, or none.
  template <class Is>
  std::size_t find(std::int32_t first, std::int32_t second, const Is& is) const {
    if (table_.empty()) return none;
    for (std::size_t slot = start(first, second); table_[slot] >= 0; slot = next(slot)) {
      const std::size_t place = table_[slot];
      if (is(place)) return place;
    }
    return none;
  }
  std::size_t bytes() const { return table_.capacity() * sizeof(table_[0]); }

 private:
  std::size_t start(std::int32_t first, std::int32_t second) const {
    const auto names = std::uint64_t(static_cast<std::uint32_t>(first)) << 32 | static_cast<std::uint32_t>(second);
    const std::uint64_t mixed = names * 0x9e3779b97f4a7c15;  // 2^64 over the golden ratio: its high bits are well mixed
    return (mixed >> 32) & (table_.size() - 1);
  }
  std::size_t next(std::size_t slot) const { return (slot + 1) & (table_.size() - 1); }

  std::vector<std::int32_t> table_;  ///< places, or -1
};

}  // namespace pinball
