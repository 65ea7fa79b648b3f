#pragma once

#include <pthread.h>

#include <atomic>
#include <cstdint>

namespace pinball {

/// How often this process and those before it have been forked off.
inline std::atomic<std::uint32_t>& fork_count() {
  static std::atomic<std::uint32_t> count{0};
  static const int counted =
      pthread_atfork(nullptr, nullptr, [] { fork_count().fetch_add(1, std::memory_order_relaxed); });
  (void)counted;
  return count;
}

/// Whether the calling thread is that of a fork whose helpers are gone: they were threads of the process that it was
/// forked from, and OpenMP would wait for them for ever. What counts is whether it has asked before the fork: each
/// region does. A thread that is made after the fork has helpers of its own.
inline bool has_lost_its_helpers() {
  static thread_local const std::uint32_t forks_at_first = fork_count().load(std::memory_order_relaxed);
  return fork_count().load(std::memory_order_relaxed) != forks_at_first;
}

}  // namespace pinball
