#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <solver/base/state_archive.hpp>

#include "side_patterns.hpp"

namespace pinball {

/// How the two sides of a pair touch each other.
struct PairRule {
  double friction = 0, static_friction = 0;  ///< coefficients, sliding and at rest [-]
  double friction_decay = 0;                 ///< from the one at rest to the one that slides [time/length]
  double start = 0, end = std::numeric_limits<double>::infinity();  ///< when they may touch [time]
  bool alone = false;                                               ///< there is no second side: among each other
};

/// By which pair two things touch.
struct PairOf {
  std::int16_t pair = -1;  ///< -1: no pair of the scene
  std::int8_t sign = 0;    ///< 1: the first thing is on the first side; -1: on the second; 0: both are on both
  bool may = true;         ///< may touch at all
};

/// What belongs to which sides. Side 2 p is the first of pair p, 2 p + 1 the second, 2 P + t the second of tie t, and
/// 2 P + T + r rigid body r to which nodes are attached; to these belong faces, with their elements and nodes. Sides of
/// nodes alone have these numbers and 2 P + T + R more. Groups are those of the patterns.
struct SurfaceSides {
  std::vector<PairRule> rules;  ///< of P pairs; none: all may touch all
  std::int32_t ties = 0;        ///< T
  std::int32_t rigid = 0;       ///< R
  SidePatterns patterns;
  std::vector<std::int32_t> element;              ///< group per slot
  std::vector<std::array<std::int32_t, 6>> face;  ///< group per slot and face; empty: that of the element
  std::vector<std::int32_t> node;                 ///< group per node of the store
  std::vector<std::int16_t> attached_to;  ///< number below R per node of the store, or -1; empty: none is attached

  std::int32_t sides() const { return 2 * rules.size() + ties + rigid; }
};

/// Which things may touch which, and by which pair: tables over groups, looked up when lists are made. Where several
/// pairs name the same two things, the last one that may touch at the time counts.
class ContactPairs {
 public:
  /// Throws std::length_error for more groups than tables hold.
  explicit ContactPairs(SurfaceSides sides);

  /// Chooses the pairs that may touch at a time; returns whether others do than before.
  bool set_time(double time);
  /// Which tie holds each node; -1: none. Empty: nothing is tied.
  void set_tied(std::vector<std::int16_t> tie_of_node);
  std::size_t count() const { return sides_.rules.size(); }
  const PairRule& rule(std::int16_t pair) const { return sides_.rules[pair]; }
  bool has_friction() const;

  /// Of a node and a face with these corners.
  PairOf node_and_face(std::int32_t node, std::int64_t slot, std::int32_t face,
                       std::span<const std::int32_t, 4> corners) const {
    const std::int32_t own = sides_.node[node], other = face_group(slot, face);
    PairOf pair = touching(own, other);
    pair.may = pair.may && !(tied_to(node, other) || any_tied_to(corners, own) || all_attached(node, corners));
    return pair;
  }
  /// Of the edges from node a to b and from c to d.
  PairOf edges(std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d) const {
    const std::int32_t own = edge_group(a, b), other = edge_group(c, d);
    PairOf pair = touching(own, other);
    pair.may = pair.may && !(tied_to(a, other) || tied_to(b, other) || tied_to(c, own) || tied_to(d, own) ||
                             all_attached(a, std::array{b, c, d}));
    return pair;
  }
  /// Of the balls of two elements.
  PairOf elements(std::int64_t slot1, std::span<const std::int32_t> corners1, std::int64_t slot2,
                  std::span<const std::int32_t> corners2) const {
    const std::int32_t own = sides_.element[slot1], other = sides_.element[slot2];
    PairOf pair = touching(own, other);
    pair.may = pair.may && !(any_tied_to(corners1, other) || any_tied_to(corners2, own));
    return pair;
  }
  /// Whether anything of two faces may touch: their nodes, their edges or themselves.
  bool faces_may(std::int64_t slot1, std::int32_t face1, std::span<const std::int32_t, 4> corners1, std::int64_t slot2,
                 std::int32_t face2, std::span<const std::int32_t, 4> corners2) const;
  void persist(StateArchive& archive);
  std::size_t bytes() const;

 private:
  std::int32_t face_group(std::int64_t slot, std::int32_t face) const {
    return sides_.face.empty() ? sides_.element[slot] : sides_.face[slot][face];
  }
  std::int32_t edge_group(std::int32_t a, std::int32_t b) const {
    return edge_[sides_.node[a] * groups_ + sides_.node[b]];
  }
  PairOf touching(std::int32_t own, std::int32_t other) const { return touching_[own * groups_ + other]; }
  bool tied_to(std::int32_t node, std::int32_t group) const {
    if (tie_of_node_.empty() || tie_of_node_[node] < 0) return false;
    return second_of_tie_[tie_of_node_[node] * groups_ + group] != 0;
  }
  bool any_tied_to(std::span<const std::int32_t> nodes, std::int32_t group) const {
    for (const std::int32_t node : nodes) {
      if (tied_to(node, group)) return true;
    }
    return false;
  }
  /// Whether all of them are attached to one rigid body, so that nothing moves them against each other.
  bool all_attached(std::int32_t node, std::span<const std::int32_t> others) const {
    if (sides_.attached_to.empty() || sides_.attached_to[node] < 0) return false;
    return std::ranges::all_of(others,
                               [&](std::int32_t n) { return sides_.attached_to[n] == sides_.attached_to[node]; });
  }
  void find_edge_groups();
  void fill_tables();
  void fill_pair(std::int16_t pair);

  SurfaceSides sides_;
  std::size_t groups_ = 0;
  std::vector<std::int32_t> edge_;  ///< per two groups of nodes: that of an edge between such
  /// Per tie and group: belongs to the second side of the tie. Behind them the same of rigid bodies.
  std::vector<std::uint8_t> second_of_tie_;
  std::vector<PairOf> touching_;           ///< per two groups
  std::vector<std::uint8_t> active_;       ///< per pair: may touch at present
  std::vector<std::int16_t> tie_of_node_;  ///< tie t, or T + r: attached to rigid body r
};

}  // namespace pinball
