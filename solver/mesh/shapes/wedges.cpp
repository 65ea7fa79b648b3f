#include "wedges.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

#include <kernels/wedge.hpp>
#include <solver/base/hexahedron_of_points.hpp>

namespace pinball {

namespace {

using Triangle = std::array<std::int32_t, 3>;

/// The square of the cosine between the median from node i and the opposite edge, of the triangle halfway [-].
double lean(const Triangle& below, const Triangle& above, std::size_t i, std::span<const Point> nodes) {
  const auto middle = [&](std::size_t at) {
    const Point &low = nodes[below[at % 3]], &high = nodes[above[at % 3]];
    return Point{low[0] + high[0], low[1] + high[1], low[2] + high[2]};
  };
  const Point own = middle(i), next = middle(i + 1), last = middle(i + 2), edge = minus(last, next);
  const Point to_next = minus(own, next), to_last = minus(own, last);
  const Point median{to_next[0] + to_last[0], to_next[1] + to_last[1], to_next[2] + to_last[2]};
  const double along = dot(edge, median), lengths = dot(edge, edge) * dot(median, median);
  return lengths > 0 ? along * along / lengths : 1;
}

}  // namespace

std::optional<Corners8> as_wedge(const Corners8& corners) {
  if (different_nodes(corners) != 6) return std::nullopt;
  Corners8 c = corners;
  for (int axis = 0; axis < 3; ++axis) {  // that the triangles lie across
    for (int turn = 0; turn < 4; ++turn) {
      if (c[2] == c[3] && c[6] == c[7]) return c;
      c = {c[1], c[2], c[3], c[0], c[5], c[6], c[7], c[4]};
    }
    c = {c[0], c[3], c[7], c[4], c[1], c[2], c[6], c[5]};
  }
  return std::nullopt;
}

CornerShares corner_shares(WorkedShape shape, const Corners8& corners) {
  CornerShares shares;
  shares.fill(1.0 / 8);
  if (shape != WorkedShape::wedge) return shares;
  for (std::size_t i = 0; i < 8; ++i) {
    const auto first = std::ranges::find(corners, corners[i]) - corners.begin();
    shares[i] = first == static_cast<std::ptrdiff_t>(i) ? 1.0 / 6 : 0.0;
  }
  return shares;
}

Corners8 turned_wedge(const Corners8& c, std::span<const Point> nodes) {
  constexpr double round_off = 1e-9;
  Triangle below{c[0], c[1], c[2]}, above{c[4], c[5], c[6]};
  const auto number = [&](std::size_t i) { return std::min(below[i], above[i]); };
  std::array<double, 3> leans{};
  for (std::size_t i = 0; i < 3; ++i) leans[i] = lean(below, above, i, nodes);
  const double least = *std::ranges::min_element(leans);
  std::size_t third = 3;
  for (std::size_t i = 0; i < 3; ++i) {
    if (leans[i] <= least + round_off && (third == 3 || number(i) < number(third))) third = i;
  }
  for (Triangle* triangle : {&below, &above})
    std::rotate(triangle->begin(), triangle->begin() + static_cast<std::ptrdiff_t>((third + 1) % 3), triangle->end());
  if (above[2] < below[2]) {  // seen from the other side
    std::swap(below, above);
    for (Triangle* triangle : {&below, &above}) std::swap((*triangle)[0], (*triangle)[1]);
  }
  return wedge(below[0], below[1], below[2], above[0], above[1], above[2]);
}

Symmetric<double> square_of_wedge(const std::array<Point, 8>& corners) {
  const UniformGradient<double> b = uniform_gradient(modes_of(corners));
  return wedge_gradient_square(b, gradient_square(b));
}

}  // namespace pinball
