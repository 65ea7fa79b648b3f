#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <kernels/exec.hpp>
#include <solver/base/piece_share.hpp>
#include <solver/base/state_archive.hpp>
#include <solver/contact/contact_settings.hpp>
#include <solver/contact/search/box_pairs.hpp>
#include <solver/contact/search/surface_motion.hpp>
#include <solver/contact/segments/edge_table.hpp>
#include <solver/contact/segments/segment_surface.hpp>
#include <solver/contact/spheres/sphere_surface.hpp>

#include "feature_bounds.hpp"
#include "features_in_pair.hpp"
#include "found_features.hpp"
#include "listed_pairs.hpp"
#include "segment_features.hpp"
#include "sorted_pairs.hpp"

namespace pinball {

/// What may touch in a time to come: nodes and segments, edges and edges, spheres and all of these.
///
/// Found by boxes over the segments, which hold each where it may be (kernels/ball_tree.hpp): what is in no pair of
/// boxes that meet cannot touch, whatever its shape, size and speed. Each node and each edge belongs to one of its
/// segments, so that each pair of them is met once. (Representative triangles: S. Curtis, R. Tamstorf and D. Manocha,
/// "Fast collision detection for deformable models using representative-triangles", I3D 2008.)
///
/// Lists are of active segments that the mesh does not keep apart. What erosion makes of the others is seen to when it
/// happens, by the same boxes.
///
/// Lists last while no node strays too far from its straight way.
template <class S>
class FeatureLists {
 public:
  using NodePairs = ListedNodes<S>;
  using EdgePairs = ListedEdges<S>;
  using Pair = std::array<std::int32_t, 2>;
  struct SpherePairs {
    std::vector<Pair> with_segments;  ///< a sphere and a segment
    std::vector<Pair> with_spheres;
  };

  /// The pairs of the scene that may touch, or null; they have to stay. Lists are to be built anew when others may.
  void set_pairs(const ContactPairs* pairs) { allowed_ = pairs; }
  /// Builds the lists from nothing. dt: the step just made, or the coming one where that is longer [time]; leap: the
  /// way that given motions may add to what velocities tell [length]; last: the lists are to last, else they are for
  /// the coming step alone. depth: per node of the store, how deep it is [length].
  void build(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, const EdgeTable<S>& edges,
             const SphereSurface<S>& spheres, const ContactSettings& settings, const std::vector<float>& depth, S dt,
             S leap, bool last);
  /// Notes the length of the step just made.
  void count_step(S dt) { clock_.count_step(dt); }
  /// True while the lists have all that may touch.
  bool holds(const SurfaceSource<S>& source) const {
    return may_hold() && motion_.holds(source.position, clock_.elapsed());
  }
  /// Whether they were built for such a step, and such a leap within it.
  bool reach(S dt, S leap) const { return dt <= scope_.last_step && leap <= scope_.leap; }
  /// The same as holds(), where no node has strayed further than expected.
  bool may_hold() const { return valid_ && !clock_.over(); }
  /// What nodes are expected to do, and for how long they have done so [time].
  ExpectedNodes<S> expected() const { return motion_.expected(); }
  S elapsed() const { return clock_.elapsed(); }
  /// Takes in what segments that have just become active, or have ended, make of pairs that were left out: these are in
  /// more_nodes() and more_edges(). Returns whether the lists have become longer.
  bool follow_erosion(const SegmentSurface<S>& surface, const EdgeTable<S>& edges, const SphereSurface<S>& spheres);
  /// Takes in what nodes that have strayed further than expected may meet, if these are few, and there are no spheres:
  /// then the lists have all that may touch again, and more_nodes() and more_edges() what is new.
  bool follow_strays(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, const EdgeTable<S>& edges,
                     const SphereSurface<S>& spheres, const std::vector<float>& depth);
  /// The lists hold no longer, and segments, slaves and edges may be numbered anew.
  void invalidate() { valid_ = false; }

  const NodePairs& nodes() const { return nodes_; }
  const EdgePairs& edges() const { return edges_; }
  const SpherePairs& spheres() const { return spheres_; }
  const SortedPairs& more_nodes() const { return more_nodes_; }
  const SortedPairs& more_edges() const { return more_edges_; }
  std::int64_t entries() const {
    return nodes_.pieces.entries + edges_.pieces.entries + std::ssize(spheres_.with_segments) +
           std::ssize(spheres_.with_spheres);
  }
  std::int64_t places() const { return entries() - nodes_.pieces.entries + nodes_.pieces.places; }
  void persist(StateArchive& archive, const SegmentSurface<S>& surface, const EdgeTable<S>& edges,
               const SphereSurface<S>& spheres, const ContactSettings& settings, std::int32_t node_count);
  bool valid() const { return valid_; }
  std::size_t bytes() const;

 private:
  void check(const StateArchive& archive, const SegmentSurface<S>& surface, const EdgeTable<S>& edges,
             const SphereSurface<S>& spheres) const;
  S steps_to_last(const SegmentSurface<S>& surface) const;
  void watch_nodes(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, const SphereSurface<S>& spheres);
  /// Pairs of boxes, of a share of them, and what these are found by. nodes: as when motion_ was started.
  void find_pairs(const NodeRecords<S>& nodes, const SegmentSurface<S>& surface, const SphereSurface<S>& spheres,
                  const ContactSettings& settings, const PieceShare& share);
  /// Whether what boxes hold may touch: not segments that wait or have ended, nor those that the mesh keeps apart.
  /// a < b or both of segments: numbers of boxes.
  bool may_touch(const SegmentSurface<S>& surface, const SphereSurface<S>& spheres, bool self, std::int32_t a,
                 std::int32_t b) const;
  /// What may touch in these and in those of other processes.
  void find_features(const SegmentSurface<S>& surface, const EdgeTable<S>& edges, const PieceShare& share);
  /// What lists may not have yet: pairs of a node or an edge that has changed, and of a segment that has.
  struct Changed {
    const FeatureLists& lists;

    unsigned features(std::int32_t own, std::int32_t other) const {
      const unsigned all_nodes = lists.has_changed(other) ? (1U << SegmentFeatures<S>::first_edge) - 1 : 0;
      return lists.changed_features_[own] | all_nodes;
    }
    bool node(std::int32_t slave, std::int32_t segment) const { return !lists.nodes_.has(slave, segment); }
    bool edges(std::int32_t low, std::int32_t high) const { return !lists.edges_.has(low, high); }
  };
  /// Whether a segment has strayed, or is active since the lists were made.
  bool has_changed(std::int32_t segment) const {
    return near_change_[segment] == has_strayed || was_active_[segment] == 0;
  }
  /// The nodes and edges of a segment that have changed, of those that are looked for with it, one bit each.
  std::uint8_t changed_features_of(const SegmentSurface<S>& surface, const EdgeTable<S>& edges,
                                   std::int32_t segment) const;
  /// Whether something may be missing of a segment: it has changed, or something that is looked for with it.
  bool looks_anew(std::int32_t segment) const {
    return near_change_[segment] != 0 && (changed_features_[segment] != 0 || has_changed(segment));
  }
  /// Pairs of these segments, and of those that meet them: near_pairs_, and what has come to spheres.
  void find_near_pairs(const SegmentSurface<S>& surface, const SphereSurface<S>& spheres);
  /// Marks slaves that have changed, and what is around them, or takes the marks away.
  void mark_changed(const SegmentSurface<S>& surface);
  void unmark_changed(const SegmentSurface<S>& surface);
  /// Looks for what is near changed slaves, and takes the marks away.
  void take_in_more(const SegmentSurface<S>& surface, const EdgeTable<S>& edges, const SphereSurface<S>& spheres);
  FeaturesOf which_features() const { return allowed_ == nullptr ? FeaturesOf::owner : FeaturesOf::all; }
  void join_sphere_pairs();

  const ContactPairs* allowed_ = nullptr;
  bool valid_ = false, watched_ = false;
  ListClock<S> clock_;
  SurfaceMotion<S> motion_;
  ListScope<S> scope_;
  FeatureBounds<S> bounds_;
  BoxPairs<S> pairs_;
  bool self_ = true;  ///< a body may touch itself
  S skin_ = 0;        ///< contact.skin [-]
  SegmentFeatures<S> features_;
  std::vector<std::uint8_t> was_active_;  ///< per segment, when the lists were made
  NodePairs nodes_;
  EdgePairs edges_;
  SpherePairs spheres_;
  SortedPairs more_nodes_, more_edges_;  ///< that came last
  std::vector<std::int32_t> strayed_;    ///< slaves, by follow_strays()
  /// Those that strayed, and those of segments that look elsewhere or that erosion has changed.
  std::vector<std::int32_t> changed_slaves_;
  std::vector<std::int32_t> near_segments_;  ///< around changed slaves
  static constexpr std::uint8_t is_changed = 1, has_strayed = 2;
  std::vector<std::uint8_t> changed_slave_, near_change_;  ///< marks of both, taken away again
  std::vector<std::uint8_t> changed_features_;             ///< the same, per segment near a change
  std::vector<std::int32_t> looking_segments_;             ///< those of near_segments_ that look_anew()
  // What follows is kept for its memory alone.
  std::array<std::vector<Pair>, fixed_pieces> found_sphere_segments_, found_spheres_;
  PairOrder::Pieces near_pairs_;
  std::array<std::vector<std::int32_t>, fixed_pieces> near_groups_;
};

}  // namespace pinball
