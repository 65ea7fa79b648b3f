#pragma once

#include <cstdint>
#include <pinball/solver/aligned_array.hpp>
#include <pinball/solver/model.hpp>
#include <pinball/solver/surface.hpp>
#include <vector>

namespace pinball {

/// Master segments and slave nodes of the slidelines: every exposed face is a segment, each of its nodes a slave, so
/// that all bodies are passed both ways.
template <class S>
class SlidelineSurface {
 public:
  struct Segment {
    std::int32_t node[4];  ///< of the node store, in the order of face_nodes
    std::int32_t slot;     ///< of the element
    std::int32_t face;     ///< in the order of face_nodes
    std::int32_t body;
    S radius;     ///< of the ball of the element's volume, report eq. (3.2): its size [length]
    S stiffness;  ///< K A^2 / V, of the undeformed element (Hallquist, Goudreau and Benson 1985) [force/length]
  };
  struct Slave {
    std::int32_t node;  ///< of the node store
    std::int32_t body;
    S share;      ///< number of segments around it over 4: 1 inside a surface, 1/2 at an edge of it [-]
    S radius;     ///< mean of the segments around it [length]
    S stiffness;  ///< sum of a quarter of each segment's [force/length]
  };

  /// Penetration beyond which a node is no longer taken for one that came in through the segment, over its radius [-]:
  /// a little less than the thickness of a cube, 1.61.
  static constexpr S deepest = S(1.5);

  explicit SlidelineSurface(const Model<S>& model) : topology_(model) { collect(model); }

  /// Takes out what has eroded; returns whether segments or slaves have changed, and then the slaves before. Nodes that
  /// are left without a face are slaves no more: they fly on as mass points.
  bool remove_eroded(const Model<S>& model, const std::vector<TileResult<S>>& tiles, std::vector<Slave>& before);
  /// Spheres and planes of all segments.
  void update(const Model<S>& model);

  /// Whether a segment that the slave belongs to looks at a normal within 60 degrees. A node of a flat surface does not
  /// touch a face that moves along this surface.
  bool faces(std::size_t slave, const Vec3<S>& normal) const;
  bool exposed(std::int32_t slot, std::int32_t face) const { return (topology_.exposed(slot) >> face & 1) != 0; }
  std::int32_t surface_elements() const { return surface_elements_; }
  const std::vector<Segment>& segments() const { return segments_; }
  const std::vector<Slave>& slaves() const { return slaves_; }  ///< sorted by node
  /// Records of four per segment: centre, and how far from it a node may be that touches: the distance of the farthest
  /// corner and deepest radii.
  const AlignedArray<S>& sphere() const { return sphere_; }
  /// Records of four per segment: mean unit normal, and how far the corners are out of the plane through the centre.
  const AlignedArray<S>& plane() const { return plane_; }
  std::size_t bytes() const;

 private:
  void collect(const Model<S>& model);
  void gather_slaves(std::size_t nodes);

  Surface topology_;
  std::vector<Segment> segments_;  ///< sorted by slot and face
  std::vector<Slave> slaves_;
  std::vector<std::int32_t> around_;        ///< segments around each slave, one after the other
  std::vector<std::int32_t> around_first_;  ///< per slave and one more: into around_
  AlignedArray<std::int32_t> corner_;       ///< of the segments, in tiles of W
  AlignedArray<S> sphere_, plane_;
  std::int32_t surface_elements_ = 0;
};

}  // namespace pinball
