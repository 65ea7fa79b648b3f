#pragma once

#include <cstdint>

#if defined(_OPENMP)
#include <omp.h>

#include "lost_helpers.hpp"
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
/// Regions of OpenMP's threads, who wait for each other as the environment of the process says (docs/embedding.md).
struct OpenMP {
  using memory_space = HostSpace;
  /// Of a region that begins here.
  static int concurrency() { return has_lost_its_helpers() ? 1 : omp_get_max_threads(); }
  static void set_concurrency(int threads) {
    if (!has_lost_its_helpers()) omp_set_num_threads(threads);
  }
  /// Whether a region of so many pieces of work that begins here is one thread's.
  static bool is_alone(std::int64_t pieces) {
    return pieces <= 1 || concurrency() <= 1 || omp_get_active_level() >= omp_get_max_active_levels();
  }
};
using DefaultExecutionSpace = OpenMP;
#else
using OpenMP = Serial;
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
