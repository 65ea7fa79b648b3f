#pragma once

#include <cstdint>
#include <vector>

#include <solver/contact/segments/segment_surface.hpp>

#include "nearest_on_face.hpp"
#include "sphere_lists.hpp"
#include "sphere_surface.hpp"

namespace pinball {

/// A sphere at the nearest point of a face.
struct FaceTouch {
  std::int32_t segment;
  double weight[4];        ///< of the segment's nodes [-]
  Vec3<double> direction;  ///< from the face to the sphere [-]
  double depth;            ///< > 0 [length]
};

/// Which faces a sphere touches, at which points: those where the surface has a least distance from the centre. On a
/// flat or bulging surface that is one, the same whether it lies inside a face, on an edge or at a node; in a valley
/// one on each side. The centre may have gone in, up to deepest_centre: then it is the nearest point of the surface,
/// and the sphere goes out by the way that it came. One of these for each thread, with memory for its work.
template <class S>
class NearFaces {
 public:
  /// number: of a sphere that takes part. The result is valid until the next call.
  const std::vector<FaceTouch>& find(const SurfaceSource<S>& source, const SegmentSurface<S>& surface,
                                     const SphereSurface<S>& spheres, const SphereLists<S>& lists, std::int64_t number);

 private:
  struct Candidate {
    std::int32_t segment, body;
    NearestOnFace<double> at;
  };
  void collect(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, const SphereSurface<S>& spheres,
               const SphereLists<S>& lists, std::int64_t number);
  bool is_least(const SegmentSurface<S>& surface, const Candidate& candidate) const;
  bool is_nearest_of_body(const Candidate& candidate) const;
  bool is_passed(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, const Candidate& candidate,
                 const Vec3<double>& centre) const;

  std::vector<Candidate> candidates_;
  std::vector<FaceTouch> touches_;
};

}  // namespace pinball
