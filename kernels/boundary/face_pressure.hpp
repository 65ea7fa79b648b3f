#pragma once

#include "node_arrays.hpp"

/// Pressure on faces of elements, against their outward normals.
///
/// A face is bilinear, x = x_0 + b xi + c eta + d xi eta, and the force on its corner i that of the uniform pressure
/// with the same weight N_i:
///
///     f_i = -p  int N_i dx/dxi x dx/deta = -p [ b x c + (xi_i/3) b x d + (eta_i/3) d x c ] ,
///
/// a quarter of the area vector each where d = 0 (a parallelogram). Forces and moments of a closed surface are zero
/// with any shape of its faces; with a quarter of the area on every corner the moments would not be.
///
/// Forces of faces come first, and then the sums of nodes, each in the order of the faces: no two threads write to one
/// node, and each sum has one order.
namespace pinball {

template <class S>
PINBALL_FUNCTION void cross_product(const S* a, const S* b, S* product) {
  product[0] = a[1] * b[2] - a[2] * b[1];
  product[1] = a[2] * b[0] - a[0] * b[2];
  product[2] = a[0] * b[1] - a[1] * b[0];
}

/// The forces on the four corners of a face, three numbers each. position: records of four; corners: nodes,
/// counterclockwise seen from outside.
template <class S>
PINBALL_FUNCTION void pressure_on_corners(const S* position, const std::int32_t* corners, S pressure, S* force) {
  const S *const x_0 = position + 4 * std::int64_t(corners[0]), *const x_1 = position + 4 * std::int64_t(corners[1]),
                 *const x_2 = position + 4 * std::int64_t(corners[2]),
                 *const x_3 = position + 4 * std::int64_t(corners[3]);
  S b[3], c[3], d[3];
  for (int k = 0; k < 3; ++k) {  // from differences: far from the origin sums would round
    const S to_1 = x_1[k] - x_0[k], to_2 = x_2[k] - x_0[k], to_3 = x_3[k] - x_0[k];
    b[k] = S(0.25) * (to_1 + to_2 - to_3);
    c[k] = S(0.25) * (to_2 + to_3 - to_1);
    d[k] = S(0.25) * (to_2 - to_1 - to_3);
  }
  S bc[3], bd[3], dc[3];
  cross_product(b, c, bc);
  cross_product(b, d, bd);
  cross_product(d, c, dc);
  PINBALL_UNROLL
  for (int i = 0; i < 4; ++i) {
    const S xi = i == 0 || i == 3 ? S(-1) : S(1), eta = i < 2 ? S(-1) : S(1);
    for (int k = 0; k < 3; ++k) {
      const S skew = xi * bd[k] + eta * dc[k];
      force[3 * i + k] = -pressure * (bc[k] + skew / S(3));
    }
  }
}

/// Forces on the corners of each face; zero where its element is eroded.
template <class S>
struct PressFaces {
  NodeArrays<S> nodes;
  const std::int64_t* element;  ///< per face, its place
  const std::int32_t* corners;  ///< four per face
  S pressure;                   ///< [stress]
  S* corner_force;              ///< 4 x 3 per face [force]

  PINBALL_FUNCTION void operator()(std::int64_t face) const {
    S* const force = corner_force + 12 * face;
    if (nodes.has_element(element[face])) {
      pressure_on_corners(nodes.position, corners + 4 * face, pressure, force);
      return;
    }
    for (int c = 0; c < 12; ++c) force[c] = S(0);
  }
};

/// What faces exert on their nodes: a list of forces (node_arrays.hpp), which GatherPressure makes.
template <class S>
struct PressureForce {
  const std::int32_t* nodes;
  const S* force;  ///< three numbers per node [force]

  PINBALL_FUNCTION std::int64_t node(std::int64_t i) const { return nodes[i]; }
  PINBALL_FUNCTION void find(const NodeArrays<S>& /*of*/, std::int64_t i, S* sum) const {
    for (int k = 0; k < 3; ++k) sum[k] = force[3 * i + k];
  }
};

/// Sums of the nodes, added to their forces and kept.
template <class S>
struct GatherPressure {
  NodeArrays<S> nodes;
  const std::int32_t* node;    ///< those of the faces
  const std::int32_t* first;   ///< per node and one more: its part of `places`
  const std::int32_t* places;  ///< numbers of corners, four per face
  const S* corner_force;       ///< three numbers per corner [force]
  S* force;                    ///< three numbers per node [force]

  PINBALL_FUNCTION void operator()(std::int64_t n) const {
    S sum[3] = {S(0), S(0), S(0)};
    for (std::int32_t i = first[n]; i < first[n + 1]; ++i) {
      for (int k = 0; k < 3; ++k) sum[k] += corner_force[3 * std::int64_t(places[i]) + k];
    }
    for (int k = 0; k < 3; ++k) force[3 * n + k] = sum[k];
    add_to_force(nodes, node[n], sum);
  }
};

}  // namespace pinball
