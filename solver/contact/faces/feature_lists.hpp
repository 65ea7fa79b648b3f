#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include <kernels/exec.hpp>
#include <solver/base/state_archive.hpp>
#include <solver/contact/contact_settings.hpp>
#include <solver/contact/search/box_pairs.hpp>
#include <solver/contact/search/surface_motion.hpp>
#include <solver/contact/segments/edge_table.hpp>
#include <solver/contact/segments/segment_surface.hpp>

#include "feature_bounds.hpp"
#include "sphere_surface.hpp"

namespace pinball {

/// Places of a list in pieces, each of which begins at a whole pack: between the end of a piece and the beginning of
/// the next there are places that name valid things and do not count. A short list has few pieces, so that packs are
/// full.
struct ListPieces {
  static std::int64_t count_for(std::int64_t entries) {
    return std::clamp<std::int64_t>(entries / 2048, 1, fixed_pieces);
  }
  std::int64_t count = 0;  ///< of pieces
  std::array<std::int64_t, fixed_pieces> begin{}, end{};
  std::int64_t places = 0;   ///< with those between
  std::int64_t entries = 0;  ///< without
};

/// What may touch in a time to come: nodes and segments, edges and edges, spheres and all of these.
///
/// Found by boxes over the segments, which hold each where it may be (kernels/ball_tree.hpp): what is in no pair of
/// boxes that meet cannot touch, whatever its shape, size and speed. Each node and each edge belongs to one of its
/// segments, so that each pair of them is met once. (Representative triangles: S. Curtis, R. Tamstorf and D. Manocha,
/// "Fast collision detection for deformable models using representative-triangles", I3D 2008.)
///
/// Lists last while no node strays too far from its straight way.
template <class S>
class FeatureLists {
 public:
  /// A node and a segment, in the order of the nodes.
  struct NodePairs {
    ListPieces pieces;
    std::vector<std::int32_t> slave, segment;  ///< numbers in the surface
    AlignedArray<std::int32_t> node;           ///< of the slave
    AlignedArray<S> size, radius;              ///< of the segment [length]
  };
  struct EdgePairs {
    ListPieces pieces;
    std::vector<std::int32_t> first, second;         ///< numbers in the table of edges
    std::array<AlignedArray<std::int32_t>, 4> node;  ///< ends of the first and of the second
    AlignedArray<S> size;                            ///< of the first segments of both, together [length]
  };
  using Pair = std::array<std::int32_t, 2>;
  struct SpherePairs {
    std::vector<Pair> with_segments;  ///< a sphere and a segment
    std::vector<Pair> with_spheres;
  };

  /// Builds the lists from nothing, for all segments, those that wait too. dt: the step just made; last: the lists are
  /// to last, else they are for the coming step alone. depth: per node of the store, how deep it is [length].
  void build(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, const EdgeTable<S>& edges,
             const SphereSurface<S>& spheres, const ContactSettings& settings, const std::vector<float>& depth, S dt,
             bool last);
  /// Notes the length of the step just made.
  void count_step(S dt) { clock_.count_step(dt); }
  S last_step() const { return clock_.last_step(); }
  /// True while the lists have all that may touch.
  bool holds(const SurfaceSource<S>& source) const {
    return valid_ && !clock_.over() && motion_.holds(source.position, clock_.elapsed());
  }
  /// The lists hold no longer, and segments, slaves and edges may be numbered anew.
  void invalidate() { valid_ = false; }

  const NodePairs& nodes() const { return nodes_; }
  const EdgePairs& edges() const { return edges_; }
  const SpherePairs& spheres() const { return spheres_; }
  std::int64_t entries() const {
    return nodes_.pieces.entries + edges_.pieces.entries +
           static_cast<std::int64_t>(spheres_.with_segments.size() + spheres_.with_spheres.size());
  }
  std::int64_t places() const { return entries() - nodes_.pieces.entries + nodes_.pieces.places; }
  void persist(StateArchive& archive, const SegmentSurface<S>& surface, const EdgeTable<S>& edges);
  std::size_t bytes() const;

 private:
  /// Found in the pairs of boxes of a piece.
  struct Found {
    std::vector<Pair> nodes, edges, sphere_segments, spheres;
  };
  void watch_nodes(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, const SphereSurface<S>& spheres);
  void find(const SegmentSurface<S>& surface, const EdgeTable<S>& edges, const SphereSurface<S>& spheres,
            const ContactSettings& settings);
  void find_in_pair(const SegmentSurface<S>& surface, const EdgeTable<S>& edges, std::int32_t a, std::int32_t b,
                    Found& found) const;
  void find_nodes_in_pair(const SegmentSurface<S>& surface, std::int32_t own, std::int32_t other,
                          const MovingBox<S>& box, Found& found) const;
  void sort_pairs(std::vector<Pair> Found::*some, std::int64_t firsts, ListPieces& pieces,
                  std::vector<std::int32_t>& first, std::vector<std::int32_t>& second);
  void join_sphere_pairs();
  /// What the kernels read of each pair.
  void fill_node_pairs(const SegmentSurface<S>& surface);
  void fill_edge_pairs(const SegmentSurface<S>& surface, const EdgeTable<S>& edges);

  bool valid_ = false, watched_ = false;
  ListClock<S> clock_;
  SurfaceMotion<S> motion_;
  FeatureBounds<S> bounds_;
  BoxPairs<S> pairs_;
  NodePairs nodes_;
  EdgePairs edges_;
  SpherePairs spheres_;
  std::array<Found, fixed_pieces> found_;  // kept for its memory alone, as the next
  std::vector<std::int64_t> end_of_first_;
};

}  // namespace pinball
