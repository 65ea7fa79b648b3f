#include "bound.hpp"

#include <fmt/format.h>

#include <cmath>

namespace pinball {

bool Bound::holds(double value) const {
  return std::isfinite(value) && (low_open ? value > low : value >= low) && (high_open ? value < high : value <= high);
}

std::string Bound::describe() const {
  std::string text = "a number";
  if (std::isfinite(low)) text += fmt::format(" {} {}", low_open ? ">" : ">=", low);
  if (std::isfinite(low) && std::isfinite(high)) text += " and";
  if (std::isfinite(high)) text += fmt::format(" {} {}", high_open ? "<" : "<=", high);
  return text == "a number" ? "a finite number" : text;
}

}  // namespace pinball
