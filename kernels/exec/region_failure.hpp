#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <utility>

namespace pinball {

/// What threads of a region have thrown: no exception may leave one of them. Of several that of the lowest piece
/// counts, which is the same for any number of threads where all pieces are tried.
class RegionFailure {
 public:
  /// Calls work() for a piece of the region.
  template <class Work>
  void guard(std::int64_t piece, const Work& work) {
    try {
      work();
    } catch (...) {
      keep(piece, std::current_exception());
    }
  }
  /// After the region, by one thread.
  void rethrow() {
    if (first_) std::rethrow_exception(std::exchange(first_, nullptr));
  }

 private:
  void keep(std::int64_t piece, std::exception_ptr thrown) {
    while (busy_.test_and_set(std::memory_order_acquire)) {
    }
    if (!first_ || piece < piece_) {
      std::swap(first_, thrown);
      piece_ = piece;
    }
    busy_.clear(std::memory_order_release);
  }

  std::atomic_flag busy_ = ATOMIC_FLAG_INIT;
  std::int64_t piece_ = 0;
  std::exception_ptr first_;
};

}  // namespace pinball
