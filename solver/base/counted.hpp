#pragma once

#include <fmt/core.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace pinball {

/// "1 element", "2 elements", "3 bodies"; several: where it is not `one` with an s.
inline std::string counted(std::int64_t count, std::string_view one, std::string_view several = {}) {
  if (count == 1) return fmt::format("1 {}", one);
  return several.empty() ? fmt::format("{} {}s", count, one) : fmt::format("{} {}", count, several);
}

/// "1 of 1 element", "1 of 2 elements"
inline std::string counted_of(std::int64_t count, std::int64_t all, std::string_view one) {
  return fmt::format("{} of {}", count, counted(all, one));
}

}  // namespace pinball
