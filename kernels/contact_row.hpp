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
/// Two kinds of gap. `pinball_row`: the report's balls, each the mean of its eight corners. `face_row`: the distance of
/// the two faces that look at each other, along their mean normal, at one common point; balls only find the pair. Flat
/// faces then touch where they are (balls reach 0.12 h out of them), and since the two forces of a pair have one line
/// of action where its faces are parallel, the angular momentum is kept there, too.
namespace pinball {

struct ContactRow {
  std::int32_t corner1[8], corner2[8];  ///< places of the nodes among the corners of element 1 and element 2
  double weight1[8], weight2[8];        ///< both positive; the row has -weight1 and +weight2
  int nodes1 = 0, nodes2 = 0;           ///< used entries; 0: there is no contact
  Vec3<double> direction;               ///< a
  double depth = 0;                     ///< penetration, negative for an open gap [length]
};

/// A face of an element at a point: centre, half edges, unit outward normal.
struct ContactFace {
  int face = -1;  ///< in the order of face_nodes; -1: none
  Vec3<double> centre, half_edge[2], normal;
  double size = 0;  ///< square root of its area [length]
};

/// The exposed face of an element (bits of `exposed`, in the order of face_nodes) that looks most towards a direction.
/// x: corners.
PINBALL_FUNCTION ContactFace face_towards(const Vec3<double> (&x)[8], unsigned exposed, const Vec3<double>& direction) {
  ContactFace best;
  double most = 0;
  for (int f = 0; f < 6; ++f) {
    if ((exposed >> f & 1U) == 0) continue;
    const int* at = face_nodes[f];
    const Vec3<double> area = 0.5 * cross(x[at[2]] - x[at[0]], x[at[3]] - x[at[1]]);
    const double size2 = square_root(dot(area, area));
    const double towards = dot(area, direction) / (size2 > 0 ? size2 : 1.0);
    if (!(towards > most)) continue;
    most = towards;
    best.face = f;
    best.size = square_root(size2);
    best.normal = (1.0 / size2) * area;
  }
  if (best.face < 0) return best;
  const int* at = face_nodes[best.face];
  best.centre = 0.25 * (x[at[0]] + x[at[1]] + x[at[2]] + x[at[3]]);
  best.half_edge[0] = 0.25 * (x[at[1]] + x[at[2]] - x[at[0]] - x[at[3]]);
  best.half_edge[1] = 0.25 * (x[at[2]] + x[at[3]] - x[at[0]] - x[at[1]]);
  return best;
}

/// Bilinear weights of the four nodes of a face at a point, which is first projected onto the plane of its half edges.
/// Returns false where the point lies outside, with a margin: each point of a face is near the middle between its own
/// centre and that of a partner of like size, so that pairs that only meet beyond it are met by other pairs.
PINBALL_FUNCTION bool face_weights(const ContactFace& face, const Vec3<double>& point, double (&weight)[8]) {
  constexpr double inside = 0.9;
  const Vec3<double>&a = face.half_edge[0], &b = face.half_edge[1], r = point - face.centre;
  const double aa = dot(a, a), ab = dot(a, b), bb = dot(b, b), ra = dot(r, a), rb = dot(r, b);
  const double determinant = aa * bb - ab * ab;
  if (!(determinant > 0)) return false;
  const double xi = (ra * bb - rb * ab) / determinant, eta = (rb * aa - ra * ab) / determinant;
  if (absolute(xi) > inside || absolute(eta) > inside) return false;
  weight[0] = 0.25 * (1 - xi) * (1 - eta);
  weight[1] = 0.25 * (1 + xi) * (1 - eta);
  weight[2] = 0.25 * (1 + xi) * (1 + eta);
  weight[3] = 0.25 * (1 - xi) * (1 + eta);
  return true;
}

/// Row of two faces; without nodes where they do not face each other within 60 degrees or meet outside of each other.
PINBALL_FUNCTION ContactRow face_row(const ContactFace& face1, const ContactFace& face2) {
  ContactRow row;
  if (face1.face < 0 || face2.face < 0 || dot(face1.normal, face2.normal) > -0.5) return row;
  const Vec3<double> mean = face2.normal - face1.normal;
  row.direction = (1.0 / square_root(dot(mean, mean))) * mean;
  // The common point, nearer to the centre of the smaller face.
  const Vec3<double> point = face1.centre + (face1.size / (face1.size + face2.size)) * (face2.centre - face1.centre);
  if (!face_weights(face1, point, row.weight1) || !face_weights(face2, point, row.weight2)) return row;
  row.nodes1 = row.nodes2 = 4;
  row.depth = dot(face2.centre - face1.centre, row.direction);
  for (int i = 0; i < 4; ++i) {
    row.corner1[i] = face_nodes[face1.face][i];
    row.corner2[i] = face_nodes[face2.face][i];
  }
  return row;
}

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
