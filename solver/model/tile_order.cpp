#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <kernels/exec.hpp>

#include "ordering.hpp"

namespace pinball {
namespace {

using Layers = std::array<std::int32_t, 3>;
using Axes = std::array<std::size_t, 3>;

/// An element at its layers: in the order of the axes, or of those that it is turned to.
struct PlacedElement {
  Layers layer;
  std::int32_t element;

  /// Numbers in pairs, each compared at once: all are at least 0.
  friend bool operator<(const PlacedElement& a, const PlacedElement& b) {
    const auto pair = [](std::int32_t high, std::int32_t low) {
      return std::uint64_t(std::uint32_t(high)) << 32 | std::uint32_t(low);
    };
    const std::uint64_t of_a = pair(a.layer[0], a.layer[1]), of_b = pair(b.layer[0], b.layer[1]);
    return of_a != of_b ? of_a < of_b : pair(a.layer[2], a.element) < pair(b.layer[2], b.element);
  }
};

/// Cuts ranges of elements into halves until they are tiles.
class Halving {
 public:
  Halving(std::span<const Point> centres, std::span<const Point> extents, std::int64_t largest, std::int64_t multiple,
          int row_axis, TileOrder& tiles)
      : centres_(centres),
        extents_(extents),
        largest_(largest),
        multiple_(multiple),
        row_axis_(row_axis),
        places_(tiles.order.size()),
        tiles_(tiles) {
    parallel_for("elements to cut", RangePolicy<>{0, std::ssize(tiles.order)},
                 [&](std::int64_t i) { places_[i].element = tiles.order[i]; });
  }

  /// All ranges are cut at once, again and again: each is some thread's.
  void cut(std::int64_t count) {
    struct Range {
      std::int64_t begin, end;
      std::int64_t middle = 0;  ///< none: it is a tile
    };
    std::vector<Range> ranges{{0, count}};
    for (bool some_left = true; some_left;) {
      parallel_for("tiles", RangePolicy<>{0, std::ssize(ranges)}, [&](std::int64_t i) {
        Range& range = ranges[i];
        if (!is_tile(range.begin, range.end)) range.middle = cut_in_two(range.begin, range.end);
      });
      some_left = false;
      std::vector<Range> halves;
      for (const Range& range : ranges) {
        if (range.middle > 0) {
          halves.push_back({range.begin, range.middle});
          halves.push_back({range.middle, range.end});
          some_left = true;
        } else {
          halves.push_back({range.begin, range.end});
        }
      }
      ranges.swap(halves);
    }
    parallel_for("rows of tiles", RangePolicy<>{0, std::ssize(ranges)}, [&](std::int64_t i) {
      sort_rows(ranges[i].begin, ranges[i].end, count_layers(ranges[i].begin, ranges[i].end));
      for (std::int64_t at = ranges[i].begin; at < ranges[i].end; ++at) tiles_.order[at] = places_[at].element;
    });
    for (const Range& range : ranges) tiles_.offsets.push_back(range.end);
  }

 private:
  bool is_tile(std::int64_t begin, std::int64_t end) const { return end - begin <= largest_; }

  /// Returns where the second half begins.
  std::int64_t cut_in_two(std::int64_t begin, std::int64_t end) {
    const Layers layers = count_layers(begin, end);
    const std::size_t axis = axis_to_cut(layers);
    const std::int64_t middle = begin + half(begin, end, axis, layers[axis]);
    turn(begin, end, {axis, (axis + 1) % 3, (axis + 2) % 3});
    std::nth_element(at(begin), at(middle), at(end));
    return middle;
  }

  PlacedElement* at(std::int64_t i) { return places_.data() + i; }

  void turn(std::int64_t begin, std::int64_t end, const Axes& axes) {
    for (auto* place = at(begin); place != at(end); ++place) {
      place->layer = {place->layer[axes[0]], place->layer[axes[1]], place->layer[axes[2]]};
    }
  }

  /// Numbers the layers of elements in each direction, of a thickness that is the mean of the elements'.
  Layers count_layers(std::int64_t begin, std::int64_t end) {
    Point low, high, thickness{};
    low.fill(std::numeric_limits<double>::infinity());
    high.fill(-std::numeric_limits<double>::infinity());
    for (auto* place = at(begin); place != at(end); ++place) {
      const Point &centre = centres_[place->element], &extent = extents_[place->element];
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], centre[k]);
        high[k] = std::max(high[k], centre[k]);
        thickness[k] += extent[k] / (end - begin);
      }
    }
    // Not more layers than elements, however far small bodies are apart.
    for (std::size_t k = 0; k < 3; ++k) {
      thickness[k] = std::max(thickness[k], (high[k] - low[k]) / (end - begin));
    }
    Layers last{0, 0, 0};
    parallel_reduce(
        "layers", RangePolicy<>{begin, end}, last,
        [&](std::int64_t first, std::int64_t behind, Layers& largest) {
          for (auto* place = at(first); place != at(behind); ++place) {
            for (std::size_t k = 0; k < 3; ++k) {
              place->layer[k] = layer_at(centres_[place->element][k] - low[k], thickness[k]);
              largest[k] = std::max(largest[k], place->layer[k]);
            }
          }
        },
        [](Layers& whole, const Layers& part) {
          for (std::size_t k = 0; k < 3; ++k) whole[k] = std::max(whole[k], part[k]);
        });
    return {last[0] + 1, last[1] + 1, last[2] + 1};
  }

  /// height / thickness to the nearest, as std::lround, which takes several times as long; 0 below 0, and for NaN.
  static std::int32_t layer_at(double height, double thickness) {
    if (!(height > 0)) return 0;
    const double layers = height / thickness;
    const auto whole = static_cast<std::int32_t>(layers);
    return layers - whole >= 0.5 ? whole + 1 : whole;
  }

  /// That with the most layers. Rows are cut where they are far longer than the tile is thick.
  std::size_t axis_to_cut(Layers layers) const {
    if (row_axis_ >= 0) layers[row_axis_] = (layers[row_axis_] + 3) / 4;
    return std::max_element(layers.begin(), layers.end()) - layers.begin();
  }

  /// Elements of the first half: as many as are in the layers up to the one nearest to the middle, in whole packs.
  std::int64_t half(std::int64_t begin, std::int64_t end, std::size_t axis, std::int32_t layers) {
    std::vector<std::int64_t> of_layer(layers, 0);
    for (auto* place = at(begin); place != at(end); ++place) ++of_layer[place->layer[axis]];
    const std::int64_t n = end - begin;
    std::int64_t best = 0, sum = 0;
    for (const std::int64_t count : of_layer) {
      sum += count;
      if (std::abs(2 * sum - n) < std::abs(2 * best - n)) best = sum;
    }
    if (4 * best < n || 4 * best > 3 * n) best = n / 2;  // nearly all are in one layer
    best = (best + multiple_ / 2) / multiple_ * multiple_;
    return std::clamp(best, std::min(multiple_, n - 1), n - 1);
  }

  /// Rows along the direction with the most layers; the direction with the fewest comes next, so that a layer of rows
  /// is small.
  void sort_rows(std::int64_t begin, std::int64_t end, const Layers& layers) {
    Axes axes{0, 1, 2};
    std::stable_sort(axes.begin(), axes.end(), [&](std::size_t a, std::size_t b) { return layers[a] > layers[b]; });
    if (row_axis_ >= 0) {
      const auto chosen = std::ranges::find(axes, static_cast<std::size_t>(row_axis_));
      std::rotate(axes.begin(), chosen, chosen + 1);
    }
    turn(begin, end, {axes[1], axes[2], axes[0]});
    std::sort(at(begin), at(end));
  }

  std::span<const Point> centres_, extents_;
  std::int64_t largest_, multiple_;
  int row_axis_;
  Array<PlacedElement> places_;
  TileOrder& tiles_;
};

}  // namespace

TileOrder compact_tiles(std::span<const Point> centres, std::span<const Point> extents,
                        std::vector<std::int32_t> elements, std::int64_t largest, std::int64_t multiple, int row_axis) {
  TileOrder tiles{std::move(elements), {0}};
  const std::int64_t n = tiles.order.size();
  if (n > 0) Halving(centres, extents, largest, multiple, row_axis, tiles).cut(n);
  return tiles;
}

}  // namespace pinball
