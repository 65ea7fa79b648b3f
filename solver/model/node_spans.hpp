#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pinball {

/// Nodes in pieces of this many, in the order of the store: what threads share, and what is left out of a step as a
/// whole.
inline constexpr std::int32_t nodes_per_span = 128;

inline std::int32_t span_count(std::int32_t nodes) { return (nodes + nodes_per_span - 1) / nodes_per_span; }

/// The spans that are integrated in a step.
struct DueSpans {
  const std::vector<std::int8_t>* level_of_span = nullptr;  ///< null: all are due
  int level = 0;                                            ///< the highest that is due

  bool contain(std::int64_t span) const { return level_of_span == nullptr || (*level_of_span)[span] <= level; }
  /// Steps that the nodes of a span make at once.
  int steps(std::int64_t span) const { return level_of_span == nullptr ? 1 : 1 << (*level_of_span)[span]; }
};

}  // namespace pinball
