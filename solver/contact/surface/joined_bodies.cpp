#include "joined_bodies.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <utility>

#include <kernels/exec.hpp>
#include <solver/base/lists_in_order.hpp>

namespace pinball {

namespace {

using BodyPairs = std::vector<std::pair<std::int32_t, std::int32_t>>;

/// Calls visit(element, piece) for all that are alive.
template <class S, class Visit>
void for_each_alive(const SurfaceSource<S>& source, const Surface& surface, const Visit& visit) {
  parallel_for("bodies of elements", RangePolicy<>{0, fixed_pieces}, [&](std::int64_t piece) {
    const std::int64_t end = surface.slots() * (piece + 1) / fixed_pieces;
    for (std::int64_t slot = surface.slots() * piece / fixed_pieces; slot < end; ++slot) {
      if (surface.alive(slot)) visit(source.element(slot), piece);
    }
  });
}

/// Pairs of bodies with a common node: of each node its lowest body and any other.
template <class S>
BodyPairs joined_pairs(const SurfaceSource<S>& source, const Surface& surface,
                       const std::vector<std::int32_t>& lowest) {
  std::array<BodyPairs, fixed_pieces> found;
  for_each_alive(source, surface, [&](const ContactElement& element, std::int64_t piece) {
    for (const std::int32_t node : element.corners) {
      const std::pair pair{lowest[node], element.body};
      if (pair.first != pair.second && (found[piece].empty() || found[piece].back() != pair)) {
        found[piece].push_back(pair);
      }
    }
  });
  BodyPairs all;
  for (const BodyPairs& some : found) all.insert(all.end(), some.begin(), some.end());
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

}  // namespace

template <class S>
JoinedBodies::JoinedBodies(const SurfaceSource<S>& source, const Surface& surface) {
  std::vector<std::int32_t> lowest(source.node_count, std::numeric_limits<std::int32_t>::max());
  std::array<std::int32_t, fixed_pieces> highest{};
  for_each_alive(source, surface, [&](const ContactElement& element, std::int64_t piece) {
    for (const std::int32_t node : element.corners) keep_lowest(lowest[node], element.body);
    highest[piece] = std::max(highest[piece], element.body);
  });
  const std::int32_t last = *std::max_element(highest.begin(), highest.end());
  if (last == 0) return;
  const BodyPairs pairs = joined_pairs(source, surface, lowest);
  if (pairs.empty()) return;
  first_.resize(last + 1);
  std::iota(first_.begin(), first_.end(), 0);
  const auto root = [this](std::int32_t body) {
    while (first_[body] != body) body = first_[body];
    return body;
  };
  for (const auto& [a, b] : pairs) {
    const auto [low, high] = std::minmax({root(a), root(b)});
    first_[high] = low;
  }
  for (std::int32_t body = 0; body <= last; ++body) first_[body] = root(body);  // no number is higher than its own
}

template JoinedBodies::JoinedBodies(const SurfaceSource<double>&, const Surface&);
template JoinedBodies::JoinedBodies(const SurfaceSource<float>&, const Surface&);

}  // namespace pinball
