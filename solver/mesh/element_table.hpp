#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pinball {

/// Spreads the bits of a number.
inline std::uint64_t mixed_bits(std::uint64_t x) {
  x = (x ^ (x >> 31)) * 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 29)) * 0xbf58476d1ce4e5b9u;
  return x ^ (x >> 32);
}

/// The same for two elements that have the same nodes, in whatever order.
inline std::uint64_t key_of_nodes(const std::array<std::int32_t, 8>& nodes) {
  std::uint64_t key = 0;
  for (const std::int32_t node : nodes) key += mixed_bits(static_cast<std::uint64_t>(node) + 1);
  return mixed_bits(key);
}

/// Places found again by their key, of which several may have the same: what they are compared by is the user's.
class PlaceTable {
 public:
  /// most: so many will be added, or fewer.
  explicit PlaceTable(std::size_t most) : slots_(std::bit_ceil(2 * most + 16), -1) {}

  /// The place that stands there already and is the same; else this one, from now on.
  template <class Same>
  std::int32_t find_or_add(std::uint64_t key, std::int32_t place, const Same& same) {
    for (std::size_t slot = key & (slots_.size() - 1);; slot = (slot + 1) & (slots_.size() - 1)) {
      if (slots_[slot] < 0) {
        slots_[slot] = place;
        return place;
      }
      if (same(slots_[slot])) return slots_[slot];
    }
  }

  /// The place that is the same; -1: there is none.
  template <class Same>
  std::int32_t find(std::uint64_t key, const Same& same) const {
    for (std::size_t slot = key & (slots_.size() - 1); slots_[slot] >= 0; slot = (slot + 1) & (slots_.size() - 1)) {
      if (same(slots_[slot])) return slots_[slot];
    }
    return -1;
  }

 private:
  std::vector<std::int32_t> slots_;
};

}  // namespace pinball
