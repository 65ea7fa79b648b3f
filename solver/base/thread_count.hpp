#pragma once

#include <cstddef>

#include "../../kernels/exec.hpp"

namespace pinball {

/// Whether the calling thread is that of a fork whose helpers are gone: they were threads of the process that it was
/// forked from, and OpenMP would wait for them for ever. A thread that is made after the fork has helpers of its own;
/// where these are the library's, so has one that was forked.
bool has_lost_its_helpers();

/// The threads of the calling thread's parallel regions while this lives; then their number is what it was.
class ThreadCount {
 public:
  /// threads: 0: as many as the calling thread has already, whose number is then left alone. One where it has lost its
  /// helpers: results are the same.
  explicit ThreadCount(int threads) : ThreadCount(has_lost_its_helpers() ? 1 : threads, nullptr) {}
  ~ThreadCount() {
    if (changed_) DefaultExecutionSpace::set_concurrency(before_);
  }
  ThreadCount(const ThreadCount&) = delete;
  ThreadCount& operator=(const ThreadCount&) = delete;

 private:
  ThreadCount(int threads, std::nullptr_t) : before_(DefaultExecutionSpace::concurrency()), changed_(threads > 0) {
    if (changed_) DefaultExecutionSpace::set_concurrency(threads);
  }

  int before_;
  bool changed_;
};

}  // namespace pinball
