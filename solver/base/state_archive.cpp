#include "state_archive.hpp"

#include <algorithm>
#include <cstring>

#include <kernels/exec.hpp>

namespace pinball {

void StateArchive::copy(void* to, const void* from, std::size_t bytes) {
  constexpr std::size_t block = std::size_t(1) << 18;
  if (bytes < 4 * block) {
    std::memcpy(to, from, bytes);
    return;
  }
  const auto blocks = static_cast<std::int64_t>((bytes + block - 1) / block);
  parallel_for("copy of state", RangePolicy<>{0, blocks}, [&](std::int64_t number) {
    const std::size_t begin = number * block;
    std::memcpy(static_cast<std::byte*>(to) + begin, static_cast<const std::byte*>(from) + begin,
                std::min(block, bytes - begin));
  });
}

}  // namespace pinball
