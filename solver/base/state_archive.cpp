#include "state_archive.hpp"

#include <algorithm>
#include <cstring>

#include <kernels/exec.hpp>

namespace pinball {

namespace {

bool is_zero(const std::byte* from, std::size_t bytes) {
  constexpr std::size_t line = 64;
  for (; bytes >= line; from += line, bytes -= line) {
    std::uint64_t words[line / sizeof(std::uint64_t)], any = 0;
    std::memcpy(words, from, line);
    for (const std::uint64_t word : words) any |= word;
    if (any != 0) return false;
  }
  for (; bytes > 0; ++from, --bytes) {
    if (*from != std::byte{0}) return false;
  }
  return true;
}

/// Nothing is written where both are zero: most of a state is, when a run begins, and new memory takes a page of the
/// machine only where it is written to.
void copy_pages(std::byte* to, const std::byte* from, std::size_t bytes) {
  constexpr std::size_t page = 4096;
  for (std::size_t begin = 0; begin < bytes; begin += page) {
    const std::size_t size = std::min(page, bytes - begin);
    if (!is_zero(from + begin, size) || !is_zero(to + begin, size)) std::memcpy(to + begin, from + begin, size);
  }
}

}  // namespace

void StateArchive::copy(void* to, const void* from, std::size_t bytes) {
  constexpr std::size_t block = std::size_t(1) << 16;
  if (bytes < 4 * block) {
    std::memcpy(to, from, bytes);
    return;
  }
  const auto blocks = static_cast<std::int64_t>((bytes + block - 1) / block);
  parallel_for("copy of state", RangePolicy<>{0, blocks}, [&](std::int64_t number) {
    const std::size_t begin = number * block;
    copy_pages(static_cast<std::byte*>(to) + begin, static_cast<const std::byte*>(from) + begin,
               std::min(block, bytes - begin));
  });
}

}  // namespace pinball
