#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <pinball/solver/error.hpp>
#include <pinball/solver/ordering.hpp>
#include <utility>

namespace pinball {
namespace {

constexpr int bits_per_axis = 21;  // three axes fill 63 bits of the key

/// Position along the Hilbert curve of a cell with these coordinates, by the transposed form of J. Skilling,
/// "Programming the Hilbert curve" (2004).
std::uint64_t hilbert_key(std::array<std::uint32_t, 3> x) {
  for (std::uint32_t bit = 1u << (bits_per_axis - 1); bit > 1; bit >>= 1) {
    const std::uint32_t lower = bit - 1;
    for (int axis = 0; axis < 3; ++axis) {
      if (x[axis] & bit) {
        x[0] ^= lower;
      } else {
        const std::uint32_t exchange = (x[0] ^ x[axis]) & lower;
        x[0] ^= exchange;
        x[axis] ^= exchange;
      }
    }
  }
  x[1] ^= x[0];
  x[2] ^= x[1];
  std::uint32_t flip = 0;
  for (std::uint32_t bit = 1u << (bits_per_axis - 1); bit > 1; bit >>= 1)
    if (x[2] & bit) flip ^= bit - 1;
  for (std::uint32_t& component : x) component ^= flip;

  std::uint64_t key = 0;
  for (int bit = bits_per_axis - 1; bit >= 0; --bit)
    for (const std::uint32_t component : x) key = (key << 1) | ((component >> bit) & 1u);
  return key;
}

}  // namespace

std::vector<std::int32_t> space_filling_order(const std::vector<Point>& centres) {
  Point low{}, high{};
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  for (const Point& centre : centres)
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], centre[axis]);
      high[axis] = std::max(high[axis], centre[axis]);
    }
  double extent = 0.0;
  for (int axis = 0; axis < 3; ++axis) extent = std::max(extent, high[axis] - low[axis]);

  constexpr double cells = 1u << bits_per_axis;
  std::vector<std::pair<std::uint64_t, std::int32_t>> keyed(centres.size());
  for (std::size_t i = 0; i < centres.size(); ++i) {
    std::array<std::uint32_t, 3> cell{};
    for (int axis = 0; axis < 3; ++axis) {
      const double position = (centres[i][axis] - low[axis]) / extent * cells;
      if (position > 0.0) cell[axis] = static_cast<std::uint32_t>(std::min(position, cells - 1.0));  // false for NaN
    }
    keyed[i] = {hilbert_key(cell), static_cast<std::int32_t>(i)};
  }
  std::sort(keyed.begin(), keyed.end());

  std::vector<std::int32_t> order(centres.size());
  std::transform(keyed.begin(), keyed.end(), order.begin(), [](const auto& entry) { return entry.second; });
  return order;
}

std::vector<std::int32_t> first_touch_node_order(const std::vector<std::array<std::int32_t, 8>>& hexahedra,
                                                 std::int32_t node_count) {
  std::vector<char> touched(node_count, 0);
  std::vector<std::int32_t> order;
  order.reserve(node_count);
  for (std::size_t element = 0; element < hexahedra.size(); ++element)
    for (const std::int32_t node : hexahedra[element]) {
      if (node < 0 || node >= node_count)
        throw InputError(
            fmt::format("mesh: element {}: node index {} is not among the {} nodes", element, node, node_count));
      if (touched[node]) continue;
      touched[node] = 1;
      order.push_back(node);
    }
  for (std::int32_t node = 0; node < node_count; ++node)
    if (!touched[node]) order.push_back(node);
  return order;
}

std::vector<std::int32_t> inverse_permutation(const std::vector<std::int32_t>& order) {
  std::vector<std::int32_t> inverse(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) inverse[order[i]] = static_cast<std::int32_t>(i);
  return inverse;
}

}  // namespace pinball
