#pragma once

#include <fmt/core.h>

#include <string>

namespace pinball {

/// "12.3 %"; share: of 1.
inline std::string percent(double share) { return fmt::format("{:.3g} %", 100 * share); }

}  // namespace pinball
