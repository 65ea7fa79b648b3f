#pragma once

#include <cstdint>
#include <vector>

#include <solver/contact/segments/segment_surface.hpp>
#include <solver/contact/spheres/sphere_surface.hpp>

#include "feature_lists.hpp"
#include "feature_row.hpp"

namespace pinball {

/// Rigid spheres against faces, with their edges and nodes, and against each other: a sphere meets the nearest point of
/// each face that it may touch.
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
  std::size_t bytes() const { return rows_.capacity() * sizeof(rows_[0]); }

 private:
  using Sphere = typename SphereSurface<S>::Sphere;
  void add_face(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, const Sphere& sphere,
                std::int32_t segment, const StepReach& step);
  void add_sphere(const SurfaceSource<S>& source, const Sphere& first, const Sphere& second, const StepReach& step);
  void add(const SurfaceSource<S>& source, const FeatureRow& row, const StepReach& step);

  std::vector<FeatureRow> rows_;
};

}  // namespace pinball
