#pragma once

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <type_traits>

/// The switch of planted faults (bench/faults): which one is on, and which ones a program has come by.
///
///     PINBALL_FAULT=N           fault N is on; else all are off
///     PINBALL_FAULTS_SEEN=FILE  byte N of the file, which is there with room for all, becomes 1 where fault N is come
///     by
// What a switch makes of a text is not what its writer would be warned of.
#pragma GCC diagnostic ignored "-Wparentheses"
#pragma GCC diagnostic ignored "-Wunused-variable"
#pragma GCC diagnostic ignored "-Wunused-but-set-variable"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wint-in-bool-context"
#pragma GCC diagnostic ignored "-Wempty-body"
#pragma GCC diagnostic ignored "-Wtype-limits"
#pragma GCC diagnostic ignored "-Wsign-compare"
#pragma GCC diagnostic ignored "-Wshadow"

namespace pinball_faults {

inline constexpr int most = 4096;
inline unsigned char unasked[most];
/// Shared with the file, so that a program that is killed has written, too.
inline unsigned char* seen = unasked;
inline int active = -1;

inline const bool started = [] {
  if (const char* const number = std::getenv("PINBALL_FAULT")) active = std::atoi(number);
  const char* const path = std::getenv("PINBALL_FAULTS_SEEN");
  const int file = path != nullptr ? ::open(path, O_RDWR | O_CLOEXEC) : -1;
  if (file < 0) return true;
  void* const bytes = ::mmap(nullptr, most, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  if (bytes != MAP_FAILED) seen = static_cast<unsigned char*>(bytes);
  ::close(file);
  return true;
}();

[[gnu::always_inline]] inline bool on(int number) {
  if (number == active) [[unlikely]]
    return true;
  seen[number] = 1;
  return false;
}

/// Takes the place of a member that is saved and read: what is read does not reach it.
template <class T>
T& unread(const T& member) {
  thread_local T copy;
  if constexpr (std::is_copy_assignable_v<T>) {
    copy = member;
  } else {  // an Array
    copy.reset(member.size());
    std::copy(member.data(), member.data() + member.size(), copy.data());
  }
  return copy;
}

}  // namespace pinball_faults
