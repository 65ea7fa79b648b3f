#pragma once

#include <cstdint>

#include <kernels/tensor.hpp>
#include <solver/contact/impulses/impulse_solver.hpp>

namespace pinball {

/// The row of two features that touch or may touch within the coming step (kernels/contact_impulse.hpp): a node or a
/// sphere against a face, or two edges.
struct FeatureRow {
  std::int64_t first, second;  ///< names that the pair keeps from step to step
  std::int32_t node[5];        ///< of the store
  double weight[5];            ///< negative for the nodes of body 1
  int nodes = 0;
  Vec3<double> direction;   ///< from body 2 to body 1
  double depth;             ///< penetration, negative for an open gap [length]
  double size;              ///< what the depth is compared with in reports [length]
  double reach;             ///< size of the segment, or of the smaller one: what gaps are found by [length]
  std::int32_t slave = -1;  ///< of a node against a face: its number in the surface
  bool dropped = false;     ///< another row has its part
  PairOf pair{};            ///< of the scene, by which they touch

  /// Adds the nodes of one side, whose weights sum to 1 or -1. Those with weights that are nothing but round-off are
  /// left out: a node right on a node is a row of two nodes. The largest weight takes up what they had.
  template <int count>
  void add_side(const std::int32_t (&numbers)[count], const double (&weights)[count], double sign) {
    constexpr double nothing = 1e-9;
    double left = 1;
    int largest = nodes;
    for (int k = 0; k < count; ++k) {
      if (weights[k] < nothing && weights[k] > -nothing) continue;
      node[nodes] = numbers[k];
      weight[nodes] = sign * weights[k];
      left -= weights[k];
      if (sign * weight[nodes] > sign * weight[largest]) largest = nodes;
      ++nodes;
    }
    weight[largest] += sign * left;
  }
  void add_node(std::int32_t number, double w) {
    node[nodes] = number;
    weight[nodes++] = w;
  }
  template <class S>
  void give_to(ImpulseSolver<S>& impulses) const {
    impulses.add_row(first, second, direction, depth, size, pair);
    for (int k = 0; k < nodes; ++k) impulses.add_node(node[k], weight[k]);
  }
};

/// What rows of a step are looked for with.
struct StepReach {
  double dt;           ///< of the step just made, and, as it is taken to be, of the coming one [time]
  double approach;     ///< twice the way that nodes can make towards each other, leaps and all [length]
  const float* depth;  ///< per node of the store: the deepest that it was in a row of the step before [length]
  bool some_deep;      ///< any of these is not zero
  const ContactPairs* pairs = nullptr;  ///< of the scene, by which things touch; null: there are none
  double leap = 0;  ///< the way that given motions may add to what velocities tell, towards each other [length]
};

/// Depth up to which edges may have passed each other, over the size of the smaller segment.
inline constexpr double deepest_edges = 0.1;

/// What touches looks at each other: largest cosine between a face around a node, or at an edge, and the other face, or
/// one at the other edge. What lies beside each other on one surface does not.
inline constexpr double most_facing = 0.2;

/// Cosine between the faces of an edge from which on it meets others at its ends: their nodes need not look at what
/// they touch. On a flat surface nodes at crossings meet faces. And from which on it meets edges that are nearly
/// parallel.
inline constexpr double sharp_at_end = 0.9, sharp_along = 0.5;

/// How far a gap may be open although nothing closes it yet, over the size of the pair: forces may in the coming step.
inline constexpr double open_gap = 0.02;

/// How far a node may be from a segment, on either side, over the size of the segment, to be looked at closely; what is
/// deeper did not come in through it. Boxes hold as much around their segments, so that all lists have the same of
/// these.
inline constexpr double near_gap = 0.15;

/// Whether a node may have come in through a segment, or come near it: no further away than near_gap but for what has
/// closed, or may close, within a step. What touched before may still be as deep. closing: in a step, but for the leap
/// that given motions may add [length].
inline bool may_touch(double gap, double closing, double leap, double size, double depth_before) {
  const double within = near_gap * size + (closing > 0 ? closing : 0.0);
  return gap > -within - depth_before && gap < within + (closing > 0 ? closing : 0.0) + 2 * leap;
}

/// Whether a gap is worth a row: up to open_gap, and twice what closes in a step at the present rate, and by a leap.
/// gap, size, leap [length]; closing: in a step [length].
inline bool may_close(double gap, double closing, double leap, double size) {
  return gap < open_gap * size + (closing + leap > 0 ? 2 * (closing + leap) : 0.0);
}

}  // namespace pinball
