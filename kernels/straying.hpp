#pragma once

#include <cstdint>

#include "gather.hpp"
#include "rows.hpp"

/// How far nodes are from where they were expected: each to keep the velocity v that it had at the start of a time t,
/// x(t) = x + v t. Lists of what may touch hold while no node is further from there than allowed.
namespace pinball {

/// Nodes in packs of `row`, some perhaps several times.
template <class S>
struct ExpectedNodes {
  std::int64_t count = 0;              ///< with padding
  const std::int32_t* node = nullptr;  ///< of the store
  const S* start = nullptr;            ///< in packs, 6 components: position and velocity [length], [length/time]
  const S* allowed2 = nullptr;         ///< square of the distance that is allowed [length^2]
  int row = 1;                         ///< lanes of a pack
};

/// Squares of the distances of a pack of nodes, or of one lane alone, from where they are expected [length^2].
/// position: node records; elapsed: since the start [time].
template <class T>
PINBALL_FUNCTION T deviation2(const ExpectedNodes<ScalarOf<T>>& nodes, const ScalarOf<T>* position, ScalarOf<T> elapsed,
                              std::int64_t i) {
  const ScalarOf<T>* const start = nodes.start + first_in_rows<T>(nodes.row, i, 6);
  const int row = row_of<T>(nodes.row);
  const Vec3<T> x = gather_vectors<T>(position, nodes.node + i * width_of<T>);
  const Vec3<T> x0{load<T>(start), load<T>(start + row), load<T>(start + 2 * row)};
  const Vec3<T> v0{load<T>(start + 3 * row), load<T>(start + 4 * row), load<T>(start + 5 * row)};
  const Vec3<T> e = x - x0 - T(elapsed) * v0;
  return dot(e, e);
}

/// Which lanes of a pack are further away than allowed, one bit each; also where a position is not a number.
template <class T>
PINBALL_FUNCTION unsigned strayed(const ExpectedNodes<ScalarOf<T>>& nodes, const ScalarOf<T>* position,
                                  ScalarOf<T> elapsed, std::int64_t i) {
  const T e2 = deviation2<T>(nodes, position, elapsed, i);
  return lane_bits<T>(!(e2 <= load<T>(nodes.allowed2 + i * width_of<T>)));
}

/// Whether any node of a pack has, or of one lane.
template <class T>
struct NodesStray {
  using S = ScalarOf<T>;
  ExpectedNodes<S> nodes;
  const S* position;
  S elapsed;

  PINBALL_FUNCTION bool operator()(std::int64_t i) const { return strayed<T>(nodes, position, elapsed, i) != 0; }
};

}  // namespace pinball
