#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <solver/mesh.hpp>

/// Meshes of quadrilaterals in a plane, from which generators sweep hexahedra.
namespace pinball {

/// Shape of the core of discs, spheres and round-nosed rods. A scan of these numbers over slender and stout rods chose
/// them for the best corner Jacobians at little cost in the shortest edge.
inline constexpr double core_edge = 0.75;  ///< edges of the core over the arcs of the surface beside them
inline constexpr double core_bulge = 0.6;  ///< 0: the core's sides are straight, 1: they are part of circle or sphere

struct SectionMesh {
  std::vector<std::array<double, 2>> nodes;                 ///< coordinates [length]
  std::vector<std::array<std::int32_t, 4>> quadrilaterals;  ///< counterclockwise
};

/// O-grid of a disc of radius 1 about the origin: a core of counts[0] x counts[1] quadrilaterals with bulging sides,
/// and `ring` layers between it and the circle, whose columns have equal angles.
///
/// With cut[axis] only the half with that coordinate >= 0 is meshed; its nodes on the cut have 0 there exactly. Needs
/// counts >= 1 (even across a cut) and ring >= 1. A cut halves the number of quadrilaterals,
/// counts[0] counts[1] + 2 (counts[0] + counts[1]) ring.
SectionMesh disc_section(const std::array<int, 2>& counts, int ring, const std::array<bool, 2>& cut);

/// Turns a section in the plane of x >= 0 (first coordinate) and z (second) about the z axis, from y = 0 by `angle`
/// [degree]: one element around the angle, collapsed to a wedge where the section has an edge on the axis.
///
/// Cross sections are triangles instead of sectors, with sin(angle)/angle of their area.
Mesh turn_section(const SectionMesh& section, double angle);

/// Moves a section in the plane of x and y along z by `length` in `layers` layers of equal thickness.
Mesh extrude_section(const SectionMesh& section, double length, int layers);

}  // namespace pinball
