#pragma once

#include <cstdint>

#if defined(_OPENMP)
#include <omp.h>
#endif

#include "host_space.hpp"

namespace pinball {

/// More than any machine has.
inline constexpr int most_threads = 4096;

struct Serial {
  using memory_space = HostSpace;
  static int concurrency() { return 1; }
  static void set_concurrency(int /*threads*/) {}
};

#if defined(_OPENMP)
/// Regions of OpenMP's own threads, who wait for each other as the environment of the host says.
struct OpenMP {
  using memory_space = HostSpace;
  static int concurrency() { return omp_get_max_threads(); }
  static void set_concurrency(int threads) { omp_set_num_threads(threads); }
};

/// Threads of this library, as many as OpenMP would take in the same place. They wait for each other briefly, whatever
/// the host has set, and not at all for one that has no processor (thread_team.hpp).
struct Threads {
  using memory_space = HostSpace;
  static int concurrency() { return omp_get_max_threads(); }
  static void set_concurrency(int threads) { omp_set_num_threads(threads); }
  /// Of a region that begins here: within one of the host that is alone allowed to be parallel, 1.
  static int of_region() {
    if (omp_get_active_level() >= omp_get_max_active_levels()) return 1;
    const int threads = omp_get_max_threads(), limit = omp_get_thread_limit();
    const int most = limit < most_threads ? limit : most_threads;
    return threads < most ? threads : most;
  }
};

#if defined(PINBALL_OPENMP_REGIONS)
using DefaultExecutionSpace = OpenMP;
#else
using DefaultExecutionSpace = Threads;
#endif
#else
using OpenMP = Serial;
using Threads = Serial;
using DefaultExecutionSpace = Serial;
#endif

/// Half-open range of indices on an execution space.
template <class Space = DefaultExecutionSpace>
struct RangePolicy {
  std::int64_t begin;
  std::int64_t end;
};

/// Waits for all work on a space. That of host spaces, and of Mock, is done when the call that gives it returns.
template <class Space = DefaultExecutionSpace>
void fence() {
  if constexpr (requires { Space::wait(); }) Space::wait();
}

}  // namespace pinball
