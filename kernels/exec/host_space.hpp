#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <new>

namespace pinball {

/// Memory of the host. Large arrays lie on huge pages where the system grants them on request: a step of 216,000
/// elements is 12 % faster. Their pages are of the system, and are there when somebody writes to them: so each lies
/// near the thread that uses it, and threads clear them together.
///
/// Every memory space has these functions. `room`: bytes that an array of so many bytes takes up, a multiple of 64;
/// `allocate` takes that and throws std::bad_alloc where there is no memory; what is allocated may hold anything, but
/// where `begins_as_zero`, which not all have.
struct HostSpace {
  static constexpr std::size_t alignment = 64;  ///< a cache line, the widest pack

  static std::size_t room(std::size_t bytes) {
    const std::size_t place = place_of(bytes);
    return (bytes + place - 1) / place * place;
  }
  static void* allocate(std::size_t room) {
    void* const memory = begins_as_zero(room) ? of_pages(room) : std::aligned_alloc(alignment, room);
    if (memory == nullptr) throw std::bad_alloc();
    return memory;
  }
  static bool begins_as_zero(std::size_t room) { return place_of(room) == huge_page; }
  static void release(void* memory, std::size_t room) noexcept {
    if (begins_as_zero(room)) {
      munmap(memory, room);
    } else {
      std::free(memory);
    }
  }

  static void zero(void* to, std::size_t bytes) { std::memset(to, 0, bytes); }
  static void copy(void* to, const void* from, std::size_t bytes) { std::memcpy(to, from, bytes); }
  static void copy_from_host(void* to, const void* from, std::size_t bytes) { copy(to, from, bytes); }
  static void copy_to_host(void* to, const void* from, std::size_t bytes) { copy(to, from, bytes); }

 private:
  static constexpr std::size_t huge_page = std::size_t(2) << 20;
#if defined(__SANITIZE_ADDRESS__)
  static constexpr std::size_t pages_from = SIZE_MAX;  // it watches what the library allocates
#else
  static constexpr std::size_t pages_from = huge_page;
#endif
  static std::size_t place_of(std::size_t bytes) { return bytes >= pages_from ? huge_page : alignment; }

  /// Whole huge pages; null: there are none.
  static void* of_pages(std::size_t room) {
    const std::size_t all = room + huge_page;
    if (all < room) return nullptr;
    void* const mapped = mmap(nullptr, all, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (mapped == MAP_FAILED) return nullptr;
    // What lies before and behind the huge pages goes back.
    char* const begin = static_cast<char*>(mapped);
    const std::size_t before = (huge_page - reinterpret_cast<std::uintptr_t>(begin) % huge_page) % huge_page;
    if (before > 0) munmap(begin, before);
    if (huge_page > before) munmap(begin + before + room, huge_page - before);
#if defined(MADV_HUGEPAGE)
    madvise(begin + before, room, MADV_HUGEPAGE);  // advice: a refusal changes nothing
#endif
    return begin + before;
  }
};

}  // namespace pinball
