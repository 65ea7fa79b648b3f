#pragma once

#include <cstdint>

#include "pinball.hpp"

/// A contact constraint: one row of the contact matrix G, for enforcement by impulses (projection, Lagrange
/// multiplier).
///
///     u = sum_I w_I a . v_I                 closing velocity, positive when the gap closes
///     v_I <- v_I - p w_I a / m_I            effect of the impulse p >= 0 of the row
///
/// a: direction from body 2 to body 1; w_I: negative for the nodes of body 1, positive for those of body 2, each side
/// summing to 1, so that an impulse changes no momentum.
///
/// Here the gap of the report's balls, each the mean of its eight corners; that of faces and edges is their own
/// (face_projection.hpp, edge_pair.hpp).
namespace pinball {

struct ContactRow {
  std::int32_t corner1[8], corner2[8];  ///< places of the nodes among the corners of element 1 and element 2
  double weight1[8], weight2[8];        ///< both positive; the row has -weight1 and +weight2
  int nodes1 = 0, nodes2 = 0;           ///< used entries; 0: there is no contact
  Vec3<double> direction;               ///< a
  double depth = 0;                     ///< penetration, negative for an open gap [length]
};

/// Row of two balls, overlapping or not. d = C1 - C2; reach = R1 + R2; n1, n2: unit normals of both (zero allowed).
PINBALL_FUNCTION ContactRow pinball_row(const Vec3<double>& d, double reach, const Vec3<double>& n1,
                                        const Vec3<double>& n2) {
  ContactRow row;
  const PairDirection<double> pair = pair_direction(d, n1, n2);
  if (!pair.opposed) return row;
  const Vec3<double>& n = pair.direction;
  // (3.6) for either sign: n is so near the line of centres that it meets the ball.
  const double b = dot(n, d), c = dot(d, d) - reach * reach, root2 = b * b - c;
  if (!(root2 > 0)) return row;
  const double root = square_root(root2);
  row.depth = (0 - c) / (b + root);
  row.direction = (1.0 / root) * (d + row.depth * n);
  row.nodes1 = row.nodes2 = 8;
  for (int i = 0; i < 8; ++i) {
    row.corner1[i] = row.corner2[i] = i;
    row.weight1[i] = row.weight2[i] = 0.125;
  }
  return row;
}

}  // namespace pinball
