#pragma once

#include <array>
#include <cstddef>

#include "point.hpp"

namespace pinball {

/// Adds the moments of inertia of a mass at the end of an arm, m (r.r 1 - r r), to those about where the arm begins
/// [mass length^2].
inline void add_moments(std::array<Point, 3>& inertia, double mass, const Point& arm) {
  const double square = dot(arm, arm);
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t l = 0; l < 3; ++l) inertia[k][l] += mass * ((k == l ? square : 0.0) - arm[k] * arm[l]);
  }
}

}  // namespace pinball
