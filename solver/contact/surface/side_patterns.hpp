#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace pinball {

/// Groups of things that belong to the same sides: a number for each combination of sides that there is.
class SidePatterns {
 public:
  static constexpr std::int32_t none = 0;  ///< of what belongs to no side

  SidePatterns() : sides_(1), number_{{{}, none}} {}

  /// The group of what belongs to the sides of a group and to one more.
  std::int32_t with(std::int32_t group, std::int32_t side) { return joined(group, number({side})); }
  /// To the sides of either of two groups.
  std::int32_t joined(std::int32_t a, std::int32_t b);
  /// To those sides below `end` that both have.
  std::int32_t common(std::int32_t a, std::int32_t b, std::int32_t end);
  bool has(std::int32_t group, std::int32_t side) const;
  std::int32_t count() const { return sides_.size(); }

 private:
  using Sides = std::vector<std::int32_t>;  ///< sorted
  std::int32_t number(const Sides& sides);

  std::vector<Sides> sides_;  ///< per group
  std::map<Sides, std::int32_t> number_;
  std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> joined_;
};

}  // namespace pinball
