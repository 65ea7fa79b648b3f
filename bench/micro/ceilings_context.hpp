#pragma once

#include <benchmark/benchmark.h>
#include <fmt/core.h>

#include <initializer_list>

#include "ceilings.hpp"

namespace pinball::bench {

/// Measures what the machine gives with these numbers of threads, for the head of the results.
inline void add_ceilings_to_context(std::initializer_list<int> threads) {
  for (const int n : threads) {
    benchmark::AddCustomContext(fmt::format("triad_GB_per_s_{}_threads", n),
                                fmt::format("{:.1f}", memory_bandwidth(n) * 1e-9));
    benchmark::AddCustomContext(fmt::format("peak_GFLOP_per_s_{}_threads", n),
                                fmt::format("{:.1f}", arithmetic_peak(n) * 1e-9));
  }
}

}  // namespace pinball::bench
