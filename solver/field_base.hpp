#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/point.hpp"

namespace pinball {

/// What does not change in the fields of a run, in the order of the scene.
struct FieldBase {
  std::span<const Point> initial;  ///< per node: where the scene has put it [length]; empty: not known
  /// What mesh files call nodes and elements, -1 where they are from no file; empty: no file gives them numbers.
  std::vector<std::int64_t> node_number, element_number;
  /// Of a piece of a mesh: places of its nodes and elements in the scene. Empty: all of them are here.
  std::vector<std::int64_t> node_place{}, element_place{};
};

}  // namespace pinball
