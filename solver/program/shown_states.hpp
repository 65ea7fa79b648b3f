#pragma once

#include <cstdint>

/// What pages of several runs show of their bodies, beside each other.
namespace pinball {

/// Evenly spaced over a run, with its first and its last.
inline constexpr int shown_states = 9;
/// Of all runs of a comparison, or of one of a study: states take 300 bytes an element each, of memory or of a disk.
inline constexpr std::int64_t most_elements_shown = 100'000;

}  // namespace pinball
