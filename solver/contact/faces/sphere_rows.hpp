#pragma once

#include <cstdint>
#include <vector>

#include <kernels/face_projection.hpp>
#include <solver/contact/segments/segment_surface.hpp>
#include <solver/contact/spheres/sphere_surface.hpp>

#include "feature_lists.hpp"
#include "feature_row.hpp"

namespace pinball {

/// Rigid spheres against faces, with their edges and nodes, and against each other: a sphere meets the nearest point of
/// each face that it may touch. The centre may have gone in through a face, which is the nearest one of its body then.
template <class S>
class SphereRows {
 public:
  using SpherePairs = typename FeatureLists<S>::SpherePairs;

  /// Finds the rows of all pairs listed. step: for what may close in it.
  void find(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, const SphereSurface<S>& spheres,
            const SpherePairs& pairs, const StepReach& step);
  void give_to(ImpulseSolver<S>& impulses) const {
    for (const FeatureRow& row : rows_) row.give_to(impulses);
  }
  std::size_t bytes() const {
    return rows_.capacity() * sizeof(rows_[0]) + meetings_.capacity() * sizeof(meetings_[0]);
  }

 private:
  using Sphere = typename SphereSurface<S>::Sphere;
  /// A face that a sphere may touch, and how the centre lies to it.
  struct Meeting {
    std::int32_t segment;
    FaceProjection<double> at;
    Vec3<double> to;  ///< from the nearest point to the centre [length]
    double distance;  ///< [length]
  };
  static Meeting meeting_of(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, const Sphere& sphere,
                            std::int32_t segment);
  void add_faces(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, const Sphere& sphere,
                 const StepReach& step);
  /// Whether the centre is behind a face because it has come in through it.
  bool has_come_through(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, const Sphere& sphere,
                        const Meeting& face) const;
  void add_sphere(const SurfaceSource<S>& source, const Sphere& first, const Sphere& second, const StepReach& step);
  void add(const SurfaceSource<S>& source, const FeatureRow& row, const StepReach& step);

  std::vector<FeatureRow> rows_;
  std::vector<Meeting> meetings_;  ///< of one sphere
};

}  // namespace pinball
