#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <kernels/exec/array.hpp>
#include <kernels/tensor.hpp>
#include <solver/base/lists_in_order.hpp>
#include <solver/base/state_archive.hpp>
#include <solver/contact/surface/surface.hpp>
#include <solver/contact/surface/surface_source.hpp>

namespace pinball {

/// Master segments and slave nodes: every exposed face is a segment, each of its nodes a slave, so that all bodies are
/// passed both ways. Faces behind elements that may soon erode are segments too, but wait: so lists
/// of segments and slaves last over erosions.
template <class S>
class SegmentSurface {
 public:
  struct Segment {
    std::int32_t node[4];  ///< of the node store, in the order of face_nodes
    std::int32_t slot;     ///< of the element
    std::int32_t face;     ///< in the order of face_nodes
    std::int32_t body;
    bool rigid;                           ///< the body moves as one
    std::array<std::int32_t, 8> corners;  ///< node numbers of the element
    S radius;                             ///< of the ball of the element's volume, report eq. (3.2): its size [length]
    S thickness;                          ///< V / A, of the undeformed element: its extent across the face [length]
    S size;                               ///< the smaller of both [length]
    S stiffness;  ///< K A^2 / V, of the undeformed element (Hallquist, Goudreau and Benson 1985) [force/length]
  };
  struct Slave {
    std::int32_t node;  ///< of the node store
    std::int32_t body;
    std::int32_t owner;  ///< the first of the active segments around it; without any, the first of those that are not
    S share;             ///< number of active segments around it over 4: 1 inside a surface, 1/2 at an edge of it [-]
    S radius;            ///< mean of the active segments around it [length]
    S stiffness;         ///< sum of a quarter of each active segment's [force/length]
  };

  /// Penetration beyond which a node is no longer taken for one that came in through the segment, over its radius [-]:
  /// a little less than the thickness of a cube, 1.61.
  static constexpr S deepest = S(1.5);

  SegmentSurface(const SurfaceSource<S>& source, SurfaceTopology topology) : topology_(std::move(topology)) {
    collect(source);
    update(source);
  }

  /// Segments of eroded elements end, and those that waited behind them become active; returns whether there are any.
  /// Nodes that are left without an active segment are slaves no more: they fly on as mass points.
  bool remove_eroded(const std::vector<std::int64_t>& eroded);
  /// Segments that the last remove_eroded() has made active, or has ended: those of one step.
  const std::vector<std::int32_t>& just_changed() const { return just_changed_; }
  /// Whether all exposed faces are segments. If not, those that did not wait take part after the next collect().
  bool complete() const { return active_segments_ == topology_.exposed_faces(); }
  /// Whether anything has eroded since the last collect().
  bool changed() const { return changed_; }
  /// Numbers segments and slaves anew: without those that have ended, with those that are to wait now. All are
  /// selected.
  void collect(const SurfaceSource<S>& source);
  /// Chooses segments that are asked for, by lists or because they lie around a slave that has a list: update() sees to
  /// no others. Between choose_none() and finish_choice(), by several threads.
  void choose_none() { asked_for_.assign(packs(), 0); }
  void choose(std::int32_t segment) { set_mark(asked_for_[segment / native_width<S>]); }
  void choose_around(std::size_t slave) {
    for (const std::int32_t segment : around(slave)) choose(segment);
  }
  void finish_choice();
  /// Spheres and planes of the chosen segments.
  void update(const SurfaceSource<S>& source);

  /// Whether a slave has an active segment. Those of waiting segments have not, nor those of ended ones.
  bool active(std::size_t slave) const { return slaves_[slave].share > S(0); }
  /// Whether a segment that the slave belongs to looks at a normal within 60 degrees. A node of a flat surface does not
  /// touch a face that moves along this surface.
  bool faces(std::size_t slave, const Vec3<S>& normal) const;
  /// Segments around a slave, waiting ones and ended ones too.
  std::span<const std::int32_t> around(std::size_t slave) const {
    return {around_.data() + around_first_[slave], around_.data() + around_first_[slave + 1]};
  }
  /// Whether some active segments belong to elements that have a corner in common with those of others: these are kept
  /// apart by the mesh, also where they are of several bodies.
  bool beside(std::span<const std::int32_t> some, std::span<const std::int32_t> others) const;
  /// The same of two segments, which are taken to be active.
  bool beside(std::int32_t a, std::int32_t b) const { return share_corner(segments_[a].corners, segments_[b].corners); }
  bool active_segment(std::int32_t segment) const { return active_[segment] > S(0); }
  /// Slaves of the nodes of a segment.
  const std::array<std::int32_t, 4>& slaves_of(std::int32_t segment) const { return slaves_of_[segment]; }
  bool exposed(std::int32_t slot, std::int32_t face) const { return (topology_.exposed(slot) >> face & 1) != 0; }
  const Surface& topology() const { return topology_; }
  const std::vector<Segment>& segments() const { return segments_; }
  const std::vector<Slave>& slaves() const { return slaves_; }  ///< sorted by node
  std::vector<std::int32_t> nodes() const;                      ///< of the slaves
  /// Records of four per segment: centre, and how far from it a node may be that touches: the distance of the farthest
  /// corner and deepest radii; 0 where the segment is not active.
  const Array<S>& sphere() const { return sphere_; }
  /// Records of four per segment: mean unit normal, 0 where the segment is not active, and how far the corners are out
  /// of the plane through the centre.
  const Array<S>& plane() const { return plane_; }
  void persist(StateArchive& archive, const SurfaceSource<S>& source);
  std::int64_t chosen() const;  ///< segments that update() sees to, in whole packs
  std::size_t bytes() const;

 private:
  std::vector<std::uint8_t> exposed_and_waiting(const SurfaceSource<S>& source) const;
  /// collect(), given per slot a bit for each face that is to be a segment.
  void collect_faces(const SurfaceSource<S>& source, const std::vector<std::uint8_t>& faces);
  void collect_segments(const SurfaceSource<S>& source, const std::vector<std::uint8_t>& faces);
  /// face: in the order of face_nodes.
  static Segment segment_of(const ContactElement& element, std::int32_t slot, int face);
  void collect_slaves(std::size_t nodes);
  /// Makes a segment active whose face is exposed, and no other. Returns whether it was not so.
  bool renew_activity(std::int32_t segment);
  void update_slave(std::size_t number);
  std::size_t packs() const { return (segments_.size() + native_width<S> - 1) / native_width<S>; }

  Surface topology_;
  std::vector<Segment> segments_;  ///< sorted by slot and face
  std::vector<Slave> slaves_;
  std::vector<std::int32_t> around_;                    ///< segments around each slave, one after the other
  std::vector<std::int32_t> around_first_;              ///< per slave and one more: into around_
  std::vector<std::array<std::int32_t, 4>> slaves_of_;  ///< per segment
  Array<std::int32_t> corner_;                          ///< of the segments, in tiles of W
  Array<S> active_;                                     ///< per segment, padded: 1 or 0 [-]
  Array<S> reach_;                                      ///< per segment, padded: deepest radii [length]
  std::vector<std::int32_t> chosen_;                    ///< packs of segments
  std::vector<std::uint8_t> asked_for_;                 ///< per pack
  Array<S> sphere_, plane_;
  std::vector<std::int32_t> just_changed_;
  std::int64_t active_segments_ = 0;
  bool changed_ = false;
};

}  // namespace pinball
