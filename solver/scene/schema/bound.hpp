#pragma once

#include <limits>
#include <string>

namespace pinball {

/// An interval of numbers that a key accepts.
struct Bound {
  double low = -std::numeric_limits<double>::infinity();
  bool low_open = false;  ///< low itself is not accepted
  double high = std::numeric_limits<double>::infinity();
  bool high_open = false;

  bool holds(double value) const;  ///< never for a value that is not finite
  std::string describe() const;    ///< "a number > 0 and <= 1.2"
};

inline constexpr Bound any_number{};
inline constexpr Bound positive{.low = 0.0, .low_open = true};
inline constexpr Bound not_negative{.low = 0.0};

}  // namespace pinball
