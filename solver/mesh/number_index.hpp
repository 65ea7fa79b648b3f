#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pinball {

/// Finds the place of a number among numbers in any order. Numbers that are nearly consecutive, as those of most meshes
/// are, take a table; others a sorted list.
class NumberIndex {
 public:
  NumberIndex() = default;
  explicit NumberIndex(const std::vector<std::int64_t>& numbers) {
    if (numbers.empty()) return;
    const auto [low, high] = std::minmax_element(numbers.begin(), numbers.end());
    first_ = *low;
    const std::uint64_t range = static_cast<std::uint64_t>(*high) - static_cast<std::uint64_t>(*low);
    if (range < 2 * numbers.size() + 1024) {
      table_.assign(range + 1, -1);
      for (std::size_t i = 0; i < numbers.size(); ++i) {
        std::int32_t& place = table_[numbers[i] - first_];
        if (place >= 0 && repeated_ < 0) repeated_ = i;
        if (place < 0) place = i;
      }
      return;
    }
    sorted_.reserve(numbers.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) sorted_.emplace_back(numbers[i], static_cast<std::int32_t>(i));
    std::sort(sorted_.begin(), sorted_.end());
    for (std::size_t i = 1; i < sorted_.size(); ++i) {
      if (sorted_[i].first == sorted_[i - 1].first && (repeated_ < 0 || sorted_[i].second < repeated_))
        repeated_ = sorted_[i].second;
    }
  }

  /// Place of the first of that number; -1: none.
  std::int32_t find(std::int64_t number) const {
    if (!table_.empty()) {
      const bool inside = number >= first_ && number - first_ < std::ssize(table_);
      return inside ? table_[number - first_] : -1;
    }
    const auto found = std::lower_bound(sorted_.begin(), sorted_.end(), std::pair{number, std::int32_t{-1}});
    return found != sorted_.end() && found->first == number ? found->second : -1;
  }
  /// Place of the first number that stands before already; -1: none.
  std::int32_t repeated() const { return repeated_; }

 private:
  std::int64_t first_ = 0;
  std::vector<std::int32_t> table_;
  std::vector<std::pair<std::int64_t, std::int32_t>> sorted_;
  std::int32_t repeated_ = -1;
};

}  // namespace pinball
