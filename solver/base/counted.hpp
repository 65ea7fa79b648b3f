#pragma once

#include <cstdint>
#include <string>

namespace pinball {

/// "1 element", "2 elements", "3 bodies"; several: where it is not `one` with an s.
inline std::string counted(std::int64_t count, const std::string& one, const std::string& several = {}) {
  return std::to_string(count) + ' ' + (count == 1 ? one : several.empty() ? one + 's' : several);
}

/// "1 of 1 element", "1 of 2 elements"
inline std::string counted_of(std::int64_t count, std::int64_t all, const std::string& one) {
  return std::to_string(count) + " of " + counted(all, one);
}

}  // namespace pinball
