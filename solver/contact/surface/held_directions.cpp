#include "held_directions.hpp"

namespace pinball {

HeldDirections::HeldDirections(std::int32_t node_count, std::span<const HeldDirection> held)
    : directions_(held.size()), first_(static_cast<std::size_t>(node_count) + 1, 0) {
  for (const HeldDirection& h : held) ++first_[h.node + 1];
  for (std::size_t n = 1; n < first_.size(); ++n) first_[n] += first_[n - 1];
  std::vector<std::int32_t> next(first_.begin(), first_.end() - 1);  // in the order given
  for (const HeldDirection& h : held) {
    directions_[next[h.node]++] = h.normal;
  }
}

}  // namespace pinball
