#pragma once

#include <string>
#include <vector>

namespace pinball {

/// "x", "y", "z" by their bits, 1, 2 and 4.
inline std::vector<std::string> direction_names(unsigned directions) {
  std::vector<std::string> names;
  for (unsigned k = 0; k < 3; ++k) {
    if ((directions >> k & 1U) != 0) names.emplace_back(1, "xyz"[k]);
  }
  return names;
}

}  // namespace pinball
