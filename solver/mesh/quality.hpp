#pragma once

#include <cstdint>

#include <solver/mesh.hpp>

namespace pinball {

/// Geometry of a mesh at a glance. Lengths and volume in the mesh's length unit. Edges that are collapsed to one node
/// do not count; at the edge of a wedge the Jacobian is the sine of its angle.
struct MeshQuality {
  double min_scaled_jacobian = 0.0;   ///< smallest over all corners of det(e1, e2, e3) / (|e1| |e2| |e3|); 1 is a box
  double mean_scaled_jacobian = 0.0;  ///< mean over the elements of their worst corner
  double min_edge = 0.0;              ///< shortest edge of all elements [length]
  double max_edge = 0.0;              ///< longest edge of all elements [length]
  double max_aspect_ratio = 0.0;      ///< largest of (longest / shortest edge) within an element
  double volume = 0.0;                ///< sum of the elements' exact trilinear volumes [length^3]
  std::int64_t inverted = 0;          ///< elements with a corner whose Jacobian is not positive
};

/// All zero for a mesh without elements.
MeshQuality measure_quality(const Mesh& mesh);

/// Exact volume of the trilinear hexahedron with these corners by Gauss quadrature, negative if it is turned inside out
/// [length^3]. Masses are made of it: they owe nothing to the closed form of the kernels (hexahedron_of_points.hpp),
/// from which it differs by round-off.
double volume_by_quadrature(const std::array<Point, 8>& corners);

}  // namespace pinball
