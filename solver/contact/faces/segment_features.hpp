#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <kernels/ball_tree.hpp>
#include <kernels/exec/array.hpp>
#include <solver/contact/search/pair_order.hpp>
#include <solver/contact/segments/edge_table.hpp>
#include <solver/contact/segments/segment_surface.hpp>

#include "feature_bounds.hpp"

namespace pinball {

/// Which nodes and edges of a segment are looked for: those that belong to it, so that each is met once, or all.
enum class FeaturesOf { owner, all };

/// The segment that an edge belongs to: the first that is active; negative: none is.
template <class S>
std::int32_t owner_of(const SegmentSurface<S>& surface, const EdgeTable<S>& edges, std::int32_t edge) {
  for (const std::int32_t s : edges.segments_of(edge)) {
    if (surface.active_segment(s)) return s;
  }
  return -1;
}

/// The nodes and edges of segments, side by side, so that all of a segment are compared with a box at once. Only
/// segments in pairs of boxes that meet are asked for: of all others nothing is worked out.
template <class S>
class SegmentFeatures {
 public:
  static constexpr int first_edge = 4;  ///< nodes are features 0 to 3 of a segment, edges those from 4 on
  static constexpr int features = 8;

  /// Forgets all; segments: how many there are.
  void clear(std::size_t segments);
  /// What is known of a segment holds no longer.
  void forget(std::int32_t segment) {
    known_[segment] = 0;
    asked_[segment] = 0;
  }
  /// Asks for a segment. May be called for the same one by several threads.
  void ask_for(std::int32_t segment);
  /// Works out what was asked for, and was not before.
  void collect(const FeatureBounds<S>& bounds, const SegmentSurface<S>& surface, const EdgeTable<S>& edges,
               FeaturesOf which);

  /// The same of the segments of a few pairs, asked for or not.
  void collect_those_of(const PairOrder::Pieces& pairs, const FeatureBounds<S>& bounds,
                        const SegmentSurface<S>& surface, const EdgeTable<S>& edges, FeaturesOf which);

  /// The features of a segment that was asked for whose boxes meet a box, one bit each; a node that a segment has twice
  /// is met once.
  unsigned meeting(std::int32_t segment, const MovingBox<S>& box) const {
    return meeting_boxes<Pack<S, native_width<S>>>(record_[place_[segment]].boxes, box);
  }
  MovingBox<S> box(std::int32_t segment, int feature) const { return get_box(record_[place_[segment]].boxes, feature); }
  const Facing<S>& facing(std::int32_t segment, int feature) const { return record_[place_[segment]].facing[feature]; }
  std::size_t bytes() const;

 private:
  struct alignas(64) Record {
    S boxes[12 * ball_group<S>];  ///< a group of moving boxes; those of features that are not looked for are empty
    Facing<S> facing[features];
  };
  static_assert(ball_group<S> >= features);

  /// Makes room for all records; `kept` of them, the first, stay.
  void make_room(std::int64_t kept);
  static void fill(Record& record, std::int32_t segment, const FeatureBounds<S>& bounds,
                   const SegmentSurface<S>& surface, const EdgeTable<S>& edges, FeaturesOf which);

  std::int64_t count_ = 0;                   ///< of records
  std::vector<std::int64_t> place_;          ///< per segment: its record; negative: none
  std::vector<std::uint8_t> asked_, known_;  ///< per segment: it was asked for; what its record has holds
  Array<Record> record_;                     ///< with room for more
  std::vector<std::int32_t> few_;            ///< segments whose records are made, kept for its memory
};

}  // namespace pinball
