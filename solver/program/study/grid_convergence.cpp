#include "grid_convergence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace pinball {

namespace {

constexpr double least_order = 0.5, largest_root = 60;
constexpr double below_formal = 0.9, above_formal = 1.05;  ///< parts of the formal order between which one is that

/// Ratios of the sizes of neighbours, and differences of their values, of the three finest meshes.
struct Triplet {
  double r21, r32;
  double e21, e32;
};

/// epsilon_32 / epsilon_21 of an order p.
double ratio_of_differences(const Triplet& t, double p) {
  const double a = p * std::log(t.r21), b = p * std::log(t.r32);
  return std::exp(a) * std::expm1(b) / std::expm1(a);
}

/// Of values that do not oscillate, epsilon_21 not 0; none: there is no positive one.
std::optional<double> observed_order(const Triplet& t) {
  const double ratio = t.e32 / t.e21;
  if (!(ratio > std::log(t.r32) / std::log(t.r21))) return std::nullopt;
  double low = 0, high = largest_root;
  if (!(ratio_of_differences(t, high) > ratio)) return std::numeric_limits<double>::infinity();
  while (high - low > 1e-13 * high) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) break;
    (ratio_of_differences(t, middle) < ratio ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// The sorted values, and what differs by round-off alone made equal.
Triplet triplet_of(const std::vector<MeshValue>& values, double nothing) {
  const auto difference = [&](std::size_t coarse, std::size_t fine) {
    const double e = values[coarse].value - values[fine].value;
    return std::abs(e) <= nothing ? 0.0 : e;
  };
  return {values[1].size / values[0].size, values[2].size / values[1].size, difference(1, 0), difference(2, 1)};
}

void add_band(GridConvergence& result, const Triplet& t, double fine, double formal_order) {
  const double observed = *result.observed_order;
  const double largest = above_formal * formal_order;
  result.order = observed <= largest ? std::max(observed, least_order) : formal_order;
  result.safety_factor = observed >= below_formal * formal_order && observed <= largest ? 1.25 : 3;
  const double grown = std::expm1(result.order * std::log(t.r21));
  result.extrapolated = fine - t.e21 / grown;
  double half = result.safety_factor * std::abs(t.e21) / grown;
  if (observed > largest) {
    const double of_coarser = std::abs(t.e32) / std::expm1(formal_order * std::log(t.r32));
    half = std::max(half, result.safety_factor * of_coarser / std::pow(t.r21, formal_order));
  }
  result.extrapolated_error = std::abs((result.extrapolated - fine) / result.extrapolated);
  result.index = half / std::abs(fine);
  result.low = fine - half;
  result.high = fine + half;
}

}  // namespace

GridConvergence grid_convergence(std::vector<MeshValue> values, double scale, double round_off, double formal_order) {
  std::sort(values.begin(), values.end(), [](const MeshValue& a, const MeshValue& b) { return a.size < b.size; });
  const auto same = [](const MeshValue& a, const MeshValue& b) { return a.size == b.size; };
  if (values.size() < 3 || std::adjacent_find(values.begin(), values.end(), same) != values.end()) {
    throw std::invalid_argument("grid convergence: expected three meshes of different sizes");
  }
  const double fine = values.front().value;
  GridConvergence result;
  result.extrapolated = result.low = result.high = fine;
  for (const MeshValue& v : values) {
    result.low = std::min(result.low, v.value);
    result.high = std::max(result.high, v.value);
    scale = std::max(scale, std::abs(v.value));
  }
  const double nothing = round_off * scale;
  if (result.high - result.low <= nothing) return result;

  const Triplet t = triplet_of(values, nothing);
  result.approximate_error = std::abs(t.e21 / fine);
  if (t.e21 * t.e32 < 0) {
    result.verdict = Convergence::oscillating;
    return result;
  }
  if (t.e21 == 0 && t.e32 == 0) return result;  // only a coarser mesh differs
  result.observed_order = t.e21 == 0 ? std::numeric_limits<double>::infinity() : observed_order(t);
  result.verdict = result.observed_order ? Convergence::monotone : Convergence::diverging;
  if (result.observed_order) add_band(result, t, fine, formal_order);
  return result;
}

GridConvergence distance_convergence(const std::array<double, 3>& sizes, double e21, double e32, double scale,
                                     double round_off, double formal_order) {
  GridConvergence result;
  const double nothing = round_off * scale;
  const Triplet t{sizes[1] / sizes[0], sizes[2] / sizes[1], e21 <= nothing ? 0 : e21, e32 <= nothing ? 0 : e32};
  if (t.e21 == 0 && t.e32 == 0) return result;
  result.approximate_error = e21 / scale;
  result.observed_order = t.e21 == 0 ? std::numeric_limits<double>::infinity() : observed_order(t);
  result.verdict = result.observed_order ? Convergence::monotone : Convergence::diverging;
  result.high = std::max(e21, e32);
  if (!result.observed_order) return result;
  add_band(result, t, 0, formal_order);
  result.extrapolated_error = std::abs(result.extrapolated) / scale;
  result.index = result.high / scale;
  result.extrapolated = result.low = 0;
  return result;
}

}  // namespace pinball
