#pragma once

#include <array>

#include <solver/scene.hpp>

/// How well a precision holds an element where it lies.
namespace pinball {

/// Error of the volume of an element from rounding the places of its corners, over its volume, from above and to first
/// order [-]. The volume changes by B_iI with the place of corner I; a coordinate x is rounded by up to eps |x|/2.
///
///     error = sum_iI |B_iI| eps max_I |x_iI| / (2 V) ,      eps (|x| + |y| + |z|)/h for a cube of edge h.
///
/// Sums over I are taken from those of the squares, to which they are equal for boxes. Infinite where nothing is left
/// of the volume.
double relative_rounding(const std::array<Point, 8>& corners, Precision precision);

/// Up to what a mesh is taken. In `two_blocks` (h = 0.025, 20 m/s, 0.004 of the speed of waves), with both bodies moved
/// away and contact between faces, masses and the rebound were off by
///
///     double   error 1e-6   1e-5   1e-4   1e-3   1e-2            float   error 1e-5   1e-4   1e-3   1e-2
///     mass           2e-7   9e-8   5e-6   5e-5   1e-3            mass    nothing: it is made in double
///     rebound        1e-4   2e-3   0.014  0.027  through it      rebound 6e-4   0.017  0.12   0.02 (through it at
///     0.03)
///
/// A step moves nodes by less than is rounded, whatever the masses are. Double has room to be strict: 1e9 sizes of
/// an element from the origin. Single precision holds what scenes need: some thousand elements in a row.
inline double largest_rounding(Precision precision) { return precision == Precision::float32 ? 1e-3 : 1e-6; }

}  // namespace pinball
