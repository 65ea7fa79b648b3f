#pragma once

#include <vector>

#include "deck_scene.hpp"

namespace pinball {

/// Yield stress of a foam over the compaction 1 - V/V_0, straight between points, rising.
struct DeckFoamCurve {
  std::vector<double> compaction, stress;

  /// Turns a curve that falls.
  void put_in_order();
  /// Cuts off what lies before a compaction, with a point there. Whether anything did.
  bool begin_at(double first);
  /// Cuts off what no volume reaches, with a point at the last compaction that counts. Whether anything did.
  bool end_below_one();

 private:
  double at(double x) const;
};

}  // namespace pinball
