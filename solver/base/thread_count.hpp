#pragma once

#include <cstdint>

#include "../../kernels/exec.hpp"

namespace pinball {

/// With fewer elements to a thread, threads wait for each other longer than they save (docs/performance.md, "How many
/// threads").
inline constexpr std::int64_t elements_of_thread = 900;

/// The threads that a step over so many elements earns, at most as many as OpenMP would take in the calling thread:
/// these where the environment says how many (OMP_NUM_THREADS).
int earned_threads(std::int64_t elements);

/// The threads of the calling thread's parallel regions while this lives; then their number is what it was.
class ThreadCount {
 public:
  /// threads: 0: as many as the calling thread has already, whose number is then left alone.
  explicit ThreadCount(int threads) : before_(DefaultExecutionSpace::concurrency()), changed_(threads > 0) {
    if (changed_) DefaultExecutionSpace::set_concurrency(threads);
  }
  ~ThreadCount() {
    if (changed_) DefaultExecutionSpace::set_concurrency(before_);
  }
  ThreadCount(const ThreadCount&) = delete;
  ThreadCount& operator=(const ThreadCount&) = delete;

 private:
  int before_;
  bool changed_;
};

}  // namespace pinball
