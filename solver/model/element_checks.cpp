#include "element_checks.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <solver/base/point.hpp>
#include <solver/mesh/quality.hpp>

#include "mesh_rounding.hpp"

namespace pinball {

namespace {

constexpr double least_square = 1e-250;

/// Largest distance of a corner from the first one: 0 only if all are the same point.
double diameter(const std::array<Point, 8>& corners) {
  const Point& a = corners[0];
  double largest = 0;
  for (const Point& b : corners) largest = std::max(largest, dot(minus(b, a), minus(b, a)));
  // hypot takes ten times as long, and is for those whose squares are no numbers or have lost digits.
  if (largest > least_square && largest < 1 / least_square) return std::sqrt(largest);
  largest = 0;
  for (const Point& b : corners) {
    largest = std::max(largest, std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]));
  }
  return largest;
}

/// Largest coordinate.
double farthest(const std::array<Point, 8>& corners) {
  double largest = 0;
  for (const Point& corner : corners) {
    for (const double x : corner) largest = std::max(largest, std::abs(x));
  }
  return largest;
}

/// The kernels divide by the square of a volume: it has to be a normal number of the precision.
bool square_is_held(double volume, Precision precision) {
  const bool wide = !has_single_elements(precision);
  const double least = wide ? std::numeric_limits<double>::min() : std::numeric_limits<float>::min();
  const double most = wide ? std::numeric_limits<double>::max() : std::numeric_limits<float>::max();
  return volume >= std::sqrt(least) && volume <= std::sqrt(most);
}

const char* digits_name(bool single) { return single ? "single" : "double"; }

const char* or_double(Precision precision) {
  return precision == Precision::float64 ? "" : ", or precision = \"double\"";
}

}  // namespace

std::string volume_problem(const std::array<Point, 8>& corners, Precision precision) {
  const double size = diameter(corners), cube = size * size * size;
  const double volume = volume_by_quadrature(corners);
  // A flat element has a volume of round-off, of either sign.
  constexpr double least_share = 1e-12;
  const bool flat = !(volume > least_share * cube), held = square_is_held(cube, precision);
  if (flat && size > 0 && std::numeric_limits<double>::epsilon() * farthest(corners) > 1e-6 * size) return "";
  if (flat && (held || size == 0)) {
    const std::string expected = volume > 0 ? fmt::format("more than {:.3g}, {:.0e} of the cube of its size {:.3g}",
                                                          least_share * cube, least_share, size)
                                            : "> 0";
    return fmt::format("is inverted or flat: its volume is {:.6g}, expected {}", std::isnan(volume) ? NAN : volume,
                       expected);
  }
  if (held && square_is_held(volume, precision)) return "";
  return fmt::format(
      "has the size {:.3g}, with volumes that {} precision cannot hold: expected another unit of length{}", size,
      digits_name(has_single_elements(precision)), or_double(precision));
}

std::string rounding_problem(const std::array<Point, 8>& corners, Precision precision) {
  const double error = relative_rounding(corners, precision), most = largest_rounding(precision);
  if (error <= most) return "";
  const Point& p = corners[0];
  return fmt::format(
      "at ({:.6g}, {:.6g}, {:.6g}) is too small for a place so far from the origin: {} precision rounds its volume by "
      "{:.2g} of it, expected at most {:.2g}; move the origin into the scene{}",
      p[0], p[1], p[2], digits_name(precision == Precision::float32), error, most, or_double(precision));
}

}  // namespace pinball
