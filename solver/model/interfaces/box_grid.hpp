#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <solver/base/point.hpp>

namespace pinball {

/// A box along the axes; empty until it has taken a point.
struct Bounds {
  Point low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};
  void take(const Point& x) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], x[k]);
      high[k] = std::max(high[k], x[k]);
    }
  }
  bool holds(const Point& x) const {
    for (std::size_t k = 0; k < 3; ++k) {
      if (x[k] < low[k] || x[k] > high[k]) return false;
    }
    return true;
  }
  bool empty() const { return low[0] > high[0] || low[1] > high[1] || low[2] > high[2]; }
};

inline Bounds common(const Bounds& a, const Bounds& b) {
  Bounds both = a;
  for (std::size_t k = 0; k < 3; ++k) {
    both.low[k] = std::max(a.low[k], b.low[k]);
    both.high[k] = std::min(a.high[k], b.high[k]);
  }
  return both;
}

/// Things by the cells of a grid over a box that their own boxes meet.
class BoxGrid {
 public:
  /// boxes: of the things, by their numbers. What does not meet the box is left out.
  BoxGrid(const std::vector<Bounds>& boxes, const Bounds& over) : box_(over) {
    const double most = std::clamp(std::cbrt(static_cast<double>(boxes.size())), 1.0, 100.0);
    cells_ = static_cast<int>(most);
    cell_length_ = INFINITY;
    for (std::size_t k = 0; k < 3; ++k) {
      const double length = over.high[k] - over.low[k];
      scale_[k] = length > 0 ? cells_ / length : 0.0;
      if (length > 0) cell_length_ = std::min(cell_length_, length / cells_);
    }
    cell_.resize(static_cast<std::size_t>(cells_) * cells_ * cells_);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (common(boxes[i], over).empty()) continue;
      const auto low = place(boxes[i].low), high = place(boxes[i].high);
      for (int z = low[2]; z <= high[2]; ++z) {
        for (int y = low[1]; y <= high[1]; ++y) {
          for (int x = low[0]; x <= high[0]; ++x) cell_[number({x, y, z})].push_back(i);
        }
      }
    }
  }
  /// The things that may hold a point in the box.
  const std::vector<std::size_t>& at(const Point& x) const { return cell_[number(place(x))]; }

  /// Calls visit(thing) for the things around a point in the box, nearer cells first, some of them several times, until
  /// all that is not visited yet is further away than reached().
  template <class Visit, class Reached>
  void outwards(const Point& from, const Visit& visit, const Reached& reached) const {
    const auto middle = place(from);
    for (int ring = 0; ring < cells_; ++ring) {
      for_ring(middle, ring, visit);
      if (reached() <= ring * cell_length_) return;
    }
  }

 private:
  std::array<int, 3> place(const Point& x) const {
    std::array<int, 3> cell{};
    for (std::size_t k = 0; k < 3; ++k) {
      cell[k] = static_cast<int>(std::clamp((x[k] - box_.low[k]) * scale_[k], 0.0, cells_ - 1.0));
    }
    return cell;
  }
  std::size_t number(const std::array<int, 3>& cell) const {  // 10^6 cells at most
    return (cell[2] * cells_ + cell[1]) * cells_ + cell[0];
  }
  template <class Visit>
  void for_ring(const std::array<int, 3>& middle, int ring, const Visit& visit) const {
    const auto low = [&](int k) { return std::max(0, middle[k] - ring); };
    const auto high = [&](int k) { return std::min(cells_ - 1, middle[k] + ring); };
    for (int z = low(2); z <= high(2); ++z) {
      for (int y = low(1); y <= high(1); ++y) {
        const bool shell = std::abs(z - middle[2]) == ring || std::abs(y - middle[1]) == ring;
        for (int x = low(0); x <= high(0); ++x) {
          if (!shell && std::abs(x - middle[0]) != ring) continue;
          for (const std::size_t i : cell_[number({x, y, z})]) visit(i);
        }
      }
    }
  }

  Bounds box_;
  int cells_ = 1;
  double cell_length_ = 0;  ///< the shortest edge of a cell [length]
  Point scale_{};
  std::vector<std::vector<std::size_t>> cell_;
};

}  // namespace pinball
