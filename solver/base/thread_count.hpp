#pragma once

#include "../../kernels/exec.hpp"

namespace pinball {

/// More than any machine has; with still more of them the system ends the program.
inline constexpr int most_threads = 4096;

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
