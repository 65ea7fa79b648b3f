#include "ordering.hpp"

#include <fmt/format.h>

#include <solver/base/error.hpp>

namespace pinball {

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
  for (std::size_t i = 0; i < order.size(); ++i) inverse[order[i]] = i;
  return inverse;
}

}  // namespace pinball
