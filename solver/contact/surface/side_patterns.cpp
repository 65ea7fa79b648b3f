#include "side_patterns.hpp"

#include <algorithm>
#include <iterator>

namespace pinball {

std::int32_t SidePatterns::number(const Sides& sides) {
  const auto [found, is_new] = number_.try_emplace(sides, count());
  if (is_new) sides_.push_back(sides);
  return found->second;
}

std::int32_t SidePatterns::joined(std::int32_t a, std::int32_t b) {
  if (a == b || b == none) return a;
  if (a == none) return b;
  const std::pair key{std::min(a, b), std::max(a, b)};
  if (const auto found = joined_.find(key); found != joined_.end()) return found->second;
  Sides all;
  std::set_union(sides_[a].begin(), sides_[a].end(), sides_[b].begin(), sides_[b].end(), std::back_inserter(all));
  return joined_[key] = number(all);
}

std::int32_t SidePatterns::common(std::int32_t a, std::int32_t b, std::int32_t end) {
  Sides both;
  std::set_intersection(sides_[a].begin(), sides_[a].end(), sides_[b].begin(), sides_[b].end(),
                        std::back_inserter(both));
  both.erase(std::lower_bound(both.begin(), both.end(), end), both.end());
  return number(both);
}

bool SidePatterns::has(std::int32_t group, std::int32_t side) const {
  return std::binary_search(sides_[group].begin(), sides_[group].end(), side);
}

}  // namespace pinball
