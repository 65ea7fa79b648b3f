#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <kernels/exec.hpp>

#include "near_faces.hpp"

namespace pinball {

/// What the springs between spheres and faces come to in a step.
struct SphereSums {
  double stored = 0;             ///< energy of the springs [energy]
  double damped = 0;             ///< power of the damping [power]
  double lost = 0;               ///< energy of springs that ended or jumped [energy]
  double penetration_ratio = 0;  ///< largest depth over the radius of the sphere and that of the element's ball [-]
  std::int32_t deepest = -1;     ///< node of that sphere
  std::int64_t pairs = 0;
};

/// Penalty contact of rigid spheres with the faces of elements: a spring from the nearest point of the surface
/// (NearFaces), so that no sphere is too small to be stopped. Stiffness and damping are those of pinballs (report
/// eqs. 3.8 and 3.11): p2 = beta/2 (B R of the element's ball + B R of the sphere), where B R of the elements goes over
/// from node to node.
///
/// As for pinballs a depth that approach does not explain stores no energy and gives no force. A sphere that rolls from
/// face to face takes along what it has.
template <class S>
class SphereSprings {
 public:
  SphereSprings(const ContactSettings& settings, const SurfaceSource<S>& source, SurfaceTopology topology);

  /// Whether there are spheres that meet faces with springs.
  static bool wanted(const ContactSettings& settings, const SurfaceSource<S>& source, const SurfaceTopology& topology);

  /// Returns the energy of springs that went with what eroded [energy].
  double remove_eroded(const std::vector<std::int64_t>& eroded);
  /// Whether what erosion has exposed is in the lists.
  bool complete() const { return surface_.complete(); }
  /// Builds the lists: see SphereLists.
  void build(const SurfaceSource<S>& source, const SurfaceMotion<S>& motion, const JoinedBodies& joined, S horizon);
  /// Nodes of all that is in the lists, some several times.
  std::vector<std::int32_t> listed_nodes() const;
  std::int64_t listed_pairs() const { return lists_.pairs(); }

  /// Which spheres touch, and with what forces. dt: the step just made.
  SphereSums compute(const SurfaceSource<S>& source, double dt);
  /// Adds the forces to the nodes, and to their fourth numbers what bounds the rows of the stiffness matrix.
  void add_forces(const SurfaceSource<S>& source) const;
  void add_node_forces(std::span<Point> node_force) const;
  std::size_t bytes() const;

 private:
  struct Touch {
    std::int32_t sphere;      ///< number
    std::int32_t slot, face;  ///< of the segment
    std::int32_t node[5];     ///< of the sphere, and of the segment
    double weight[5];         ///< 1, and those of the segment, negative [-]
    Vec3<double> direction;   ///< of the force on the sphere [-]
    double depth, elastic;    ///< elastic: the part of the depth that the spring has [length]
    double force, stiffness;  ///< [force], [force/length]
    double damped;            ///< power of the damping [power]
    double ratio;             ///< of the depth, see SphereSums [-]

    double stored() const { return 0.5 * stiffness * elastic * elastic; }
    bool is_of(const Touch& other) const { return slot == other.slot && face == other.face; }
    bool is_beside(const Touch& other) const;
  };
  struct Work {
    NearFaces<S> near;
    std::vector<Touch> touches, ended;
    double lost = 0;  ///< energy of springs that ended or jumped [energy]
  };
  void collect_stiffness(const SurfaceSource<S>& source);
  void compute_sphere(const SurfaceSource<S>& source, std::int32_t sphere, double dt, Work& work) const;
  double stiffness_at(std::int32_t slave) const;
  Touch touch_of(std::int32_t sphere, const FaceTouch& at) const;
  /// How much of the depth the spring has. before: the touch of the same face in the last step, or null.
  static void give_depth(Touch& touch, const Touch* before, double rate, double dt, Work& work);
  void give_force(const SurfaceSource<S>& source, Touch& touch, double rate) const;

  const ContactSettings settings_;
  SegmentSurface<S> surface_;
  SphereSurface<S> spheres_;
  std::vector<double> bulk_modulus_;  ///< per sphere [stress]
  std::vector<double> stiffness_;     ///< per segment: B R of its element [force/length]
  SphereLists<S> lists_;
  std::vector<Touch> touches_;  ///< of the last step, sphere after sphere
  std::array<Work, fixed_pieces> work_;
};

}  // namespace pinball
