#pragma once

namespace pinball {

/// Times that differ by less than this share of a step are one time: more than what sums of steps are rounded by, less
/// than anybody means [-].
inline constexpr double same_time = 1e-6;

}  // namespace pinball
