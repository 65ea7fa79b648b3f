#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <mutex>
#include <new>

#if defined(PKEY_DISABLE_ACCESS) && !defined(PINBALL_MOCK_WITHOUT_KEYS)
#define PINBALL_MOCK_KEYS 1
#endif

namespace pinball {

/// Memory as that of a device is: the host may touch it in kernels and copies alone; elsewhere it dies of SIGSEGV.
///
/// All of it is one range of addresses with one protection key of the processor, which each thread opens for itself
/// while it works on a piece of a kernel. Where there are no keys (PINBALL_MOCK_WITHOUT_KEYS: tests leave them out),
/// the range is opened for all threads while any of them is in a kernel, by mprotect: some 10 us a time and, on some
/// virtual machines, as long again for what the system then has to do. So it is closed after each of the first
/// always_closed kernels and copies, which are the first steps of a run, and after closed_in_turn of each turn of those
/// that follow: all that a step does is looked at again and again. Pages are huge where the system grants them.
class MockMemory {
 public:
  static MockMemory& instance() {
    static MockMemory& memory = *new MockMemory;  // arrays with static lifetime may be gone last
    return memory;
  }
  /// Where there are no keys: kernels and copies after which the range is closed, from the first and in each turn.
  static constexpr std::int64_t always_closed = 2048, turn = 4096, closed_in_turn = 128;

  /// Keys of the processor protect it: other threads may not touch it either while one is in a kernel.
  bool has_keys() const { return key_ >= 0; }

  /// bytes: a multiple of pages.
  void* allocate(std::size_t bytes) {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (std::size_t i = 0; i < released_count_; ++i) {
      if (released_[i].bytes != bytes) continue;
      void* const memory = released_[i].memory;
      released_[i] = released_[--released_count_];
      ++pieces_;
      return memory;
    }
    if (bytes > range - next_) throw std::bad_alloc();
    if (next_ + bytes > used_) extend(next_ + bytes);
    void* const memory = begin_ + next_;
    next_ += bytes;
    ++pieces_;
    return memory;
  }

  /// Addresses are used again for as many bytes, and all of them when nothing is left: what comes and goes in each step
  /// must not make the range longer that mprotect walks through.
  void release(void* memory, std::size_t bytes) noexcept {
    const std::lock_guard<std::mutex> lock(mutex_);
    madvise(memory, bytes, MADV_DONTNEED);
    if (released_count_ < most_released) released_[released_count_++] = {memory, bytes};
    if (--pieces_ == 0) next_ = released_count_ = 0;
  }

  /// While it lives, the calling thread may touch the memory. Scopes may lie in each other.
  class OpenHere {
   public:
    OpenHere() { instance().open_here(); }
    ~OpenHere() { instance().close_here(); }
    OpenHere(const OpenHere&) = delete;
    OpenHere& operator=(const OpenHere&) = delete;
  };
  /// While it lives, threads may open it quickly: around the pieces of a kernel, which open it each for itself.
  class OpenForTeam {
   public:
    OpenForTeam() { instance().open_for_all(); }
    ~OpenForTeam() { instance().close_for_all(); }
    OpenForTeam(const OpenForTeam&) = delete;
    OpenForTeam& operator=(const OpenForTeam&) = delete;
  };

 private:
  static constexpr std::size_t range = std::size_t(1) << 38;  ///< of addresses; memory comes when it is touched
  struct Piece {
    void* memory;
    std::size_t bytes;
  };
  /// Pieces that wait to be used again; of more the addresses are lost until nothing is left.
  static constexpr std::size_t most_released = 256;
  static constexpr std::size_t huge_page = std::size_t(2) << 20;

  MockMemory() {
    void* const memory =
        mmap(nullptr, range + huge_page, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (memory == MAP_FAILED) throw std::bad_alloc();
    const auto address = reinterpret_cast<std::uintptr_t>(memory);
    begin_ = static_cast<char*>(memory) + (huge_page - address % huge_page) % huge_page;
#if defined(MADV_HUGEPAGE)
    madvise(begin_, range, MADV_HUGEPAGE);
#endif
#if defined(PINBALL_MOCK_KEYS)
    key_ = pkey_alloc(0, PKEY_DISABLE_ACCESS);
#endif
  }

  /// More of the range is in use: whole huge pages, as open or closed as the rest.
  void extend(std::size_t end) {
    const std::size_t before = used_;
    used_ = (end + huge_page - 1) / huge_page * huge_page;
    if (!protect(before, used_, has_keys() || !closed_)) {
      used_ = before;
      throw std::bad_alloc();
    }
  }
  bool protect(std::size_t begin, std::size_t end, bool open) const {
    if (begin == end) return true;
    const int allowed = open ? PROT_READ | PROT_WRITE : PROT_NONE;
#if defined(PINBALL_MOCK_KEYS)
    if (has_keys()) return pkey_mprotect(begin_ + begin, end - begin, allowed, key_) == 0;
#endif
    return mprotect(begin_ + begin, end - begin, allowed) == 0;
  }

  void open_for_all() {
    if (has_keys()) return;
    const std::lock_guard<std::mutex> lock(mutex_);
    if (open_++ > 0 || !closed_) return;
    protect(0, used_, true);
    closed_ = false;
  }
  void close_for_all() {
    if (has_keys()) return;
    const std::lock_guard<std::mutex> lock(mutex_);
    if (--open_ > 0) return;
    const std::int64_t now = times_++;
    if (now >= always_closed && now % turn >= closed_in_turn) return;
    protect(0, used_, false);
    closed_ = true;
  }
  /// Scopes in which the calling thread is.
  static int& depth() {
    static thread_local int scopes = 0;
    return scopes;
  }
  void open_here() {
    if (!has_keys()) open_for_all();
#if defined(PINBALL_MOCK_KEYS)
    if (has_keys() && depth()++ == 0) pkey_set(key_, 0);
#endif
  }
  void close_here() {
    if (!has_keys()) close_for_all();
#if defined(PINBALL_MOCK_KEYS)
    if (has_keys() && --depth() == 0) pkey_set(key_, PKEY_DISABLE_ACCESS);
#endif
  }

  char* begin_ = nullptr;
  int key_ = -1;
  std::mutex mutex_;
  std::size_t next_ = 0;    ///< bytes from the beginning that are given out, or were
  std::size_t used_ = 0;    ///< bytes from the beginning that the system gives, whole huge pages
  std::size_t pieces_ = 0;  ///< given out and not released
  Piece released_[most_released] = {};
  std::size_t released_count_ = 0;
  std::int64_t open_ = 0;   ///< scopes for which all threads may touch it
  std::int64_t times_ = 0;  ///< that the last of such scopes ended
  bool closed_ = true;      ///< for all threads
};

struct MockSpace {
  static constexpr std::size_t alignment = 4096;
  static std::size_t room(std::size_t bytes) { return (bytes + alignment - 1) / alignment * alignment; }
  static void* allocate(std::size_t room) { return MockMemory::instance().allocate(room); }
  static void release(void* memory, std::size_t room) noexcept { MockMemory::instance().release(memory, room); }
  static void zero(void* to, std::size_t bytes) {
    const MockMemory::OpenHere while_it_works;
    std::memset(to, 0, bytes);
  }
  static void copy(void* to, const void* from, std::size_t bytes) {
    const MockMemory::OpenHere while_it_works;
    std::memcpy(to, from, bytes);
  }
  static void copy_from_host(void* to, const void* from, std::size_t bytes) { copy(to, from, bytes); }
  static void copy_to_host(void* to, const void* from, std::size_t bytes) { copy(to, from, bytes); }
  /// What keeps the host out.
  static const char* protection() { return MockMemory::instance().has_keys() ? "protection keys" : "mprotect"; }
};

}  // namespace pinball
