#pragma once

#include <pinball/solver/mesh.hpp>
#include <pinball/solver/scene.hpp>

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

/// Calls the generator of the settings' type.
Mesh generate(const MeshSettings& settings);

/// Turns the mesh so that its z axis points along body.axis (if set), then moves it by body.position.
///
/// The rotation is the shortest one; from z to -z it turns about y. If the axis has no y component the rotation leaves
/// y coordinates as they are, bit by bit. Throws InputError if the axis has zero or non-finite length.
void place(Mesh& mesh, const Body& body);

}  // namespace pinball
