#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <solver/base/state_archive.hpp>
#include <solver/contact/search/moving_balls.hpp>
#include <solver/contact/search/surface_motion.hpp>
#include <solver/contact/segments/segment_surface.hpp>
#include <solver/contact/surface/joined_bodies.hpp>

namespace pinball {

/// For each slave node the master segments that it may touch in a time to come. The broad phase is that of pinballs:
/// boxes over what moves, and lists that last while no node strays too far from its straight way.
template <class S>
class SlidelineSearch {
 public:
  using Slave = typename SegmentSurface<S>::Slave;
  using Segment = typename SegmentSurface<S>::Segment;

  /// self: a body may touch itself.
  SlidelineSearch(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, bool self);

  /// Builds the lists from nothing, for all segments and slaves: those that wait are listed beforehand. skin: scale of
  /// what nodes may stray, over the radius of their smallest elements; 0: the lists are for the present positions only.
  /// pairs: of the scene, which may touch, or null.
  void build(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, S skin,
             const ContactPairs* pairs = nullptr);
  /// Notes the length of the step just made.
  void count_step(S dt) { clock_.count_step(dt); }
  /// True while the lists have every node and segment that may touch.
  bool holds(const SurfaceSource<S>& source) const {
    return valid_ && !clock_.over() && motion_.holds(source.position, clock_.elapsed());
  }
  /// The lists hold no longer, and segments and slaves may be numbered anew.
  void invalidate() { valid_ = false; }

  const std::int32_t* candidates(std::size_t slave) const { return candidate_.data() + start_[slave]; }
  std::int64_t count(std::size_t slave) const { return start_[slave + 1] - start_[slave]; }
  const std::vector<std::int32_t>& listed() const { return candidate_; }  ///< segments
  /// A node touches a segment of its own body, or of one that is joined to this, only if they were well apart at first:
  /// what is near was kept apart by the mesh. The radius of a slave, which this is measured by, is that of the surface
  /// around it as it is now: lists, which last, have all that may pass.
  bool may_touch(const Slave& own, const Segment& other) const { return may_touch(own, other, own.radius); }
  void persist(StateArchive& archive, const SegmentSurface<S>& surface, std::int32_t node_count);
  std::int64_t entries() const { return candidate_.size(); }  ///< of all lists
  std::size_t bytes() const;

 private:
  S least_radius(const Slave& own) const { return reference_node_[own.node][3]; }
  bool may_touch(const Slave& own, const Segment& other, S own_radius) const;
  void watch_nodes(const SurfaceSource<S>& source, const SegmentSurface<S>& surface);
  void move_segments(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, S horizon);
  void move_slaves(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, S horizon);
  void find(const SegmentSurface<S>& surface, const ContactPairs* pairs);

  bool self_;
  JoinedBodies joined_;
  std::vector<std::array<float, 4>> reference_node_;    ///< per node of the store: undeformed, and as fourth the radius
                                                        ///< of the smallest element around it [length]
  std::vector<std::array<float, 3>> reference_centre_;  ///< per slot, undeformed [length]
  bool valid_ = false, watched_ = false;
  ListClock<S> clock_;
  SurfaceMotion<S> motion_;
  MovingBalls<S> segments_, slaves_;
  BallTree<S> boxes_;                    ///< over the segments
  std::vector<std::int64_t> start_;      ///< per slave and one more: into candidate_
  std::vector<std::int32_t> candidate_;  ///< segments
};

}  // namespace pinball
