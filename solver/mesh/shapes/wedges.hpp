#pragma once

#include <array>
#include <optional>
#include <span>

#include <kernels/tensor.hpp>
#include <solver/mesh/element_types.hpp>

/// Wedges, hexahedra of which two edges are collapsed, and which part of an element each of its nodes has.
namespace pinball {

/// A hexahedron that is collapsed to a wedge at any two of its edges, in the form of wedge(); nothing, where it is
/// none.
std::optional<Corners8> as_wedge(const Corners8& corners);

/// Of the mass of an element, and of all that goes by masses, at each of its eight corners; the sum is 1.
using CornerShares = std::array<double, 8>;

/// An eighth at each corner, which gives the nodes of tetrahedra a quarter; of wedges a sixth at the first corner that
/// a node has: what the lumped mass of the wedge's shape functions is, and not what its eight corners would have.
///
/// Pyramids have eighths, too, and so half of their mass at the apex, where that of their shape functions has a
/// quarter: it is known by its place alone, however they are listed, and the stable step of the kernels is that of
/// eighths.
CornerShares corner_shares(WorkedShape shape, const Corners8& corners);

/// A wedge in the form of wedge(), with those of its nodes third that make the line from there to the middle of the
/// other two of their triangles as normal to the line between these two as any can: the strains of assumed-strain
/// hourglass control are those along both. Where there is no difference, the third is that of the lowest number. So it
/// does not count in which order the nodes are listed. nodes: places of all [length].
Corners8 turned_wedge(const Corners8& wedge, std::span<const Point> nodes);

/// Of wedge_gradient_square (kernels/wedge.hpp) [length^4]; corners: in the form of wedge() [length].
Symmetric<double> square_of_wedge(const std::array<Point, 8>& corners);

}  // namespace pinball
