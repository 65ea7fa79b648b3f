#pragma once

#include <cstdint>
#include <vector>

#include <kernels/face_projection.hpp>
#include <solver/base/state_archive.hpp>
#include <solver/contact/algorithm/contact_algorithm.hpp>
#include <solver/contact/segments/segment_surface.hpp>

#include "slideline_search.hpp"

namespace pinball {

/// The algorithm that pinballs replaced (Belytschko and Lin, Computers and Structures 25, 95-104, 1987): slave nodes
/// against master segments, in both directions. Each slave node is projected onto the segments near it and keeps to the
/// one that it is nearest to; gap, normal and weights there give
///
///   penalty               a spring on the gap, of which each of the two passes has half;
///   projection, lagrange  a row of the contact matrix, solved as for pinballs (ImpulseSolver): projection is the
///                         momentum-conserving correction of velocities of the 1987 method.
///
/// The spring of a node has k = beta/4 (sum over its segments of K A^2/V / 4 + share x K A^2/V of the master): both
/// passes together resist with the mean stiffness of the elements that meet, and a flat contact under even pressure
/// gives each node its part. As for pinballs, a penetration that approach does not explain (erosion has exposed a face
/// deep inside another body) gives no force.
template <class S>
class SlidelineAlgorithm final : public ContactAlgorithm<S> {
 public:
  SlidelineAlgorithm(const ContactSettings& settings, const SurfaceSource<S>& source, InitialSurface start);

  void update_surface(const SurfaceSource<S>& source, const std::vector<std::int64_t>& eroded) override;
  void search(const SurfaceSource<S>& source, double dt) override;

  const char* name() const override { return "slideline"; }
  void add_node_forces(std::span<Point> node_force) const override;
  void put_radii(const SurfaceSource<S>& source, std::vector<double>& slot_radius) const override;
  const Surface& surface() const override { return surface_.topology(); }
  std::vector<std::int32_t> nodes() const override { return surface_.nodes(); }
  ListSize listed() const override {
    const std::int64_t entries = search_.entries();
    return {std::ssize(surface_.slaves()), entries, entries};
  }
  void persist(StateArchive& archive, const SurfaceSource<S>& source) override;
  std::size_t bytes() const override;
  std::int64_t updated_segments() const { return surface_.chosen(); }  ///< in every step

 private:
  ContactWork spring_forces(const SurfaceSource<S>& source, S dt) override;
  void add_spring_forces(const SurfaceSource<S>& source, ContactWork& work) override;
  const std::vector<std::int32_t>& nodes_of_springs() override;
  void collect_impulses(const SurfaceSource<S>& source, double dt) override;
  void add_pair_forces_of_springs(std::vector<Point>& sums) const override;

  /// What a slave node keeps from step to step.
  struct PairMemory {
    std::int32_t slot = -1, face = -1;  ///< of the segment that it touches; -1: none
    S xi{}, eta{};                      ///< of its foot
    Vec3<S> normal{};
    S offset{};   ///< part of the depth that stores no energy [length]
    S elastic{};  ///< depth less offset [length]
    S stored{};   ///< spring energy [energy]
    S damping{};  ///< part of the force that is not the spring's [force]
  };
  /// A slave node and its segment in this step.
  struct Touch {
    std::size_t slave;
    std::int32_t segment;
    FaceProjection<S> at;
    S force = 0;      ///< on the slave, along the normal [force]
    S stiffness = 0;  ///< [force/length]
  };
  PairOf pair_of(const Touch& touch) const;
  struct Sums {
    double stored = 0, damped = 0, lost = 0;
    S ratio = 0;
    std::int32_t deepest = -1;  ///< node of the largest ratio
    std::int64_t pairs = 0;
    void take_depth(S depth_ratio, std::int32_t node) {
      if (!(depth_ratio > ratio)) return;
      ratio = depth_ratio;
      deepest = node;
    }
  };

  /// The segment that a slave touches or, up to an open gap over the radius of the segment, may touch soon.
  bool find_segment(const SurfaceSource<S>& source, std::size_t slave, S open_gap, Touch& touch) const;
  /// Touches in the order of the slaves: those for which work(touch, sums), called in parallel, returns true.
  template <class Work>
  Sums find_touches(const SurfaceSource<S>& source, S open_gap, const Work& work);
  bool penalty_force(const SurfaceSource<S>& source, Touch& touch, S dt, Sums& sums);
  /// Ends the touches of slaves or segments that are no longer active; returns the energy of their springs.
  double end_inactive_touches();
  /// Numbers segments and slaves anew; the slaves keep their states.
  void collect_surface(const SurfaceSource<S>& source);

  SegmentSurface<S> surface_;
  SlidelineSearch<S> search_;
  std::vector<PairMemory> memory_;  ///< per slave
  std::vector<Touch> touches_;
  std::vector<std::int32_t> loaded_;  ///< see nodes_of_springs, only where that is asked
  S beta_, damping_;
  double lost_energy_ = 0;  ///< of springs that went with eroded elements in this step
};

}  // namespace pinball
