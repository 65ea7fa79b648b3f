#pragma once

#include <optional>

#include <solver/mesh.hpp>
#include <solver/mesh_settings.hpp>

namespace pinball {

/// Regular block with one corner at the origin, size[0] x size[1] x size[2], nodes numbered along x first, then y, z.
/// Throws InputError if a size is not positive and finite, a count is below 1, or the mesh exceeds 2^31 - 1 nodes.
Mesh generate_block(const BlockMesh& settings);

/// Rod with a hemispherical nose, of hexahedra only: tip at the origin, flat rear end at z = -length.
///
/// With p x q = core, b = ring and n = layers, the half rod (y >= 0) has n (p q + (p + 2 q) b) + p q b elements:
/// an O-grid section (core block and ring) swept along the axis, closed over the core's end by b layers of the ring.
/// The full rod is the half rod and its mirror image in y = 0. Nodes of the outer surface lie on the cylinder or the
/// hemisphere, so that the mesh has a little less volume than the rod; nodes of the cut have y = 0 exactly.
/// Throws InputError if radius is not positive, length < radius, a count is below 1, or there are too many nodes.
Mesh generate_round_nosed_rod(const RoundNosedRodMesh& settings);

/// Cylinder along z from the origin.
///
/// With c = core, b = ring and n = layers the full one has n (c^2 + 4 c b) elements (an O-grid section swept along z),
/// half and quarter (y >= 0; x >= 0 and y >= 0) a half and a quarter of them. The wedge has n radial elements, from
/// y = 0 to the angle, one around it, those at the axis collapsed. Nodes of the outer surface lie on the cylinder, so
/// that the mesh has less volume: by 0.41/c^2 of it, as 4 c chords have; a wedge has sin(angle)/angle of its volume.
/// Throws InputError if a length is not positive, a count is below 1 or, where a cut divides it, not even, the angle is
/// not within 0 ... largest_wedge_angle, or there are too many nodes.
Mesh generate_cylinder(const CylinderMesh& settings);

/// Sphere about the origin; the lower pole, at z = -radius, is where grading makes the elements small.
///
/// With c = core and b = ring the full one has c^3 + 6 c^2 b elements (a core and six blocks around it), half and
/// quarter (y >= 0; x >= 0 and y >= 0) a half and a quarter of them. The wedge, with core = [p, q], has
/// p q + (2 p + q) b elements, from y = 0 to the angle, one around it, those at the axis collapsed. Nodes of the outer
/// surface lie on the sphere, so that the mesh has less volume, by a part that falls with the square of the element
/// size; a wedge tends to sin(angle)/angle of its volume. Throws InputError as generate_cylinder does, and for a
/// grading that is not within 0 ... 1.
Mesh generate_sphere(const SphereMesh& settings);

/// Calls the generator of the settings' type, or copies the host's arrays. Throws std::logic_error for a mesh from a
/// file, which is read (formats/mesh_reader.hpp).
Mesh generate(const MeshSettings& settings);

/// Turns the mesh so that its z axis points along the axis (if there is one), then moves it by the position.
///
/// The rotation is the shortest one; from z to -z it turns about y. If the axis has no y component the rotation leaves
/// y coordinates as they are, bit by bit. Throws InputError if the axis has zero or non-finite length.
void place(Mesh& mesh, const std::optional<Point>& axis, const Point& position);

}  // namespace pinball
