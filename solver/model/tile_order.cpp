#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <kernels/exec.hpp>

#include "ordering.hpp"

namespace pinball {
namespace {

using Layers = std::array<std::int32_t, 3>;

/// Cuts ranges of elements into halves until they are tiles.
class Halving {
 public:
  Halving(const std::vector<Point>& centres, const std::vector<Point>& extents, std::int64_t largest,
          std::int64_t multiple, int row_axis, TileOrder& tiles)
      : centres_(centres),
        extents_(extents),
        largest_(largest),
        multiple_(multiple),
        row_axis_(row_axis),
        layer_(centres.size()),
        tiles_(tiles) {}

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
    const std::array<std::size_t, 3> axes{axis, (axis + 1) % 3, (axis + 2) % 3};
    std::nth_element(at(begin), at(middle), at(end),
                     [&](std::int32_t a, std::int32_t b) { return before(a, b, axes); });
    return middle;
  }

  std::vector<std::int32_t>::iterator at(std::int64_t i) { return tiles_.order.begin() + i; }

  /// Numbers the layers of elements in each direction, of a thickness that is the mean of the elements'.
  Layers count_layers(std::int64_t begin, std::int64_t end) {
    Point low, high, thickness{};
    low.fill(std::numeric_limits<double>::infinity());
    high.fill(-std::numeric_limits<double>::infinity());
    for (auto e = at(begin); e != at(end); ++e) {
      for (std::size_t k = 0; k < 3; ++k) {
        const double c = centres_[*e][k];
        low[k] = std::min(low[k], c);
        high[k] = std::max(high[k], c);
        thickness[k] += extents_[*e][k] / (end - begin);
      }
    }
    // Not more layers than elements, however far small bodies are apart.
    for (std::size_t k = 0; k < 3; ++k) {
      thickness[k] = std::max(thickness[k], (high[k] - low[k]) / (end - begin));
    }
    Layers count{1, 1, 1};
    for (auto e = at(begin); e != at(end); ++e) {
      for (std::size_t k = 0; k < 3; ++k) {
        const double height = centres_[*e][k] - low[k];
        const auto number = height > 0 ? static_cast<std::int32_t>(std::lround(height / thickness[k])) : 0;
        layer_[*e][k] = number;
        count[k] = std::max(count[k], number + 1);
      }
    }
    return count;
  }

  bool before(std::int32_t a, std::int32_t b, const std::array<std::size_t, 3>& axes) const {
    const Layers& la = layer_[a];
    const Layers& lb = layer_[b];
    for (const std::size_t k : axes) {
      if (la[k] != lb[k]) return la[k] < lb[k];
    }
    return a < b;
  }

  /// That with the most layers. Rows are cut where they are far longer than the tile is thick.
  std::size_t axis_to_cut(Layers layers) const {
    if (row_axis_ >= 0) layers[row_axis_] = (layers[row_axis_] + 3) / 4;
    return std::max_element(layers.begin(), layers.end()) - layers.begin();
  }

  /// Elements of the first half: as many as are in the layers up to the one nearest to the middle, in whole packs.
  std::int64_t half(std::int64_t begin, std::int64_t end, std::size_t axis, std::int32_t layers) {
    std::vector<std::int64_t> of_layer(layers, 0);
    for (auto e = at(begin); e != at(end); ++e) {
      ++of_layer[layer_[*e][axis]];
    }
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
    std::array<std::size_t, 3> axes{0, 1, 2};
    std::stable_sort(axes.begin(), axes.end(), [&](std::size_t a, std::size_t b) { return layers[a] > layers[b]; });
    if (row_axis_ >= 0) {
      const auto chosen = std::ranges::find(axes, static_cast<std::size_t>(row_axis_));
      std::rotate(axes.begin(), chosen, chosen + 1);
    }
    const std::array<std::size_t, 3> slowest_first{axes[1], axes[2], axes[0]};
    std::sort(at(begin), at(end), [&](std::int32_t a, std::int32_t b) { return before(a, b, slowest_first); });
  }

  const std::vector<Point>& centres_;
  const std::vector<Point>& extents_;
  std::int64_t largest_, multiple_;
  int row_axis_;
  std::vector<Layers> layer_;
  TileOrder& tiles_;
};

}  // namespace

TileOrder compact_tiles(const std::vector<Point>& centres, const std::vector<Point>& extents,
                        std::vector<std::int32_t> elements, std::int64_t largest, std::int64_t multiple, int row_axis) {
  TileOrder tiles{std::move(elements), {0}};
  const std::int64_t n = tiles.order.size();
  if (n > 0) Halving(centres, extents, largest, multiple, row_axis, tiles).cut(n);
  return tiles;
}

}  // namespace pinball
