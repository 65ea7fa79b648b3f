#include "due_corners.hpp"

#include <algorithm>
#include <numeric>

namespace pinball {

namespace {

/// Per level, from the number on it the number on it and below.
void add_up(std::vector<std::int64_t>& of_level) {
  std::partial_sum(of_level.begin(), of_level.end(), of_level.begin());
}

}  // namespace

DueCorners::DueCorners(const CornerPlan& plan, const std::vector<int>& level_of_tile) {
  const std::size_t levels = level_of_tile.empty() ? 1 : 1 + *std::ranges::max_element(level_of_tile);
  const auto level_of = [&](std::int32_t tile) { return level_of_tile.empty() ? 0 : level_of_tile[tile]; };
  const auto none = std::vector<std::int64_t>(levels, 0);

  own.resize(levels);
  for (std::size_t r = 0; r < plan.own.size(); ++r)
    own[level_of(plan.own[r].tile)].push_back(static_cast<std::int32_t>(r));
  records = none;
  for (std::size_t t = 0; t < plan.records_of_tile.size(); ++t)
    records[level_of(static_cast<std::int32_t>(t))] += plan.records_of_tile[t];
  add_up(records);

  // Levels of what is received, in the order of the plan.
  std::vector<std::int32_t> received(plan.received);
  for (std::size_t s = 0; s < plan.source.size(); ++s) {
    if (plan.source[s] < 0) received[-1 - plan.source[s]] = level_of(plan.tile_of_source[s]);
  }
  std::vector<std::int64_t> place(received.size());  // of what is received, by level
  for (const CornerPlan::Neighbour& of : plan.neighbours) {
    Neighbour& due = neighbours.emplace_back(Neighbour{of.sent, none, none});
    const auto level_of_own = [&](std::int32_t r) { return level_of(plan.own[r].tile); };
    std::ranges::stable_sort(due.sent, {}, level_of_own);
    for (const std::int32_t r : due.sent) ++due.sent_up_to[level_of_own(r)];
    for (std::int64_t n = of.first; n < of.first + of.count; ++n) ++due.received_up_to[received[n]];
    add_up(due.sent_up_to);
    add_up(due.received_up_to);
    std::vector<std::int64_t> next(levels, of.first);
    for (std::size_t level = 1; level < levels; ++level) next[level] += due.received_up_to[level - 1];
    for (std::int64_t n = of.first; n < of.first + of.count; ++n) place[n] = next[received[n]]++;
  }

  for (std::size_t s = 0; s < plan.source.size(); ++s) {
    const std::int64_t source = plan.source[s];
    sources.push_back({source >= 0 ? source : -1 - place[-1 - source], level_of(plan.tile_of_source[s])});
  }
  for (std::size_t n = 0; n < plan.nodes.size(); ++n)
    std::stable_sort(sources.begin() + plan.first[n], sources.begin() + plan.first[n + 1],
                     [](const Source& a, const Source& b) { return a.level > b.level; });
}

std::size_t DueCorners::bytes() const {
  std::size_t sum = sources.size() * sizeof(Source);
  for (const std::vector<std::int32_t>& of : own) sum += of.size() * sizeof(std::int32_t);
  for (const Neighbour& of : neighbours) sum += of.sent.size() * sizeof(std::int32_t);
  return sum;
}

}  // namespace pinball
