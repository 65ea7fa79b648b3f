#pragma once

#include <malloc.h>

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <new>

/// For a program of one source: memory that is refused when the test says so. It replaces operator new and, but for the
/// address sanitizer, which has its own, the allocation behind Array.
namespace pinball::test {

struct Memory {
  /// Requests that are granted before all others are refused; counted over all threads.
  static inline std::atomic<std::int64_t> granted{std::numeric_limits<std::int64_t>::max()};
  static inline std::atomic<std::int64_t> alive{0};  ///< pieces from operator new

  static bool refuses() {
    return granted.load() != std::numeric_limits<std::int64_t>::max() && granted.fetch_sub(1) <= 0;
  }
  static void* get(std::size_t size, std::size_t alignment = alignof(std::max_align_t)) {
    if (refuses()) return nullptr;
    void* piece = nullptr;
    if (posix_memalign(&piece, alignment, size) != 0) return nullptr;
    ++alive;
    return piece;
  }
  static void* get_or_throw(std::size_t size, std::size_t alignment = alignof(std::max_align_t)) {
    void* const piece = get(size, alignment);
    if (piece == nullptr) throw std::bad_alloc();
    return piece;
  }
  static void give_back(void* piece) {
    if (piece != nullptr) --alive;
    std::free(piece);
  }

  /// Calls work() with 0, 1, 2, ... requests granted, until all that it asks for are, and returns how many these are.
  template <class Work>
  static std::int64_t refuse_each(const Work& work) {
    for (std::int64_t number = 0;; ++number) {
      granted = number;
      work();
      const bool all = granted.exchange(std::numeric_limits<std::int64_t>::max()) >= 0;
      if (all) return number;
    }
  }
};

}  // namespace pinball::test

void* operator new(std::size_t size) { return pinball::test::Memory::get_or_throw(size); }
void* operator new[](std::size_t size) { return pinball::test::Memory::get_or_throw(size); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return pinball::test::Memory::get_or_throw(size, static_cast<std::size_t>(alignment));
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
  return pinball::test::Memory::get_or_throw(size, static_cast<std::size_t>(alignment));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return pinball::test::Memory::get(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return pinball::test::Memory::get(size); }
void* operator new(std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept {
  return pinball::test::Memory::get(size, static_cast<std::size_t>(alignment));
}
void* operator new[](std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept {
  return pinball::test::Memory::get(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* piece) noexcept { pinball::test::Memory::give_back(piece); }
void operator delete[](void* piece) noexcept { pinball::test::Memory::give_back(piece); }
void operator delete(void* piece, std::size_t) noexcept { pinball::test::Memory::give_back(piece); }
void operator delete[](void* piece, std::size_t) noexcept { pinball::test::Memory::give_back(piece); }
void operator delete(void* piece, std::align_val_t) noexcept { pinball::test::Memory::give_back(piece); }
void operator delete[](void* piece, std::align_val_t) noexcept { pinball::test::Memory::give_back(piece); }
void operator delete(void* piece, std::size_t, std::align_val_t) noexcept { pinball::test::Memory::give_back(piece); }
void operator delete[](void* piece, std::size_t, std::align_val_t) noexcept { pinball::test::Memory::give_back(piece); }
void operator delete(void* piece, const std::nothrow_t&) noexcept { pinball::test::Memory::give_back(piece); }
void operator delete[](void* piece, const std::nothrow_t&) noexcept { pinball::test::Memory::give_back(piece); }

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
extern "C" void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  if (!pinball::test::Memory::refuses()) return memalign(alignment, size);
  errno = ENOMEM;
  return nullptr;
}
#endif
