#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include <kernels/compress.hpp>
#include <solver/contact/search/pair_order.hpp>
#include <solver/contact/segments/edge_table.hpp>
#include <solver/contact/segments/segment_surface.hpp>

#include "feature_bounds.hpp"
#include "segment_features.hpp"

namespace pinball {

/// What features of pairs of segments are found by.
template <class S>
struct FeatureScope {
  const SegmentSurface<S>& surface;
  const EdgeTable<S>& edges;
  const FeatureBounds<S>& bounds;
  const SegmentFeatures<S>& features;
  const ContactPairs* allowed;  ///< the pairs of the scene that may touch, or null
};

/// Adds nodes of the one segment that may touch the other, as numbers of slave and segment. bits: those that meet its
/// box.
template <class S, class Wanted>
void add_nodes_of_pair(const FeatureScope<S>& scope, std::int32_t own, std::int32_t other, unsigned bits,
                       const Wanted& wanted, PairColumns& found) {
  const auto& segment = scope.surface.segments()[other];
  for (; bits != 0; bits &= bits - 1) {
    const int k = lowest_bit(bits);
    const std::int32_t slave = scope.surface.slaves_of(own)[k], node = scope.surface.segments()[own].node[k];
    if (!scope.features.facing(own, k).may_face(scope.bounds.facing(other))) continue;
    if (std::ranges::find(segment.corners, node) != segment.corners.end()) continue;
    if (scope.allowed != nullptr && !scope.allowed->node_and_face(node, segment.slot, segment.face, segment.node).may) {
      continue;
    }
    if (wanted.node(slave, other)) found.add(slave, other);
  }
}

/// Adds the nodes of each of two segments that may touch the other one, and the edges that may touch, the lower number
/// first. wanted.features(own, other): which nodes of a segment are wanted with another one, and which of its edges
/// with all of the other's, a bit each; wanted.node(slave, segment), wanted.edges(low, high): whether such a pair is.
template <class S, class Wanted>
void add_features_of_pair(const FeatureScope<S>& scope, std::int32_t a, std::int32_t b, const Wanted& wanted,
                          PairColumns& nodes, PairColumns& edges) {
  constexpr int first_edge = SegmentFeatures<S>::first_edge;
  constexpr unsigned all_nodes = (1U << first_edge) - 1;
  const unsigned near_b = scope.features.meeting(a, scope.bounds.segment_box(b));
  const unsigned near_a = scope.features.meeting(b, scope.bounds.segment_box(a));
  const unsigned wanted_a = wanted.features(a, b), wanted_b = wanted.features(b, a);
  add_nodes_of_pair(scope, a, b, near_b & wanted_a & all_nodes, wanted, nodes);
  add_nodes_of_pair(scope, b, a, near_a & wanted_b & all_nodes, wanted, nodes);
  const unsigned edges_of_b = near_a & ~all_nodes, wanted_of_b = edges_of_b & wanted_b;
  if (edges_of_b == 0) return;
  for (unsigned of_a = near_b & ~all_nodes & (wanted_of_b != 0 ? ~0U : wanted_a); of_a != 0; of_a &= of_a - 1) {
    const int i = lowest_bit(of_a);
    const std::int32_t e = scope.edges.edges_of(a)[i - first_edge];
    unsigned of_b = (wanted_a >> i & 1U) != 0 ? edges_of_b : wanted_of_b;
    of_b &= scope.features.meeting(b, scope.features.box(a, i));
    for (; of_b != 0; of_b &= of_b - 1) {
      const int j = lowest_bit(of_b);
      const std::int32_t f = scope.edges.edges_of(b)[j - first_edge];
      if (!scope.features.facing(a, i).may_face(scope.features.facing(b, j)) || scope.edges.share_node(e, f)) continue;
      if (scope.allowed != nullptr) {
        const auto &own = scope.edges.edges()[e].node, &other = scope.edges.edges()[f].node;
        if (!scope.allowed->edges(own[0], own[1], other[0], other[1]).may) continue;
      }
      const std::int32_t low = std::min(e, f), high = std::max(e, f);
      if (wanted.edges(low, high)) edges.add(low, high);
    }
  }
}

}  // namespace pinball
